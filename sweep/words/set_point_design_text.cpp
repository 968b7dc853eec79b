#include "sweep/words/set_point_design_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/results/text.h"
#include "sweep/words/set_point_text.h"

namespace stickslip {
namespace {

std::string numbers_text(const SetPointChoice& c, Units units)
{
    std::string text = "k_{i} = " + with_unit(c.k_i, Quantity::integral_gain, units);
    if (c.dead_zone > 0) text += ", dead zone " + with_unit(c.dead_zone, Quantity::position, units);
    if (c.push != 0)
        text += ", push of " + with_unit(c.push, Quantity::command, units) + " that fades over " +
                with_unit(c.push_speed, Quantity::velocity, units) + " (coulomb_speed)";
    if (c.dither > 0)
        text += ", dither of " + with_unit(c.dither, Quantity::command, units) + " at " +
                with_unit(c.dither_frequency, Quantity::angular_frequency, units);
    return text;
}

/// Between which ends the number that was chosen may lie.
std::string window_text(const SetPointChoice& c, Units units)
{
    const auto effort = [&](double value) { return with_unit(value, Quantity::command, units); };
    switch (c.way) {
        case SetPointWay::dead_zone:
        case SetPointWay::push_and_dead_zone:
            return is_set(c.low) ? "dead zone from " + with_unit(c.low, Quantity::position, units) : "none found";
        case SetPointWay::push:
        case SetPointWay::push_without_integral:
        case SetPointWay::dither_without_integral:
            if (!(c.low < c.high))
                return "none: the drop from static to kinetic friction, " + effort(c.low) +
                       ", is not below the static friction, " + effort(c.high);
            return range_text(c.low, c.high, Quantity::command, units, {"", " to ", ""});
        default:
            return "–";
    }
}

bool hunts_somewhere(const SetPointChoice& c)
{
    return std::any_of(c.proofs.begin(), c.proofs.end(),
                       [](const SetPointProof& p) { return p.answer.hunting == Hunting::yes; });
}

bool diverges_somewhere(const SetPointChoice& c)
{
    return std::any_of(c.proofs.begin(), c.proofs.end(), [](const SetPointProof& p) { return p.answer.diverges(); });
}

/// Why none of the frictions makes it hunt: closed form, or what was followed.
std::string proof_text(const SetPointProof& p, Units units)
{
    const auto& s = p.answer;
    if (s.starts == 0) return s.method == SetPointMethod::closed_form ? "closed form" : std::string(name_of(s.method));
    const auto length = [&](double value) { return with_unit(value, Quantity::position, units); };
    std::string text = fmt::format("{} slips followed from starts of {} to {}", s.starts, length(s.searched_from),
                                   length(s.searched_to));
    if (is_set(s.largest_ratio)) text += fmt::format(", each ended at {:.3g} of its start at most", s.largest_ratio);
    return text;
}

}  // namespace

std::string way_text(SetPointWay way)
{
    switch (way) {
        case SetPointWay::as_described:
            return "as described";
        case SetPointWay::no_integral:
            return "without an integral";
        case SetPointWay::dead_zone:
            return "dead zone of the error";
        case SetPointWay::push:
            return "Coulomb push towards the set point";
        case SetPointWay::push_without_integral:
            return "Coulomb push towards the set point, without an integral";
        case SetPointWay::push_and_dead_zone:
            return "Coulomb push towards the set point and a dead zone";
        case SetPointWay::dither_without_integral:
            return "dither, without an integral";
    }
    return "";
}

std::string set_point_design_text(const SetPointDesign& design, Units units)
{
    std::string text;
    if (design.best < 0 && design.k_i_limit == 0) {
        text =
            "The loop is unstable while the joint moves, with every k_{i} and without one: no choice made here holds a "
            "set point in it. Change k_{p}, k_{v} or the delays of the loop first.";
    } else if (design.best < 0) {
        text = "None of the solutions tried prevents hunting for every friction within the margin.";
    } else {
        const auto& c = design.choices[static_cast<std::size_t>(design.best)];
        text = "Least error without hunting: " + way_text(c.way) + ", " + numbers_text(c, units) + ". ";
        text += c.rest_error > 0
                    ? "It rests up to " + with_unit(c.rest_error, Quantity::position, units) + " from the set point."
                    : "It settles at the set point.";
        if (c.way == SetPointWay::push || c.way == SetPointWay::push_without_integral)
            text += " Above " + with_unit(c.high, Quantity::command, units) +
                    " the push alone would move the joint (over-compensation)" +
                    (c.low > 0 ? ", below " + with_unit(c.low, Quantity::command, units) +
                                     " small slips would end further away than they began."
                               : ".");
        if (c.way == SetPointWay::dither_without_integral)
            text += " Above " + with_unit(c.high, Quantity::command, units) +
                    ", the kinetic friction, the dither may keep the joint moving.";
    }
    if (design.k_i_assumed && design.k_i_limit > 0)
        text += " The joint has no k_{i}: a tenth of the largest with which the loop is stable was assumed.";
    return text;
}

std::vector<Table> set_point_design_tables(const SetPointDesign& design, Units units)
{
    Table ways;
    ways.title = "Solutions to hold a set point";
    ways.columns = {"way", "parameters", "may lie in", "hunts", "largest error at rest"};
    for (const auto& c : design.choices)
        ways.rows.push_back({way_text(c.way), is_set(c.k_i) ? numbers_text(c, units) : "–", window_text(c, units),
                             c.holds                 ? "no"
                             : c.proofs.empty()      ? "not possible"
                             : hunts_somewhere(c)    ? "yes"
                             : diverges_somewhere(c) ? "no, it diverges"
                                                     : "undecided",
                             c.holds ? with_unit(c.rest_error, Quantity::position, units) : "–"});
    std::vector<Table> tables{ways};
    if (design.best < 0) return tables;
    Table proofs;
    proofs.title = "Why the best choice does not hunt";
    proofs.columns = {"static friction", "kinetic friction", "because", "shown by"};
    for (const auto& p : design.choices[static_cast<std::size_t>(design.best)].proofs)
        proofs.rows.push_back({with_unit(p.breakaway, Quantity::effort, units),
                               with_unit(p.coulomb, Quantity::effort, units), set_point_reason(p.answer.reason),
                               proof_text(p, units)});
    tables.push_back(proofs);
    return tables;
}

}  // namespace stickslip
