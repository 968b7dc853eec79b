// In one file: the sentences and the table of one linear verdict.
#include "sweep/words/verdict_text.h"

#include "analysis/joint/gains.h"
#include "analysis/results/text.h"
#include "sweep/words/detail_text.h"
#include "sweep/words/line_figure.h"
#include "sweep/words/loop_text.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stickslip {
namespace {

std::string stiffness(double k, Units units)
{
    return with_unit(k, Quantity::position_gain, units);
}

/// A real force loop has no k_p of its own that could be turned, a cascade there no k_v: neither was searched.
bool searched_in_k_p(const Joint& joint)
{
    return loop_kind(joint) == LoopKind::ideal || joint.control.kind == ControlKind::position;
}
bool searched_in_k_v(const Joint& joint, const LoopUse& loop)
{
    const auto& used = loop.used;
    const bool cascade = std::find(used.begin(), used.end(), "control.position_gain") != used.end();
    return loop.kind == LoopKind::ideal || (joint.control.kind == ControlKind::position && !cascade);
}

/// The stable set in k_p where it is no single half-line above a critical gain.
std::string stable_gains(const Joint& joint, const StateVariableVerdict& memory)
{
    if (!searched_in_k_p(joint)) return ".";
    const Units units = units_of(joint);
    const auto& stable = memory.stable_intervals;
    const bool limited = std::isfinite(memory.searched_to);
    if (stable.empty()) return limited ? "." : ". No k_{p} makes it stable.";
    const bool all = stable.size() == 1 && stable[0].low == 0 && stable[0].high == infinity;
    if (all && memory.stable) return " for every k_{p} > 0.";
    return ". k_{p} = " + stiffness(joint.control.k_p, units) +
           (memory.stable ? " is one of the stable gains: " : " is not among the stable gains: ") +
           intervals_text(stable, Quantity::position_gain, units) +
           (memory.searched_from > 0
                ? ", searched " + range_text(memory.searched_from, memory.searched_to, Quantity::position_gain, units) +
                      "."
            : limited ? ", searched up to " + stiffness(memory.searched_to, units) + "."
                      : ".");
}

/// What the velocity-only model would require where it says no, and memory does not.
std::string asked_by_velocity(const Joint& joint, const LoopUse& loop, const VelocityOnlyVerdict& velocity_only)
{
    if (!searched_in_k_v(joint, loop)) return ".";
    if (velocity_only.stable_k_v.empty()) return " at every k_{v}.";
    return " and asks for " + demanded_text(velocity_only.stable_k_v, units_of(joint)) + ".";
}

/// Above the upper end of a real loop's stable gains it is dead time, lag or sampling that destabilises, not friction.
bool above_the_loops_window(const Joint& joint, const LinearVerdict& v)
{
    const auto& stable = v.state_variable.stable_intervals;
    return v.loop.kind != LoopKind::ideal && !stable.empty() && gains_of(joint.control).k_p > stable.back().high;
}

/// The first words: what the joint does, and how fast.
std::string first_words(const Joint& joint, const LinearVerdict& v, bool bistable)
{
    const auto speed = with_unit(v.steady.velocity, Quantity::velocity, units_of(joint));
    if (v.state_variable.stable && bistable)
        return "Bistable: slides smoothly at " + speed + ", but a large enough disturbance ends in stick-slip for good";
    if (v.state_variable.stable) return "Slides smoothly at " + speed;
    if (v.state_variable.neutral)
        return "Neutral: small disturbances of sliding at " + speed + " neither decay nor grow";
    if (joint.control.k_p < 0)
        return "Unstable: with k_{p} < 0 the loop pushes away from the commanded motion, sliding at " + speed +
               " does not last";
    if (above_the_loops_window(joint, v))
        return "Unstable loop: k_{p} is above every gain with which the loop itself is stable, sliding at " + speed +
               " does not last";
    return "Stick-slip: sliding at " + speed + " is unstable";
}

/// What holds the joint on the imaginary axis, and what would not.
std::string neutral_words(const Joint& joint, const StateVariableVerdict& memory)
{
    if (joint.control.k_p == 0) return ". Nothing brings the position back: k_{p} = 0.";
    if (!memory.stable_intervals.empty() || !memory.crossings.empty())
        return ". The design lies on the boundary of stability" + stable_gains(joint, memory);
    return ". Friction and k_{v} together neither feed nor damp the oscillation, and no k_{p} changes that.";
}

/// The other theory's word, where it differs.
std::string other_theory(const Joint& joint, const LinearVerdict& v)
{
    const auto& simple = v.velocity_only;
    const auto& memory = v.state_variable;
    if (simple.stable == memory.stable && simple.neutral == memory.neutral) return "";
    const std::string says = " The velocity-only model calls it ";
    return says + (simple.stable    ? "stable."
                   : simple.neutral ? "neutral."
                                    : "stick-slip" + asked_by_velocity(joint, v.loop, simple));
}

}  // namespace

std::string verdict_text(const Joint& joint, const LinearVerdict& v, bool bistable)
{
    const Units units = units_of(joint);
    if (v.steady.reason == Reason::no_steady_state) return "Undecided: the design point has no steady sliding.";
    if (v.steady.reason == Reason::limit_too_low)
        return "No steady sliding: the effort limit is below what it takes against a friction of " +
               with_unit(v.steady.friction, Quantity::effort, units, 6) + ".";
    if (v.steady.reason != Reason::none) return "Undecided at the design point: " + reason_text(v.steady.reason) + ".";
    const auto& memory = v.state_variable;
    const double k_p = joint.control.k_p;
    std::string text = first_words(joint, v, bistable);
    if (memory.neutral)
        text += neutral_words(joint, memory);
    else if (std::isfinite(memory.k_cr) && k_p > 0)
        text += ": k_{p} = " + stiffness(k_p, units) + " is " + plain_number(k_p / memory.k_cr) +
                " × the critical gain k_{cr} = " + stiffness(memory.k_cr, units) + ".";
    else
        text += stable_gains(joint, memory);
    const auto side = side_text(joint, false);
    return text + other_theory(joint, v) + loop_text(v.loop) + (side.empty() ? "" : " " + side);
}

Table linear_table(const Joint& joint, const LinearVerdict& v)
{
    const Units units = units_of(joint);
    const auto row = [&](std::string name, double value, Quantity q) {
        return std::vector<std::string>{std::move(name), with_unit(value, q, units, 6)};
    };
    Table table;
    table.title = "Linear theory at the design point";
    table.columns = {"quantity", "value"};
    table.rows = {
        row("commanded velocity V_{0}", v.steady.velocity, Quantity::velocity),
        row("friction of steady sliding f_{ss}(V_{0})", v.steady.friction, Quantity::effort),
        row("steady deflection δ_{ss}", v.steady.deflection, Quantity::position),
        row("slope of the steady curve f_{ss}'(V_{0})", v.velocity_only.slope, Quantity::damping),
        {"k_{v} required by the velocity-only model", !searched_in_k_v(joint, v.loop) ? "not searched in this loop"
                                                      : v.velocity_only.k_v_min == 0 && v.velocity_only.slope <= 0
                                                          ? "any k_{v} > 0"
                                                          : demanded_text(v.velocity_only.stable_k_v, units)},
        row("direct effect f_{v}", v.state_variable.f_v, Quantity::damping),
        row("kernel integral ∫g", v.state_variable.kernel_integral, Quantity::damping),
        row("critical position gain k_{cr}", v.state_variable.k_cr, Quantity::position_gain),
        row("spectral abscissa max Re s", v.state_variable.spectral_abscissa, Quantity::rate)};
    if (v.loop.kind != LoopKind::ideal) table.rows.push_back({"loop", loop_name(v.loop.kind)});
    if (is_set(v.state_variable.gain_margin_db))
        table.rows.push_back({"gain margin", plain_number(v.state_variable.gain_margin_db) + " dB"});
    if (is_set(v.state_variable.phase_margin_deg))
        table.rows.push_back({"phase margin", plain_number(v.state_variable.phase_margin_deg) + "°"});
    if (std::isnan(v.state_variable.k_cr))
        table.rows.push_back(
            {"stable k_{p}", searched_in_k_p(joint)
                                 ? intervals_text(v.state_variable.stable_intervals, Quantity::position_gain, units)
                                 : "not searched: a force loop turns none of its gains alone"});
    else {
        const double omega = v.state_variable.crossings.back().omega;
        table.rows.push_back(row("frequency at the critical gain ω", omega, Quantity::angular_frequency));
        table.rows.back().back() += " (" + plain_number(omega / (2 * std::numbers::pi)) + " Hz)";
    }
    return table;
}

Table nonlinear_table(const Joint& joint, const NonlinearVerdict& v)
{
    const Units units = units_of(joint);
    Table table;
    table.title = "The nonlinear joint";
    table.columns = {"quantity", "value"};
    table.rows.push_back({"outcome", std::string(code_name("outcome", static_cast<std::uint8_t>(v.outcome)))});
    if (!reason_text(v).empty()) table.rows.push_back({"because", reason_text(v)});
    if (v.region == NonlinearRegion::bistable)
        table.rows.push_back(v.outcome == Outcome::stable_sliding
                                 ? std::vector<std::string>{"a larger disturbance", "ends in a limit cycle: bistable"}
                                 : std::vector<std::string>{"a small disturbance", "decays: bistable"});
    if (v.region == NonlinearRegion::stable)
        table.rows.push_back(
            {"larger disturbances", "also end in steady sliding: " + larger_tried_text(v.searched_from)});
    if (v.repeats > 1) table.rows.push_back({"cycles after which the motion repeats", std::to_string(v.repeats)});
    const auto add = [&](const char* name, double value, Quantity q) {
        if (is_set(value)) table.rows.push_back({name, with_unit(value, q, units, 6)});
    };
    add("growth rate of a small disturbance", v.growth_rate, Quantity::rate);
    // of sliding that only the encoder or its noise disturbs the same numbers tell how far
    const bool jitters = v.outcome == Outcome::stable_sliding && v.region != NonlinearRegion::bistable;
    add("limit-cycle amplitude in position", v.amplitude, Quantity::position);
    add(jitters ? "jitter of the position" : "standard deviation of that amplitude", v.jitter, Quantity::position);
    add(jitters ? "least velocity" : "least velocity of the cycle", v.velocity_min, Quantity::velocity);
    add(jitters ? "peak velocity" : "peak velocity of the cycle", v.velocity_max, Quantity::velocity);
    add("period", v.period, Quantity::time);
    if (!jitters) add("share of the period spent sticking", v.stick_fraction, Quantity::number);
    add("overshoot, per steady deflection", v.overshoot, Quantity::number);
    if (!v.multipliers.empty()) add("largest Floquet multiplier", std::abs(v.multipliers.front()), Quantity::number);
    if (v.criticality == Criticality::subcritical)
        table.rows.push_back({"at k_{cr}", "subcritical: cycles exist above it, too"});
    if (v.criticality == Criticality::supercritical)
        table.rows.push_back({"at k_{cr}", "supercritical: cycles grow from zero below it"});
    add("k_{p} at the fold of limit cycles", v.fold_k_p, Quantity::position_gain);
    return table;
}

std::string reason_text(Reason reason)
{
    switch (reason) {
        case Reason::none:
            return "none";
        case Reason::no_velocity:
            return "neither control.V0 nor control.force_rate is set";
        case Reason::law_needs_motion:
            return "the joint cannot slide at this velocity: V_0 = 0 is a set point, and laws that need motion take "
                   "V_0 > 0 only";
        case Reason::no_steady_state:
            return "there is no steady sliding at the commanded velocity";
        case Reason::not_finite:
            return "a number overflowed";
        case Reason::linear_only:
            return "the law is linear by definition";
        case Reason::not_converged:
            return "the motion is too slow to decide within the allowed work";
        case Reason::solver_failed:
            return "both solvers failed";
        case Reason::unsupported:
            return "this combination of friction law, joint and disturbance is not computed";
        case Reason::neutral:
            return "neutral: small disturbances neither grow nor decay, as nothing damps them";
        case Reason::limit_too_low:
            return "the effort limit is below the effort that steady sliding needs: the joint cannot slide at this "
                   "velocity";
        case Reason::diverges:
            return "the motion runs away from steady sliding: no spring and no damper holds it back";
    }
    return "unknown";
}

std::string reason_text(const NonlinearVerdict& verdict)
{
    if (verdict.detail != Detail::none) return detail_text(verdict.detail);
    return verdict.reason == Reason::none ? std::string() : reason_text(verdict.reason);
}

std::string plain_text(const std::string& markup)
{
    std::string text;
    for (std::size_t i = 0; i < markup.size(); ++i) {
        const bool opens = (markup[i] == '_' || markup[i] == '^') && i + 1 < markup.size() && markup[i + 1] == '{';
        const auto end = opens ? markup.find('}', i) : std::string::npos;
        if (end == std::string::npos) {
            text += markup[i];
            continue;
        }
        text += markup[i] + markup.substr(i + 2, end - i - 2);
        i = end;
    }
    return text;
}

}  // namespace stickslip
