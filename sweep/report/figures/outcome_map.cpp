#include "sweep/report/figures/outcome_map.h"

#include "analysis/results/text.h"

#include <fmt/format.h>

#include <cmath>

namespace stickslip {
namespace {

using gap::LawFit;
using gap::OutcomeAnswer;

/// A line's pieces, NaN between them.
void add_piece(FieldMap::Line& line, std::initializer_list<std::pair<double, double>> points)
{
    for (const auto& [x, y] : points) line.x.push_back(x), line.y.push_back(y);
    line.x.push_back(not_set), line.y.push_back(not_set);
}

/// The measured rows with one velocity gain, as small crosses and diamonds.
struct Marks {
    int rows = 0;
    FieldMap::Line sticks{"measured: stick-slip", {}, {}, false}, slides{"measured: slides", {}, {}, false};
};

Marks marks_of(const gap::Outcomes& o, double k_v, const FieldMap& map)
{
    Marks marks;
    const double dx = std::pow(map.x.values.back() / map.x.values.front(), 0.009);
    const double dy = std::pow(map.y.values.back() / map.y.values.front(), 0.013);
    for (std::size_t i = 0; i < o.size(); ++i) {
        const auto& c = o.joints[i].control;
        if (c.k_v != k_v) continue;
        ++marks.rows;
        const double x = c.V0, y = c.k_p;
        if (o.table.rows[i].stick_slip) {
            add_piece(marks.sticks, {{x / dx, y / dy}, {x * dx, y * dy}});
            add_piece(marks.sticks, {{x / dx, y * dy}, {x * dx, y / dy}});
        } else {
            add_piece(marks.slides, {{x, y / dy}, {x * dx, y}, {x, y * dy}, {x / dx, y}, {x, y / dy}});
        }
    }
    return marks;
}

}  // namespace

Figure outcome_map(const OutcomeAnswer& a, const OutcomeMap& found, std::size_t number)
{
    const auto& o = a.outcomes;
    const LawFit& best = a.laws.front();
    const std::string law(best.rival->law);
    FieldMap map;
    map.units = units_of(a.after);
    map.title = "Measured rows and the boundary of each law";
    map.fixed = "k_{v} = " + with_unit(found.k_v, Quantity::velocity_gain, map.units);
    map.x = found.x, map.y = found.y;
    map.classes = {law + ": slides", law + ": sticks and slips"};
    map.values = found.sticks;
    const auto [rows, sticks, slides] = marks_of(o, found.k_v, map);
    map.lines = {sticks, slides};
    map.lines.push_back({"boundary: " + law, found.boundary.x, found.boundary.y, false});
    const std::string other = found.other ? std::string(found.other->rival->law) : "";
    if (found.other) map.lines.push_back({"boundary: " + other, found.other_boundary.x, found.other_boundary.y, true});
    map.statement = fmt::format("{} rows; {} misjudges {} of all {} when it has not seen them.", rows, best.rival->law,
                                best.misjudged, o.size());
    Figure figure;
    figure.id = "rows-" + std::to_string(number);
    figure.caption =
        "Crosses: stick-slip. Diamonds: smooth. Shaded: prediction of the best law. Solid: its boundary; dashed: that "
        "of the best law of the other kind" +
        (other.empty() ? "." : " (" + other + ").");
    figure.finding = map.statement;
    figure.picture = std::move(map);
    return figure;
}

}  // namespace stickslip
