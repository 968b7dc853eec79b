// Random joints decided twice: by the rows of a sweep, that is by the lanes, and by CVODE at rtol 1e-11. Growth rates
// are measured by CVODE at 1e-13, as near the boundary a turn changes the disturbance by parts in 10⁵ only.
#pragma once
#include <cmath>
#include <random>
#include <span>
#include <vector>

#include "analysis/simulation/lanes/batch.h"
#include "analysis/simulation/points.h"
#include "analysis/stability/verdict.h"
#include "tests/analysis/simulation/joints.h"
#include "tests/analysis/simulation/lanes/cvode_groups.h"

namespace stickslip {

/// Joints over the ranges of design: V_0, A, L and m over two to four decades, gains a decade around the critical one,
/// k_v V_0 up to 1.3 (B − A).
inline std::vector<Joint> random_joints(std::size_t count, unsigned seed)
{
    std::mt19937_64 random(seed);
    const auto uniform = [&](double a, double b) {
        return a + (b - a) * std::ldexp(static_cast<double>(random() >> 11), -53);
    };
    std::vector<Joint> joints;
    while (joints.size() < count) {
        const double V0 = std::pow(10, uniform(-6, -2)), beta = uniform(1.05, 3), c = uniform(0, 1.3) * (beta - 1);
        const double L = std::pow(10, uniform(-6, -4)), A = std::pow(10, uniform(-1, 1)),
                     m = std::pow(10, uniform(-1, 1));
        const double M = m * V0 * V0 / (L * A);
        const double K_cr = c < beta - 1 ? (beta - 1 - c) * (1 + M / (1 + c)) : beta - 1;
        const double K = K_cr * std::pow(10, uniform(-1, 1));
        Joint joint = example_joint(K * A / L, c * A / V0, V0);
        joint.mechanism.inertia = m;
        auto& law = std::get<RateAndState>(joint.friction.law);
        law.A = A, law.B[0] = beta * A, law.L[0] = L;
        joints.push_back(joint);
    }
    return joints;
}

/// The same joints under the ageing law.
inline std::vector<Joint> random_ageing_joints(std::size_t count, unsigned seed)
{
    auto joints = random_joints(count, seed);
    for (auto& joint : joints) joint = with_ageing(joint);
    return joints;
}

/// Stribeck joints: V_0 from a thirtieth of c3 to six of them, both exponents that lanes have, two thirds of them
/// without k_v, so that half slide steadily and some stick beside steady sliding.
inline std::vector<Joint> random_stribeck_joints(std::size_t count, unsigned seed)
{
    std::mt19937_64 random(seed);
    const auto uniform = [&](double a, double b) {
        return a + (b - a) * std::ldexp(static_cast<double>(random() >> 11), -53);
    };
    std::vector<Joint> joints;
    while (joints.size() < count) {
        Stribeck law;
        law.c3 = std::pow(10, uniform(-4, -1));
        law.c2 = std::pow(10, uniform(-1, 1.5));
        law.c0 = std::pow(10, uniform(0, 2));
        law.c1 = 0.3 * law.c2 / law.c3 * std::pow(10, uniform(-2, 0.5));
        law.c4 = random() % 2 == 0 ? 1 : 2;
        const double m = std::pow(10, uniform(-1, 1)), V0 = law.c3 * std::pow(10, uniform(-1.5, 0.8));
        const double k_v = random() % 3 == 0 ? uniform(0, 0.75) * law.c2 / law.c3 : 0;
        Joint joint = stribeck_joint(m * std::pow(10, uniform(1, 5)), k_v, V0);
        joint.mechanism.inertia = m;
        joint.friction.law = law;
        joints.push_back(joint);
    }
    return joints;
}

/// One joint, both answers, and how far they are apart where both have a number (relative; 0 elsewhere).
struct Compared {
    PointResult row;
    NonlinearVerdict truth;
    double true_growth = missing;  ///< 1/s, by CVODE counting from steady sliding
    double growth = 0, period = 0, amplitude = 0, overshoot = 0;
    double rest = 0;                              ///< difference of the shares of the period at rest
    double row_spectrum = 0, truth_spectrum = 0;  ///< growth rates of lanes and truth against the spectral abscissa
    double left_over_spectrum = 0;                ///< the same of rows that lanes leave to the reference
    double path_spectrum = 0;  ///< the same of the product's CVODE path, which works in SI and carries whole forces

    bool same_outcome() const
    {
        const bool bistable = row.region == Region::bistable;
        return row.outcome == truth.outcome && bistable == (truth.region == NonlinearRegion::bistable);
    }
    bool undecided() const { return row.outcome == Outcome::undecided || row.outcome == Outcome::solver_failure; }
};

inline double growth_by_cvode(const Joint& joint)
{
    constexpr double rtol = 1e-13;
    const auto* slip = std::get_if<RateAndState>(&joint.friction.law);
    if (!slip || slip->states() != 1) return missing;  // their spectra are closed forms or polynomials
    const auto& law = *slip;
    const double A = law.A, L = law.L[0], V0 = joint.control.V0;
    const lanes::Groups groups{joint.control.k_p * L / A, joint.mechanism.inertia * V0 * V0 / (L * A), law.B[0] / A,
                               joint.control.k_v * V0 / A};
    return cvode_growth(groups, rtol) * V0 / L;
}

inline double relative_error(double a, double b)
{
    return std::isnan(a) || std::isnan(b) ? 0 : std::abs(a - b) / std::abs(b);
}

/// `region` asks for the search for a coexisting cycle, too; `effort` is that of CVODE.
inline std::vector<Compared> compare_with_cvode(std::span<const Joint> joints, bool region,
                                                const Disturbance& disturbance = {}, double effort = 1)
{
    NonlinearOptions options, strict;
    options.region = strict.region = region;
    options.disturbance = strict.disturbance = disturbance;
    strict.rtol = 1e-11, strict.effort = effort;
    std::vector<PointResult> rows(joints.size());
    nonlinear_points(joints, options, rows);
    std::vector<Compared> compared;
    for (std::size_t i = 0; i < joints.size(); ++i) {
        Compared c{rows[i], nonlinear_verdict(joints[i], strict)};
        c.true_growth = growth_by_cvode(joints[i]);
        c.growth = relative_error(c.row.growth_rate, c.true_growth);
        const double abscissa = linear_point(joints[i]).spectral_abscissa;
        const bool by_lanes = c.row.path == DecisionPath::lanes;
        (by_lanes ? c.row_spectrum : c.left_over_spectrum) = relative_error(c.row.growth_rate, abscissa);
        c.truth_spectrum = relative_error(c.true_growth, abscissa);
        c.path_spectrum = relative_error(c.truth.growth_rate, abscissa);
        c.period = relative_error(c.row.period, c.truth.period);
        c.rest = std::isnan(c.row.period) ? 0 : std::abs(c.row.stick_fraction - c.truth.stick_fraction);
        const double swing = std::log(c.row.velocity_max / c.row.velocity_min);
        c.overshoot = std::abs(c.row.overshoot - c.truth.overshoot) / (1e-12 + c.truth.overshoot);
        c.amplitude = std::max(relative_error(c.row.amplitude, c.truth.amplitude),
                               relative_error(swing, std::log(c.truth.velocity_max / c.truth.velocity_min)));
        compared.push_back(c);
    }
    return compared;
}

}  // namespace stickslip
