#include "sweep/words/margins_text.h"

#include "analysis/joint/parameters.h"
#include "analysis/results/text.h"
#include "sweep/words/loop_text.h"
#include "sweep/words/nearest_text.h"
#include "sweep/words/symbols.h"
#include "sweep/words/verdict_text.h"

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

Quantity quantity_of(const Joint& given, const std::string& path)
{
    Joint joint = given;
    const double* number = find_parameter(joint, path);
    for (const auto& leaf : parameters(joint))
        if (leaf.value == number) return leaf.quantity;
    return Quantity::number;
}

std::vector<double> scales_of(const MarginsAnswer& a)
{
    return std::vector<double>(a.nearest.direction.size(), 1);
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
    const bool box = a.uncertainty.shape == UncertaintyShape::box;
    const double growth = a.worst->instability;
    return " Within the " + std::string(box ? "box " : "ellipsoid ") + within +
           (growth < 0 ? " it stays stable; least so at " + at + ", where disturbances still decay at "
                       : " it can turn unstable: at " + at + " disturbances grow at ") +
           plain_number(std::abs(growth)) + " 1/s.";
}

}  // namespace

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
        table.rows.push_back({coordinate_text(c, units), with_unit(value_of(a.joint, c), quantity, units, 5),
                              n.found ? with_unit(n.moves[0].to, quantity, units, 8) : "none within ×10",
                              n.found ? signed_percent(n.moves[0].to / n.moves[0].from - 1) : "–"});
    }
    return table;
}

std::string margins_text(const MarginsAnswer& a)
{
    if (!a.nearest.decided) return "No margin, as the joint has no verdict: " + reason_text(a.reason) + ".";
    std::string text = nearest_text(a.nearest, units_of(a.joint));
    if (a.nearest.found)
        text += " Without reaching it " + uncertain_numbers(a.nearest, units_of(a.joint)) + " may be off by " +
                all_at_once(a.nearest.distance, scales_of(a)) + " each, all at once (distance " +
                plain_number(a.nearest.distance) + ").";
    return text + worst_text(a) + loop_text(a.loop);
}

}  // namespace stickslip
