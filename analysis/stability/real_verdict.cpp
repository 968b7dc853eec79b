#include "analysis/stability/real_loop.h"

#include "analysis/joint/gains.h"
#include "analysis/numerics/eigenvalues.h"
#include "analysis/stability/steady.h"
#include "analysis/stability/verdict_parts.h"

namespace stickslip {
namespace {

using Complex = std::complex<double>;

std::uint8_t code_of(double growth)
{
    return growth < 0 ? 1 : growth == 0 ? verdict_neutral : 0;
}

/// Why a joint has no loop to judge.
Reason without_loop(const Joint& joint)
{
    return remembers_little(joint) ? Reason::not_finite : Reason::unsupported;
}

}  // namespace

CommandMargins real_margins(const Joint& joint)
{
    const double velocity = sliding_velocity(joint);
    const auto loop = real_loop(joint, linear_joint(joint, velocity), velocity, TurnedGain::all);
    if (!loop) return {};
    if (const auto* sampled = std::get_if<DiscreteLoop>(&loop->loop)) return command_margins(*sampled);
    const auto& delayed = std::get<DelayedLoop>(loop->loop);
    return command_margins(delayed, delayed_spectrum(delayed, 1));
}

void add_margins(const Joint& joint, LinearVerdict& verdict)
{
    if (verdict.steady.reason != Reason::none || joint.control.kind != ControlKind::position) return;
    if (!std::isnan(verdict.state_variable.phase_margin_deg)) return;
    const auto margins = real_margins(joint);
    verdict.state_variable.gain_margin_db = margins.gain_db;
    verdict.state_variable.phase_margin_deg = margins.phase_deg;
}

namespace {

/// Of a mechanism that grows beyond all numbers within one tick: its own root. A command that acts within the tick
/// changes its rate by ln|1 − k|/T, less than a hundredth where e^{sT} overflows.
Complex root_within_tick(const Joint& joint, const LinearJoint& linear, double velocity)
{
    const auto own = eigenvalues_of(loop_plant(joint, linear, velocity).A);
    Complex root = missing;
    for (const Complex& s : own)
        if (!(s.real() <= root.real())) root = s;
    return {root.real(), std::abs(root.imag())};
}

double growth_within_tick(const Joint& joint, const LinearJoint& linear, double velocity)
{
    return root_within_tick(joint, linear, velocity).real();
}

std::optional<RealLoop> whole_loop(const Joint& joint, bool velocity_only_friction)
{
    const double velocity = sliding_velocity(joint);
    auto linear = linear_joint(joint, velocity);
    if (velocity_only_friction) linear = velocity_only(std::move(linear));
    return real_loop(joint, linear, velocity, TurnedGain::all);
}

}  // namespace

double real_growth(const Joint& joint, bool velocity_only_friction)
{
    const auto loop = whole_loop(joint, velocity_only_friction);
    if (!loop) return missing;
    const double rate = growth(*loop);
    if (rate != infinity) return rate;
    const double velocity = sliding_velocity(joint);
    auto linear = linear_joint(joint, velocity);
    if (velocity_only_friction) linear = velocity_only(std::move(linear));
    return growth_within_tick(joint, linear, velocity);
}

double real_side(const Joint& joint, bool velocity_only_friction)
{
    const auto loop = whole_loop(joint, velocity_only_friction);
    return loop ? side(*loop) : missing;
}

bool growth_is_costly(const Joint& joint)
{
    const auto sliding = possible_sliding(joint);
    if (loop_kind(joint) == LoopKind::ideal || sliding.reason != Reason::none) return false;
    const auto loop = whole_loop(joint, false);
    const auto* delayed = loop ? std::get_if<DelayedLoop>(&loop->loop) : nullptr;
    return delayed && (!delayed->friction.empty() || delayed->ticked);
}

Complex real_root(const Joint& joint)
{
    const double velocity = sliding_velocity(joint);
    const auto linear = linear_joint(joint, velocity);
    const auto loop = real_loop(joint, linear, velocity, TurnedGain::all);
    if (!loop) return missing;
    Complex root = missing;
    if (const auto* sampled = std::get_if<DiscreteLoop>(&loop->loop)) {
        const auto all = multipliers(*sampled, loop->gain);
        if (!all.empty()) root = std::log(all.front()) / sampled->period;
    } else if (const auto all = roots(std::get<DelayedLoop>(loop->loop), loop->gain); !all.empty()) {
        root = all.front();
    }
    if (!std::isfinite(std::abs(root)) && growth(*loop) == infinity) return root_within_tick(joint, linear, velocity);
    return {root.real(), std::abs(root.imag())};
}

PointResult real_point(const Joint& joint)
{
    const double velocity = sliding_velocity(joint);
    PointResult point;
    const auto linear = linear_joint(joint, velocity);
    const auto loop = real_loop(joint, linear, velocity, TurnedGain::all);
    if (!loop) {
        point.reason = without_loop(joint);
        return point;
    }
    point.spectral_abscissa = growth(*loop);
    if (point.spectral_abscissa == infinity) point.spectral_abscissa = growth_within_tick(joint, linear, velocity);
    if (!std::isfinite(point.spectral_abscissa)) {
        point.spectral_abscissa = missing;
        point.reason = Reason::not_finite;
        return point;
    }
    const auto simple = real_loop(joint, velocity_only(linear), velocity, TurnedGain::all);
    const double simply = simple ? growth(*simple) : missing;
    point.velocity_only_stable = std::isnan(simply) ? verdict_missing : code_of(simply);
    point.state_variable_stable = code_of(point.spectral_abscissa);
    if (point.state_variable_stable == verdict_neutral)
        point.region = Region::neutral;
    else if (point.state_variable_stable == 1)
        point.region = point.velocity_only_stable == 1 ? Region::stable : Region::memory_only;
    else
        point.region = point.velocity_only_stable == 1 ? Region::velocity_only : Region::unstable;
    const auto* delayed = std::get_if<DelayedLoop>(&loop->loop);
    if (!delayed || !delayed->finite()) return point;
    if (const auto turned = real_loop(joint, linear, velocity, TurnedGain::k_p)) {
        const auto gains = turned_gains(*turned);
        point.k_cr = gains.k_cr, point.omega = gains.omega;
    }
    return point;
}

namespace {

/// The simple theory of the same loop.
void take_velocity_only(const Joint& joint, const LinearJoint& linear, double V, VelocityOnlyVerdict& simple)
{
    const auto curve = velocity_only(linear);
    if (const auto loop = real_loop(joint, curve, V, TurnedGain::all)) {
        const double rate = growth(*loop);
        simple.stable = rate < 0;
        simple.neutral = rate == 0;
    }
    if (const auto turned = real_loop(joint, curve, V, TurnedGain::k_v)) {
        simple.stable_k_v = turned_gains(*turned).stable;
        // of a motor that is wired the other way round no gain is the least
        if (!simple.stable_k_v.empty() && simple.stable_k_v.front().low >= 0)
            simple.k_v_min = simple.stable_k_v.front().low;
    }
}

}  // namespace

LinearVerdict real_verdict(const Joint& joint, LinearVerdict verdict)
{
    const double V = verdict.steady.slides_at;
    const auto linear = linear_joint(joint, V);
    auto& simple = verdict.velocity_only;
    auto& memory = verdict.state_variable;
    add_frictions(linear, verdict);
    const auto all = real_loop(joint, linear, V, TurnedGain::all);
    if (!all) {
        verdict.steady.reason = without_loop(joint);
        return verdict;
    }
    const auto* delayed = std::get_if<DelayedLoop>(&all->loop);
    const auto closed = delayed ? delayed_spectrum(*delayed, 1) : DelayedSpectrum{};
    memory.spectral_abscissa = delayed ? closed.growth : growth(*all);
    const bool beyond_numbers = memory.spectral_abscissa == infinity;
    const Complex root = beyond_numbers ? root_within_tick(joint, linear, V) : missing;
    if (beyond_numbers) memory.spectral_abscissa = root.real();
    if (!std::isfinite(memory.spectral_abscissa)) {
        memory.spectral_abscissa = missing;
        verdict.steady.reason = Reason::not_finite;
        return verdict;
    }
    if (beyond_numbers) {
        // no gain holds it, and nothing about its map from tick to tick is a number: that root is all of the list
        memory.eigenvalues = {root};
        if (root.imag() > 0) memory.eigenvalues.push_back(std::conj(root));
        memory.all_eigenvalues = false;
        memory.searched_from = memory.searched_to = gains_of(joint.control).k_p;
        const double simply = real_growth(joint, true);
        simple.stable = simply < 0;
        simple.neutral = simply == 0;
        return verdict;
    }
    if (const auto* sampled = std::get_if<DiscreteLoop>(&all->loop)) {
        memory.multipliers = multipliers(*sampled, 1);
        for (const Complex& z : memory.multipliers)
            if (std::abs(z) > 0) memory.eigenvalues.push_back(std::log(z) / sampled->period);
        const auto margins = command_margins(*sampled);
        memory.gain_margin_db = margins.gain_db;
        memory.phase_margin_deg = margins.phase_deg;
    } else {
        memory.eigenvalues = closed.roots;
        memory.all_eigenvalues = delayed->finite();
        if (delayed->period > 0)
            for (const Complex& s : memory.eigenvalues) memory.multipliers.push_back(std::exp(s * delayed->period));
        const auto margins = command_margins(*delayed, closed);
        memory.gain_margin_db = margins.gain_db;
        memory.phase_margin_deg = margins.phase_deg;
    }
    memory.stable = memory.spectral_abscissa < 0;
    memory.neutral = memory.spectral_abscissa == 0;
    if (const auto turned = real_loop(joint, linear, V, TurnedGain::k_p))
        take_gains(memory, turned_gains(*turned));
    else
        memory.searched_from = memory.searched_to = gains_of(joint.control).k_p;
    take_velocity_only(joint, linear, V, simple);
    return verdict;
}

}  // namespace stickslip
