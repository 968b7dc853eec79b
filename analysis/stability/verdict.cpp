#include "analysis/stability/verdict.h"

#include <algorithm>

#include "analysis/joint/gains.h"
#include "analysis/stability/critical_gain.h"
#include "analysis/stability/effort_limits.h"
#include "analysis/stability/joint_crossings.h"
#include "analysis/stability/joint_spectrum.h"
#include "analysis/stability/neutral.h"
#include "analysis/stability/real_loop.h"
#include "analysis/stability/spectrum.h"
#include "analysis/stability/stable_gains.h"
#include "analysis/stability/steady.h"
#include "analysis/stability/verdict_parts.h"

namespace stickslip {
namespace {

/// −f_ss'(V_0) where that is positive: the least gain of (21), to be exceeded. 0 where it would be a gain that rounding
/// swallows.
double least_velocity_gain(const LinearMass& mass)
{
    return std::max(0.0, -velocity_only_damping(mass, 0));
}

double least(const std::vector<Interval>& gains)
{
    return gains.empty() ? missing : gains.front().low;
}

/// (21): k_v > −f_ss'(V_0) and k_p > 0; what equals its limit is neutral.
std::uint8_t velocity_only_code(const LinearMass& mass)
{
    const double C = velocity_only_damping(mass, mass.k_v);
    if (C < 0 || mass.k_p < 0) return 0;
    return C > 0 && mass.k_p > 0 ? 1 : verdict_neutral;
}

/// The same for any joint, with the spectrum only where Routh's scheme does not say yes.
std::uint8_t velocity_only_code(const LinearJoint& linear)
{
    const auto curve = velocity_only(linear);
    if (is_stable(curve)) return 1;
    return spectral_abscissa(curve) == 0 ? verdict_neutral : 0;
}

/// The verdict that a spectral abscissa means.
std::uint8_t code_of(double abscissa)
{
    return abscissa < 0 ? 1 : abscissa == 0 ? verdict_neutral : 0;
}

Region region_of(std::uint8_t velocity_only, std::uint8_t memory)
{
    if (memory == verdict_neutral) return Region::neutral;
    if (memory == 1) return velocity_only == 1 ? Region::stable : Region::memory_only;
    return velocity_only == 1 ? Region::velocity_only : Region::unstable;
}

/// Any other joint, with the means of linear_joint.h.
LinearVerdict joint_verdict(const Joint& joint, LinearVerdict verdict)
{
    const auto linear = linear_joint(joint, verdict.steady.slides_at);
    auto& simple = verdict.velocity_only;
    auto& memory = verdict.state_variable;
    add_frictions(linear, verdict);
    simple.stable_k_v = velocity_only_gains(linear);
    simple.k_v_min = least(simple.stable_k_v);
    const auto simply = velocity_only_code(linear);
    simple.stable = simply == 1;
    simple.neutral = simply == verdict_neutral;
    memory.eigenvalues = spectrum(linear);
    memory.all_eigenvalues = linear.rational();
    if (!take_abscissa(verdict, spectral_abscissa(linear))) return verdict;
    take_gains(memory, stable_gains(joint));
    return verdict;
}

void take_gains(PointResult& point, const StableGains& gains)
{
    point.k_cr = gains.k_cr;
    point.omega = gains.omega;
}

PointResult joint_point(const Joint& joint, double V)
{
    PointResult point;
    const auto linear = linear_joint(joint, V);
    point.spectral_abscissa = spectral_abscissa(linear);
    if (!std::isfinite(point.spectral_abscissa)) {
        point.reason = Reason::not_finite;
        return point;
    }
    point.k_v_min = least(velocity_only_gains(linear));
    point.velocity_only_stable = velocity_only_code(linear);
    point.state_variable_stable = code_of(point.spectral_abscissa);
    point.region = region_of(point.velocity_only_stable, point.state_variable_stable);
    take_gains(point, stable_gains(joint));
    return point;
}

}  // namespace

bool is_plain_mass(const Joint& joint)
{
    return joint.mechanism.model == Model::single_mass && joint.control.force_gain == 0 &&
           joint.control.contact_stiffness == 0 && !joint.normal.moves() && joint.neighbour.size == 0;
}

LinearMass linear_mass(const Joint& joint, double V)
{
    // friction that grows with the transmitted effort carries a share μ of the loop's force away; all else grows by as
    // much beside the loop
    const double share = 1 - joint.friction.load_coefficient;
    LinearMass mass{joint.mechanism.inertia, joint.control.k_v, joint.control.k_p, linearise(joint.friction, V)};
    if (share == 1) return mass;
    mass.inertia /= share;
    mass.friction = scaled(std::move(mass.friction), 1 / share);
    return mass;
}

namespace {

void tell_stopped_integral(const Control& c, LoopUse& loop)
{
    const char* key = c.structure == Structure::pid      ? "control.k_i"
                      : is_set(c.velocity_integral_gain) ? "control.velocity_integral_gain"
                                                         : "control.velocity_reset_time";
    loop.not_used.push_back({key, WhyNot::small_signal, false});
}

}  // namespace

LoopUse verdict_loop(const Joint& described)
{
    auto loop = loop_use(without_stopped_integral(described));
    if (integral_at_limit(described)) tell_stopped_integral(described.control, loop);
    return loop;
}

LinearVerdict linear_verdict(const Joint& described)
{
    const Joint joint = without_stopped_integral(described);
    LinearVerdict verdict;
    verdict.loop = verdict_loop(described);
    verdict.steady = possible_sliding(described);  // what a stopped integral holds counts in the deflection
    if (verdict.steady.reason != Reason::none) return verdict;
    if (verdict.loop.kind != LoopKind::ideal) return real_verdict(joint, std::move(verdict));
    // a cascade without an integral, after the loop is known to be the ideal one
    if (joint.control.structure == Structure::cascade) {
        auto summed = linear_verdict(with_gains(joint));
        summed.loop = std::move(verdict.loop);
        summed.steady = verdict.steady;
        return summed;
    }
    if (!is_plain_mass(joint)) return joint_verdict(joint, std::move(verdict));
    const auto mass = linear_mass(joint, verdict.steady.slides_at);
    if (!mass.friction.rational()) return joint_verdict(joint, std::move(verdict));

    auto& simple = verdict.velocity_only;
    simple.slope = steady_slope(mass.friction);
    simple.k_v_min = least_velocity_gain(mass);
    if (mass.k_p > 0) simple.stable_k_v = {{simple.k_v_min, infinity}};
    const auto simply = velocity_only_code(mass);
    simple.stable = simply == 1;
    simple.neutral = simply == verdict_neutral;

    auto& memory = verdict.state_variable;
    memory.f_v = mass.friction.f_v;
    memory.kernel_integral = kernel_integral(mass.friction);
    memory.eigenvalues = spectrum(mass);
    if (!take_abscissa(verdict, spectral_abscissa(mass))) return verdict;
    take_gains(memory, stable_gains(joint));
    return verdict;
}

double growth_rate(const Joint& joint)
{
    const auto steady = possible_sliding(joint);
    if (steady.reason != Reason::none) return missing;
    if (loop_kind(joint) != LoopKind::ideal) return real_growth(joint, false);
    if (joint.control.structure == Structure::cascade) return growth_rate(with_gains(joint));
    if (is_plain_mass(joint)) {
        const auto mass = linear_mass(joint, steady.slides_at);
        if (mass.friction.rational()) return spectral_abscissa(mass);
    }
    return spectral_abscissa(linear_joint(joint, steady.slides_at));
}

void add_frictions(const LinearJoint& linear, LinearVerdict& verdict)
{
    auto& slope = verdict.velocity_only.slope = -linear.state_slope;
    auto& memory = verdict.state_variable;
    memory.f_v = memory.kernel_integral = 0;
    for (int i = 0; i < linear.bodies; ++i) {
        slope += steady_slope(linear.friction[i]);
        memory.f_v += linear.friction[i].f_v;
        memory.kernel_integral += kernel_integral(linear.friction[i]);
    }
}

double velocity_only_growth_rate(const Joint& joint)
{
    const auto steady = possible_sliding(joint);
    if (steady.reason != Reason::none) return missing;
    if (loop_kind(joint) != LoopKind::ideal) return real_growth(joint, true);
    if (joint.control.structure == Structure::cascade) return velocity_only_growth_rate(with_gains(joint));
    return spectral_abscissa(velocity_only(linear_joint(joint, steady.slides_at)));
}

PointResult linear_point(const Joint& joint)
{
    PointResult point;
    const auto steady = possible_sliding(joint);
    point.reason = steady.reason;
    if (steady.reason != Reason::none) return point;
    if (loop_kind(joint) != LoopKind::ideal) return real_point(joint);
    if (joint.control.structure == Structure::cascade) return linear_point(with_gains(joint));
    if (!is_plain_mass(joint)) return joint_point(joint, steady.slides_at);
    const auto mass = linear_mass(joint, steady.slides_at);
    if (!mass.friction.rational()) return joint_point(joint, steady.slides_at);
    const double slope = steady_slope(mass.friction);
    point.spectral_abscissa = spectral_abscissa(mass);
    if (!std::isfinite(point.spectral_abscissa) || !std::isfinite(slope)) {
        point.reason = Reason::not_finite;
        return point;
    }
    point.k_v_min = least_velocity_gain(mass);
    point.velocity_only_stable = velocity_only_code(mass);
    point.state_variable_stable = code_of(point.spectral_abscissa);
    point.region = region_of(point.velocity_only_stable, point.state_variable_stable);
    // one of millions of rows has no time for a search: the closed form, which stable_gains meets within rounding
    if (mass.friction.states <= 1 && !gain_moves_sliding(joint)) {
        if (const auto critical = critical_gain(mass.inertia, mass.k_v, mass.friction)) {
            point.k_cr = critical->k_p;
            point.omega = critical->omega;
        }
    } else {
        take_gains(point, stable_gains(joint));
    }
    return point;
}

}  // namespace stickslip
