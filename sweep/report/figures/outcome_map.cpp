#include "sweep/report/figures/outcome_map.h"

#include "analysis/diagnosis/outcomes/side.h"
#include "analysis/results/text.h"
#include "sweep/words/line_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

using gap::LawFit;
using gap::OutcomeAnswer;

const char* const k_p_path = "control.k_p";
const char* const v0_path = "control.V0";

/// A line's pieces, NaN between them.
void add_piece(FieldMap::Line& line, std::initializer_list<std::pair<double, double>> points)
{
    for (const auto& [x, y] : points) line.x.push_back(x), line.y.push_back(y);
    line.x.push_back(not_set), line.y.push_back(not_set);
}

/// Where a law changes side along the stiffness, neighbours joined while they are as many.
FieldMap::Line boundary_line(const Joint& at, const LawFit& fit, const std::vector<double>& velocities,
                             const std::vector<double>& stiffnesses, std::string name, bool dashed)
{
    FieldMap::Line line{std::move(name), {}, {}, dashed};
    const auto side = [&](double V, double k) {
        Joint joint = fit.rival ? gap::with_law(at, fit.law) : at;
        joint.control.V0 = V, joint.control.k_p = k;
        return gap::distance_to_stick_slip(joint);
    };
    std::vector<double> before;
    double V_before = 0;
    for (const double V : velocities) {
        std::vector<double> crossings;
        double last = side(V, stiffnesses.front());
        for (std::size_t i = 1; i < stiffnesses.size(); ++i) {
            const double here = side(V, stiffnesses[i]);
            if ((last > 0) != (here > 0)) {
                double low = stiffnesses[i - 1], high = stiffnesses[i];
                constexpr int halvings = 10;
                for (int n = 0; n < halvings; ++n) {
                    const double middle = std::sqrt(low * high);
                    ((side(V, middle) > 0) == (last > 0) ? low : high) = middle;
                }
                crossings.push_back(std::sqrt(low * high));
            }
            last = here;
        }
        if (crossings.size() == before.size())
            for (std::size_t i = 0; i < crossings.size(); ++i)
                add_piece(line, {{V_before, before[i]}, {V, crossings[i]}});
        before = crossings, V_before = V;
    }
    return line;
}

/// The measured rows with one velocity gain, as small crosses and diamonds.
struct Marks {
    int rows = 0;
    FieldMap::Line sticks{"measured: stick-slip (×)", {}, {}, false}, slides{"measured: slides (◇)", {}, {}, false};
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

Figure outcome_map(const OutcomeAnswer& a, const Joint& nominal, double k_v, int number)
{
    const Units units = units_of(nominal);
    const auto& o = a.outcomes;
    double low_V = infinity, high_V = 0, low_k = infinity, high_k = 0;
    for (const auto& j : o.joints) {
        low_V = std::min(low_V, j.control.V0), high_V = std::max(high_V, j.control.V0);
        low_k = std::min(low_k, j.control.k_p), high_k = std::max(high_k, j.control.k_p);
    }
    constexpr double room = 1.6;
    constexpr int nodes = 41;
    FieldMap map;
    map.title = "Measured rows and the boundary of each law";
    map.fixed = "k_{v} = " + with_unit(k_v, Quantity::velocity_gain, units);
    map.units = units;
    map.x = {v0_path,
             "V_{0}",
             "commanded velocity",
             Quantity::velocity,
             true,
             log_steps(low_V / room, high_V * room, nodes)};
    map.y = {k_p_path,
             "k_{p}",
             "position gain",
             Quantity::position_gain,
             true,
             log_steps(low_k / room, high_k * room, nodes)};
    const LawFit& best = a.laws.front();
    Joint at = nominal;
    at.control.k_v = k_v;
    at.control.force_rate = not_set;
    map.classes = {std::string(best.rival->law) + ": slides", std::string(best.rival->law) + ": sticks and slips"};
    for (const double k : map.y.values)
        for (const double V : map.x.values) {
            Joint joint = gap::with_law(at, best.law);
            joint.control.k_p = k, joint.control.V0 = V;
            map.values.push_back(gap::distance_to_stick_slip(joint) > 0 ? 1 : 0);
        }
    const auto [rows, sticks, slides] = marks_of(o, k_v, map);
    map.lines = {sticks, slides};
    map.lines.push_back(
        boundary_line(at, best, map.x.values, map.y.values, "boundary: " + std::string(best.rival->law), false));
    const auto rival = std::find_if(a.laws.begin() + 1, a.laws.end(),
                                    [&](const auto& f) { return f.rival->memory != best.rival->memory; });
    if (rival != a.laws.end())
        map.lines.push_back(
            boundary_line(at, *rival, map.x.values, map.y.values, "boundary: " + std::string(rival->rival->law), true));
    map.statement = fmt::format("{} rows; {} misjudges {} of all {} when it has not seen them.", rows, best.rival->law,
                                best.misjudged, o.size());
    Figure figure;
    figure.id = "rows-" + std::to_string(number);
    figure.caption =
        "Crosses: stick-slip. Diamonds: smooth. Shaded: prediction of the best law. Solid: its boundary; dashed: that "
        "of the best law of the other kind" +
        (rival != a.laws.end() ? std::string(" (") + std::string(rival->rival->law) + ")." : std::string("."));
    figure.finding = map.statement;
    figure.picture = std::move(map);
    return figure;
}

}  // namespace stickslip
