#include "sweep/words/set_point_text.h"

#include "analysis/results/text.h"

#include <fmt/format.h>

namespace stickslip {

// In one piece: one sentence a reason.
std::string set_point_reason(SetPointReason reason)
{
    switch (reason) {
        case SetPointReason::none:
            return "";
        case SetPointReason::static_above_coulomb:
            return "static friction is higher than Coulomb friction: the integrator breaks it and overshoots";
        case SetPointReason::falling_friction:
            return "friction falls enough with speed for each slip to overshoot";
        case SetPointReason::no_integral_action:
            return "the loop does not integrate: the joint rests where static friction holds it";
        case SetPointReason::static_is_coulomb:
            return "static friction equals Coulomb friction: each slip ends nearer to the set point";
        case SetPointReason::slips_shrink:
            return "each slip ends nearer to the set point than the last";
        case SetPointReason::held:
            return "nothing breaks the static friction: a limit of the integral or of the output holds it, or the "
                   "encoder reads "
                   "no error";
        case SetPointReason::dead_zone:
            return "slips end within the dead zone";
        case SetPointReason::push_breaks_friction:
            return "over-compensated: the push towards the set point exceeds static friction, and the delayed loop "
                   "drives the joint back and forth";
        case SetPointReason::driven_by_velocity:
            return "over-compensated: the feed-forward from the velocity exceeds friction and damping";
        case SetPointReason::not_driven:
            return "the loop does not integrate, and the feed-forward from the velocity is less than friction and "
                   "damping";
        case SetPointReason::dither_narrows:
            return "the loop does not integrate: its dither is below the kinetic friction, so that all motion stops, "
                   "and reduces the error that static friction can hold";
        case SetPointReason::dithered:
            return "a dither is evaluated only below the kinetic friction, in a loop without integral, push and "
                   "bristles that is neither sampled nor late; use simulate --reference";
        case SetPointReason::bristles_compensated:
            return "a feed-forward from the error or the velocity is not simulated over bristles";
        case SetPointReason::loop_unstable:
            return "the loop is unstable even without dry friction: from far enough away it diverges";
        case SetPointReason::load_beyond_limits:
            return "the load at the set point exceeds what the limits leave by more than static friction holds";
        case SetPointReason::driven_cycle:
            return "the delayed loop keeps the joint moving: no stop lasts";
        case SetPointReason::force_control:
            return "a force loop has no position set point";
        case SetPointReason::several_bodies:
            return "set points of joints with several inertias are not simulated";
        case SetPointReason::law_needs_motion:
            return "the friction law is undefined at rest";
        case SetPointReason::law_without_motion:
            return "this friction law is not simulated at rest";
        case SetPointReason::friction_term:
            return "friction has a term in addition to its law (bristle, memory, load, gear, ripple, drift or viscous "
                   "asymmetry) "
                   "that is not simulated at rest";
        case SetPointReason::loop_not_simulated:
            return "sampling, dead time, lag, a filter, gravity or an encoder step is not simulated over bristles at "
                   "rest; use simulate --reference";
        case SetPointReason::left_out:
            return "what is left out of this answer matters to it: encoder noise, a periodic force, a moving normal "
                   "load or a neighbour; use simulate --reference";
        case SetPointReason::loaded:
            return "a constant load takes a part of a limit on which the answer depends; use simulate --reference";
        case SetPointReason::not_converged:
            return "the motion was not simulated to its end within the limit of work";
    }
    return "";
}

namespace {

/// Of the starts that were followed, what differs from the rest.
std::string nearby_text(const SetPoint& s, Units units)
{
    const double within = s.rests_within(), diverges = s.diverges_from();
    const auto length = [&](double value) { return with_unit(value, Quantity::position, units); };
    std::string text = s.rests_nearby ? "; from nearby it comes to rest" : "";
    if (s.rests_nearby && is_set(within)) text = "; from up to " + length(within) + " away it comes to rest";
    if (is_set(diverges)) text += "; from " + length(diverges) + " on it diverges";
    return text;
}

/// By their distance from the set point.
std::string starts_text(const SetPoint& s, Units units)
{
    std::string text;
    for (const auto& range : s.by_start) {
        const auto length = [&](double value) { return with_unit(value, Quantity::position, units); };
        const std::string at =
            range.from == range.to ? length(range.from) : length(range.from) + " to " + length(range.to);
        text += (text.empty() ? "" : ", ") + at + ": " + std::string(name_of(range.end));
    }
    return text;
}

}  // namespace

std::string set_point_text(const SetPoint& s, Units units)
{
    const auto length = [&](double value) { return with_unit(value, Quantity::position, units); };
    std::string text;
    switch (s.hunting) {
        case Hunting::yes:
            text = "Hunts at a set point";
            if (is_set(s.amplitude)) text += ": stops " + length(s.amplitude) + " to either side";
            if (s.asymmetric) text = "Hunts at a set point: stops up to " + length(s.amplitude) + " away, unequally";
            if (is_set(s.period)) text += ", one cycle in " + with_unit(s.period, Quantity::time, units);
            text += nearby_text(s, units) + ".";
            break;
        case Hunting::no:
            if (s.diverges() && is_set(s.rests_within()))
                text =
                    "Does not hold a set point but from nearby: rests from up to " + length(s.rests_within()) + " away";
            else if (s.diverges())
                text = "Does not hold a set point";
            else if (s.rest_error == infinity)
                text = "Does not hunt: rests anywhere";
            else if (s.rest_error > 0)
                text = "Does not hunt: rests up to " + length(s.rest_error) + " from the set point";
            else
                text = "Does not hunt: settles at the set point";
            text += ": " + set_point_reason(s.reason) + ".";
            break;
        case Hunting::undecided:
            text = "Hunting at a set point is undecided: " + set_point_reason(s.reason) + ".";
            break;
    }
    return text;
}

Table set_point_table(const SetPoint& s, Units units)
{
    Table table;
    table.title = "At a set point";
    table.columns = {"quantity", "value"};
    table.rows.push_back({"at a set point", s.hunting == Hunting::yes  ? "hunts"
                                            : s.hunting == Hunting::no ? "does not hunt"
                                                                       : "undecided"});
    table.rows.push_back({"because", set_point_reason(s.reason)});
    const auto add = [&](const char* name, double value, Quantity quantity) {
        if (is_set(value)) table.rows.push_back({name, with_unit(value, quantity, units, 6)});
    };
    add("distance of the stops from the set point", s.amplitude, Quantity::position);
    add("slip time", s.slip_time, Quantity::time);
    add("stick time", s.stick_time, Quantity::time);
    add("hunting period", s.period, Quantity::time);
    add("multiplier from stop to stop", s.multiplier, Quantity::number);
    add("static friction", s.own_level, Quantity::effort);
    add("level of the compensation", s.compensation, Quantity::command);
    if (s.starts > 0 && s.hunting == Hunting::no)
        table.rows.push_back({"slips followed", fmt::format("{} starts from {} to {}", s.starts,
                                                            with_unit(s.searched_from, Quantity::position, units),
                                                            with_unit(s.searched_to, Quantity::position, units))});
    add("largest ratio of distances from stop to stop", s.largest_ratio, Quantity::number);
    if (s.hunting == Hunting::no) add("largest error at rest", s.rest_error, Quantity::position);
    if (!s.by_start.empty()) table.rows.push_back({"by the distance where a slip begins", starts_text(s, units)});
    std::string keys;
    for (const auto& key : s.not_used) keys += (keys.empty() ? "" : ", ") + key;
    if (!keys.empty()) table.rows.push_back({"left out of this answer", keys});
    return table;
}

Section set_point_section(const SetPoint& s, Units units)
{
    return {"set-point", "At a set point", set_point_text(s, units), {}, {set_point_table(s, units)}};
}

}  // namespace stickslip
