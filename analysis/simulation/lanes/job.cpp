// One joint and the job that it is in the lanes: groups, starts, and the row that an answer fills.
#include "analysis/simulation/lanes/job.h"

#include <algorithm>
#include <cmath>

#include "analysis/numerics/polynomial.h"
#include "analysis/simulation/attractor/large_disturbance.h"
#include "analysis/simulation/lanes/batch.h"
#include "analysis/simulation/lanes/grouping.h"
#include "analysis/stability/steady.h"

namespace stickslip::lanes {

std::optional<Scaled> scaled(const Joint& joint)
{
    const auto [law, kind] = one_state(joint.friction);
    if (!law || !single(joint) || !plain(joint.friction, joint.load)) return {};
    const auto sliding = steady_sliding(joint);
    if (sliding.reason != Reason::none) return {};
    const double A = joint.friction.normal_load * law->A, L = law->L[0], V0 = sliding.slides_at;
    const auto& control = joint.control;
    Scaled s{{rounded(control.k_p * L / A), rounded(joint.mechanism.inertia * V0 * V0 / (L * A)),
              rounded(law->B[0] / law->A), rounded(control.k_v * V0 / A), kind},
             L,
             V0,
             sliding.deflection};
    const auto& g = s.groups;
    const bool in_range =
        g.K > 0 && g.M > 1e-12 && g.M < 1e6 && g.K < 1e9 && g.c >= 0 && g.c < 1e6 && g.beta > 0 && g.beta < 1e3;
    if (!in_range) return {};
    return s;
}

bool covers(const NonlinearOptions& options)
{
    const bool plain_small = options.disturbance.kind == DisturbanceKind::position;
    const bool disturbance = is_set(options.disturbance.size) || plain_small;
    return disturbance && options.accelerate && !options.bifurcation && !options.fallback_only && options.rtol > 1e-12;
}

namespace {

constexpr double kick = 1.0;  ///< size of p or K X to which a growing disturbance is lifted
constexpr double far = 100;   ///< of w: beyond, the reference decides

/// Along the slow mode with V = V_0 and falling, where a turn begins; an aperiodic mode has no such instant.
void lift(std::complex<double> s, Job& job)
{
    using Complex = std::complex<double>;
    const bool turns = s.imag() > 0;
    const Complex w = turns ? Complex(0, 1) : Complex(1);
    const double X = (w / s).real(), p = (-job.groups.beta * w / (s + 1.0)).real();
    const double size = kick / std::max({std::abs(w.real()), std::abs(job.groups.K * X), std::abs(p)});
    job.start[0] = size * X, job.start[1] = size * w.real(), job.start[2] = size * p;
}

}  // namespace

Job job(const Groups& g, bool search)
{
    using Complex = std::complex<double>;
    Job job{};
    job.groups = g;
    const auto roots = cubic_roots((g.c + 1) / g.M + 1, (g.K + g.c + 1 - g.beta) / g.M, g.K / g.M);
    Complex s = roots[0];
    for (const auto& root : roots)
        if (root.real() > s.real()) s = root;
    job.rate = s.real();
    job.frequency = std::abs(s.imag());
    lift({job.rate, job.frequency}, job);
    job.search = search;
    const double w = std::log(near_rest_start), p = -g.beta * w;
    job.rest_start[0] = -(w + p + g.c * std::expm1(w)) / g.K, job.rest_start[1] = w, job.rest_start[2] = p;
    return job;
}

bool state(const Disturbance& d, const Joint& joint, const Scaled& scale, Job& job)
{
    const auto& g = job.groups;
    const double A = joint.friction.normal_load * one_state(joint.friction).law->A;
    double X = 0, w = 0, p = 0;
    switch (d.kind) {
        case DisturbanceKind::position:
            X = d.size / scale.length, p = -g.K * X;
            break;
        case DisturbanceKind::velocity:
            w = std::log1p(d.size / scale.velocity), p = -g.c * std::expm1(w) - w;
            break;
        case DisturbanceKind::impulse:
            w = std::log1p(d.size / (joint.mechanism.inertia * scale.velocity));
            break;
        case DisturbanceKind::offset:
            X = d.size / scale.length;
            break;
        case DisturbanceKind::state:
            p = d.size / A;
            break;
        case DisturbanceKind::start:
            w = std::log(std::max(d.size, 1e-12)), p = -g.beta * w;
            X = -(w + p + g.c * std::expm1(w)) / g.K;
            break;
    }
    job.stated = true;
    job.start[0] = rounded(X), job.start[1] = rounded(w), job.start[2] = rounded(p);
    const bool moves = X != 0 || w != 0 || p != 0;
    return moves && std::abs(w) < far && std::isfinite(X) && std::isfinite(p);
}

bool write(const Answer& a, const Scaled& s, const Job& job, PointResult& point)
{
    point.growth_rate = job.rate * s.velocity / s.length;
    if (a.ending == Ending::left_over) return false;
    point.path = DecisionPath::lanes;
    const double per_deflection = s.length / std::abs(s.deflection);
    const double small_peak = small_disturbance / std::hypot(job.rate, job.frequency);
    point.overshoot = std::max(0.0, job.stated ? a.peak : small_peak) * per_deflection;
    point.outcome = !a.reached ? Outcome::stable_sliding : a.rest_time > 0 ? Outcome::stick_slip : Outcome::limit_cycle;
    if (a.ending == Ending::bistable) point.region = Region::bistable;
    if (a.ending == Ending::decays) return true;
    point.amplitude = 0.5 * (a.x_max - a.x_min) * s.length;
    point.velocity_min = s.velocity * std::exp(a.w_min);
    point.velocity_max = s.velocity * std::exp(a.w_max);
    point.period = a.period * s.length / s.velocity;
    point.stick_fraction = a.rest_time / a.period;
    if (a.reached) point.overshoot = std::max({0.0, a.x_max, a.peak}) * per_deflection;  // a small one has no peak
    return true;
}

}  // namespace stickslip::lanes
