// The numbers of a verdict, as rows of a table.
#include "sweep/words/reason_text.h"
#include "sweep/words/verdict_text.h"

#include "analysis/joint/gains.h"
#include "analysis/results/text.h"
#include "sweep/words/detail_text.h"
#include "sweep/words/interval_text.h"
#include "sweep/words/loop_text.h"
#include "sweep/words/searched_gains.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stickslip {

std::string stable_gains_text(const Joint& joint, const StateVariableVerdict& memory)
{
    if (!searched_in_k_p(joint)) return "not searched in this loop: boundary --along control.k_p finds it";
    const auto& stable = memory.stable_intervals;
    if (stable.empty() && !(memory.searched_to > gains_of(joint.control).k_p))
        return "not known: the search for crossings of the imaginary axis found no end";
    const Units units = units_of(joint);
    const auto text = intervals_text(stable, Quantity::position_gain, units);
    if (stable.empty() && std::isfinite(memory.searched_to))
        return text + " up to " + with_unit(memory.searched_to, Quantity::position_gain, units);
    return text;
}

Table linear_table(const Joint& joint, const LinearVerdict& v)
{
    const Units units = units_of(joint);
    const auto row = [&](std::string name, double value, Quantity q) {
        return std::vector<std::string>{std::move(name), with_unit(value, q, units, 4)};
    };
    Table table;
    table.title = "Linear theory at the design point";
    table.columns = {"quantity", "value"};
    table.rows = {row("commanded velocity V_{0}", v.steady.velocity, Quantity::velocity)};
    const bool as_commanded = !(v.steady.slides_at != v.steady.velocity) || !is_set(v.steady.slides_at);
    const std::string V = as_commanded ? "V_{0}" : "V";
    if (!as_commanded)
        table.rows.push_back(
            row("velocity of sliding V = V_{0}/sensor.position_scale", v.steady.slides_at, Quantity::velocity));
    table.rows.push_back(row("friction of steady sliding f_{ss}(" + V + ")", v.steady.friction, Quantity::effort));
    table.rows.push_back(row("steady deflection δ_{ss}", v.steady.deflection, Quantity::position));
    // without a verdict no gain was searched: an empty set would say that none is stable
    if (v.steady.reason != Reason::none) return table;
    const std::vector<std::vector<std::string>> judged = {
        row("slope of the steady curve f_{ss}'(" + V + ")", v.velocity_only.slope, Quantity::damping),
        {"k_{v} required by the velocity-only model", !searched_in_k_v(joint, v.loop) ? "not searched in this loop"
                                                      : v.velocity_only.k_v_min == 0 && v.velocity_only.slope <= 0
                                                          ? "any k_{v} > 0"
                                                          : required_text(v.velocity_only.stable_k_v, units)},
        row("direct effect f_{v}", v.state_variable.f_v, Quantity::damping),
        row("kernel integral ∫g", v.state_variable.kernel_integral, Quantity::damping),
        row("critical position gain k_{cr}", v.state_variable.k_cr, Quantity::position_gain),
        row("spectral abscissa max Re s", v.state_variable.spectral_abscissa, Quantity::rate)};
    table.rows.insert(table.rows.end(), judged.begin(), judged.end());
    if (v.loop.kind != LoopKind::ideal) table.rows.push_back({"loop", loop_name(v.loop.kind)});
    if (is_set(v.state_variable.gain_margin_db))
        table.rows.push_back(
            {"gain margin, all gains together", plain_number(v.state_variable.gain_margin_db) + " dB"});
    if (is_set(v.state_variable.phase_margin_deg))
        table.rows.push_back({"phase margin", plain_number(v.state_variable.phase_margin_deg) + "°"});
    if (std::isnan(v.state_variable.k_cr))
        table.rows.push_back({"stable k_{p}", stable_gains_text(joint, v.state_variable)});
    else {
        const double omega = v.state_variable.crossings.back().omega;
        table.rows.push_back(row("frequency at the critical gain ω", omega, Quantity::angular_frequency));
        table.rows.back().back() += " (" + plain_number(omega / (2 * std::numbers::pi)) + " Hz)";
    }
    return table;
}

std::string rest_text(const NonlinearVerdict& v)
{
    return v.velocity_min * v.velocity_max < 0 ? "sticking or moving backwards" : "sticking";
}

/// The code's name, but for the one outcome that is called otherwise everywhere else.
std::string outcome_name(Outcome outcome)
{
    if (outcome == Outcome::stable_sliding) return "smooth sliding";
    std::string name(code_name("outcome", static_cast<std::uint8_t>(outcome)));
    std::ranges::replace(name, '-', ' ');
    return outcome == Outcome::stick_slip ? "stick-slip" : name;
}

Table nonlinear_table(const Joint& joint, const NonlinearVerdict& v)
{
    const Units units = units_of(joint);
    Table table;
    table.title = "The nonlinear joint";
    table.columns = {"quantity", "value"};
    table.rows.push_back({"outcome", outcome_name(v.outcome)});
    if (!reason_text(v).empty()) table.rows.push_back({"because", reason_text(v)});
    if (v.region == NonlinearRegion::bistable)
        table.rows.push_back(v.outcome == Outcome::stable_sliding
                                 ? std::vector<std::string>{"a larger disturbance",
                                                            v.comes_to_rest() ? "ends at rest for good: bistable"
                                                                              : "ends in a limit cycle: bistable"}
                             : v.noise_suffices
                                 ? std::vector<std::string>{"a small disturbance",
                                                            "decays; what disturbs the loop all the time does not"}
                                 : std::vector<std::string>{"a small disturbance", "decays: bistable"});
    if (v.region == NonlinearRegion::stable)
        table.rows.push_back(
            {"larger disturbances", "also end in steady sliding: " + larger_tried_text(v.searched_from)});
    if (v.held_places > 0)
        table.rows.push_back(
            {"slow loads, waves and drifts",
             v.held_places == 1
                 ? "friction as it is after its drift, which is soon over"
                 : fmt::format("held at {} places, where it is largest and where it changes most: {}", v.held_places,
                               v.places_alike ? "the same at all" : "this is the worst")});
    if (v.repeats > 1) table.rows.push_back({"cycles after which the motion repeats", std::to_string(v.repeats)});
    const auto add = [&](const char* name, double value, Quantity q) {
        if (is_set(value)) table.rows.push_back({name, with_unit(value, q, units, 4)});
    };
    add("growth rate of a small disturbance", v.growth_rate, Quantity::rate);
    // of sliding that only the encoder or its noise disturbs the same numbers tell how far
    const bool jitters = v.outcome == Outcome::stable_sliding && v.region != NonlinearRegion::bistable;
    add("limit-cycle amplitude in position", v.amplitude, Quantity::position);
    add(jitters ? "jitter of the position" : "standard deviation of that amplitude", v.jitter, Quantity::position);
    add(jitters ? "least velocity" : "least velocity of the cycle", v.velocity_min, Quantity::velocity);
    add(jitters ? "peak velocity" : "peak velocity of the cycle", v.velocity_max, Quantity::velocity);
    add("period", v.period, Quantity::time);
    const auto add_share = [&](const std::string& name, double share) {
        if (is_set(share)) table.rows.push_back({name, percent(share)});
    };
    if (!jitters) add_share("share of the period spent " + rest_text(v), v.stick_fraction);
    add_share("overshoot, of the steady deflection", v.overshoot);
    if (!v.multipliers.empty()) add("largest Floquet multiplier", std::abs(v.multipliers.front()), Quantity::number);
    if (v.criticality == Criticality::subcritical)
        table.rows.push_back({"at k_{cr}", "subcritical: cycles exist above it, too"});
    if (v.criticality == Criticality::supercritical)
        table.rows.push_back({"at k_{cr}", "supercritical: cycles grow from zero below it"});
    add("k_{p} at the fold of limit cycles", v.fold_k_p, Quantity::position_gain);
    return table;
}

}  // namespace stickslip
