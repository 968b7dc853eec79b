#include "sweep/words/margins_text.h"

#include "analysis/joint/parameters.h"
#include "analysis/results/text.h"
#include "sweep/words/heading_text.h"
#include "sweep/words/idle_text.h"
#include "sweep/words/loop_text.h"
#include "sweep/words/nearest_text.h"
#include "sweep/words/plain_text.h"
#include "sweep/words/reason_text.h"
#include "sweep/words/symbols.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace stickslip {

std::string coordinate_text(const Coordinate& c, Units units)
{
    return symbol_of(c.path, units) + (c.less.empty() ? "" : " − " + symbol_of(c.less, units));
}

std::string signed_percent(double share)
{
    return (share < 0 ? "−" : "+") + plain_number(100 * std::abs(share), 3) + " %";
}

namespace {

std::string worst_text(const MarginsAnswer& a)
{
    if (!a.worst) return "";
    std::string within;
    for (std::size_t i = 0; i < a.uncertainty.share.size(); ++i)
        within += (i ? ", " : "") + coordinate_text(a.uncertainty.coordinates[i], units_of(a.joint)) + " ± " +
                  plain_number(100 * a.uncertainty.share[i]) + " %";
    std::string at;
    for (std::size_t i = 0; i < a.worst->deviations.size(); ++i)
        at += (i ? ", " : "") + coordinate_text(a.uncertainty.coordinates[i], units_of(a.joint)) + " " +
              signed_percent(a.worst->deviations[i]);
    std::string left_out;
    for (const auto& axis : a.idle) left_out += (left_out.empty() ? "" : "; ") + idle_words(axis);
    if (a.only_idle()) return " Nothing is said of " + within + ": " + left_out + ".";
    if (!left_out.empty()) left_out = " This does not judge everything: " + left_out + ".";
    if (a.worst->undecided > 0)
        left_out += " " + counted(a.worst->undecided, "joint") + " of " + std::to_string(a.worst->evaluations) +
                    " within it had no verdict.";
    const bool box = a.uncertainty.shape == UncertaintyShape::box;
    const double growth = a.worst->instability;
    const std::string off = " With " + within + (box ? "" : " (all together within an ellipsoid)");
    if (std::isnan(growth)) return off + " the worst joint is undecided." + left_out;
    return off +
           (growth < 0 ? " the joint stays stable; least so at " + at + ", where disturbances still decay at "
                       : " the joint can become unstable: at " + at + " disturbances grow at ") +
           plain_number(std::abs(growth)) + " 1/s." + left_out;
}

}  // namespace

std::string alone_name(const MarginsAnswer& a, std::size_t place)
{
    const Units units = units_of(a.joint);
    const auto name = coordinate_text(a.alone_of[place], units);
    const auto alike =
        std::ranges::count_if(a.alone_of, [&](const Coordinate& c) { return coordinate_text(c, units) == name; });
    if (alike < 2) return name;
    for (const std::string body : {"motor", "transmission", "link"})
        if (a.alone_of[place].path.find('.' + body + '.') != std::string::npos) return name + " of the " + body;
    return name;
}

Table alone_table(const MarginsAnswer& a)
{
    const Units units = units_of(a.joint);
    Table table;
    table.title = "One parameter at a time, within a factor of ten";
    table.columns = {"parameter", "value", "boundary", "change"};
    for (std::size_t i = 0; i < a.alone.size(); ++i) {
        const auto& c = a.alone_of[i];
        const auto quantity = quantity_of(a.joint, c.path);
        const auto& n = a.alone[i];
        table.rows.push_back({alone_name(a, i), with_unit(value_of(a.joint, c), quantity, units, 5),
                              n.found ? with_unit(n.moves[0].to, quantity, units, 5) : "none within ×10",
                              n.found ? signed_percent(n.moves[0].to / n.moves[0].from - 1) : "–"});
    }
    return table;
}

std::string alone_lines(const MarginsAnswer& a)
{
    std::string text;
    const auto table = alone_table(a);
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        const auto& row = table.rows[i];
        text += fmt::format("  {:<24} {:>16}  ", plain_text(row[0]), plain_text(row[1])) +
                (a.alone[i].found ? fmt::format("boundary at {:<18} {}\n", plain_text(row[2]), plain_text(row[3]))
                                  : "no boundary within ×10\n");
    }
    if (a.robust)
        text += "robust boundary: " + counted(static_cast<long long>(a.robust->pieces.size()), "piece") + ", " +
                counted(a.robust->points(), "point") + "\n";
    return text;
}

std::vector<Headline> margins_headlines(const MarginsAnswer& a)
{
    using Tone = Headline::Tone;
    const Units units = units_of(a.joint);
    std::vector<Headline> list{nearest_headline(a.nearest, units)};
    if (const auto nearest = a.shortest_alone) {
        const auto& move = a.alone[*nearest].moves[0];
        const auto quantity = quantity_of(a.joint, move.path);
        list.push_back({Tone::neutral,
                        coordinate_text({move.path, move.less}, units) + " " + signed_percent(move.to / move.from - 1),
                        "is the nearest boundary for one parameter alone: " +
                            range_text(move.from, move.to, quantity, units, from_to, 4)});
    }
    if (a.nearest.found)
        list.push_back({Tone::neutral, off_text(a.tolerance_each),
                        "in " + uncertain_numbers(a.nearest, units) + " at once cannot reach the boundary (distance " +
                            plain_number(a.nearest.distance) + ")"});
    if (a.worst && is_set(a.worst->instability) && !a.only_idle())
        list.push_back({a.worst->instability < 0 ? Tone::good : Tone::bad,
                        with_unit(a.worst->instability, Quantity::rate, units),
                        "max Re s of the worst joint within the stated uncertainty; stable below 0"});
    return list;
}

std::string margins_text(const MarginsAnswer& a)
{
    if (!a.nearest.decided) return "No margin, as the joint has no verdict: " + reason_text(a.reason) + ".";
    std::string text = nearest_text(a.nearest, units_of(a.joint));
    if (a.nearest.found)
        text += " The boundary is not reached as long as " + uncertain_numbers(a.nearest, units_of(a.joint)) +
                " are off by at most " + off_text(a.tolerance_each) + " each (distance " +
                plain_number(a.nearest.distance) + ").";
    return text + worst_text(a) + loop_text(a.loop);
}

}  // namespace stickslip
