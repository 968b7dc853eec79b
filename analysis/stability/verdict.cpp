#include "analysis/stability/verdict.h"

#include <algorithm>

#include "analysis/stability/critical_gain.h"
#include "analysis/stability/crossings.h"
#include "analysis/stability/spectrum.h"
#include "analysis/stability/steady.h"

namespace stickslip {
namespace {

/// −f_ss'(V_0) where that is positive: the least gain of (21), to be exceeded.
double least_velocity_gain(double slope)
{
    return std::max(0.0, -slope);
}

/// (21): k_v > −f_ss'(V_0) and k_p > 0.
bool velocity_only_stable(const LinearMass& mass, double slope)
{
    return mass.k_v > -slope && mass.k_p > 0;
}

/// A critical gain above which all gains are stable, and below which none is.
bool has_single_gain(const std::vector<Crossing>& crossings, const std::vector<Interval>& stable)
{
    return crossings.size() == 1 && stable.size() == 1 && stable[0].low > 0 && stable[0].high == infinity;
}

Region region_of(bool velocity_only, bool memory)
{
    if (memory) return velocity_only ? Region::stable : Region::memory_only;
    return velocity_only ? Region::velocity_only : Region::unstable;
}

}  // namespace

LinearMass linear_mass(const Joint& joint, double V)
{
    // friction that grows with the transmitted effort carries a share μ of the loop's force away
    const double share = 1 - joint.friction.load_coefficient;
    return {joint.mechanism.inertia, share * joint.control.k_v, share * joint.control.k_p,
            linearise(joint.friction, V)};
}

LinearVerdict linear_verdict(const Joint& joint)
{
    LinearVerdict verdict;
    verdict.steady = steady_sliding(joint);
    if (verdict.steady.reason != Reason::none) return verdict;
    const auto mass = linear_mass(joint, verdict.steady.velocity);
    if (!mass.friction.rational()) {
        verdict.steady.reason = Reason::unsupported;
        return verdict;
    }

    auto& simple = verdict.velocity_only;
    simple.slope = steady_slope(mass.friction);
    simple.k_v_min = least_velocity_gain(simple.slope);
    simple.stable = velocity_only_stable(mass, simple.slope);

    auto& memory = verdict.state_variable;
    memory.f_v = mass.friction.f_v;
    memory.kernel_integral = kernel_integral(mass.friction);
    memory.eigenvalues = spectrum(mass);
    memory.spectral_abscissa = spectral_abscissa(mass);
    if (std::isnan(memory.spectral_abscissa)) {
        verdict.steady.reason = Reason::not_finite;
        return verdict;
    }
    memory.stable = memory.spectral_abscissa < 0;
    memory.crossings = crossings(mass);
    memory.stable_intervals = stable_intervals(mass, memory.crossings);
    if (has_single_gain(memory.crossings, memory.stable_intervals)) memory.k_cr = memory.crossings[0].k_p;
    return verdict;
}

PointResult linear_point(const Joint& joint)
{
    PointResult point;
    const auto steady = steady_sliding(joint);
    point.reason = steady.reason;
    if (steady.reason != Reason::none) return point;
    const auto mass = linear_mass(joint, steady.velocity);
    if (!mass.friction.rational()) {
        point.reason = Reason::unsupported;
        return point;
    }
    const double slope = steady_slope(mass.friction);
    point.spectral_abscissa = spectral_abscissa(mass);
    if (std::isnan(point.spectral_abscissa) || !std::isfinite(slope)) {
        point.reason = Reason::not_finite;
        return point;
    }
    point.k_v_min = least_velocity_gain(slope);
    point.velocity_only_stable = velocity_only_stable(mass, slope);
    point.state_variable_stable = point.spectral_abscissa < 0;
    point.region = region_of(point.velocity_only_stable, point.state_variable_stable);
    if (mass.friction.states <= 1) {
        if (const auto critical = critical_gain(mass.inertia, mass.k_v, mass.friction)) {
            point.k_cr = critical->k_p;
            point.omega = critical->omega;
        }
    } else if (const auto all = crossings(mass); has_single_gain(all, stable_intervals(mass, all))) {
        point.k_cr = all[0].k_p;
        point.omega = all[0].omega;
    }
    return point;
}

}  // namespace stickslip
