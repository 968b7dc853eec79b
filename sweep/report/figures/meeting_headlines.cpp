#include "sweep/report/figures/meeting_headlines.h"

#include "analysis/results/text.h"
#include "analysis/results/unit_axis.h"
#include "sweep/report/figures/map_figures.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stickslip {
namespace {

constexpr double line_width = 0.004;  ///< of a chart's axis, as lines are drawn

std::string kind_words(BoundaryKind kind)
{
    switch (kind) {
        case BoundaryKind::velocity_only:
            return "velocity-only boundary";
        case BoundaryKind::state_variable:
            return "linear boundary with memory";
        case BoundaryKind::fold:
            return "fold of limit cycles";
        case BoundaryKind::v_min:
            return "least velocity V_{min}";
        case BoundaryKind::hunting:
            return "boundary of hunting";
        case BoundaryKind::outcome:
            break;
    }
    return "boundary of the outcome";
}

/// What happens there, for who does not know the name.
std::string meaning_of(BoundaryKind kind)
{
    if (kind == BoundaryKind::state_variable) return ", where small disturbances turn from decay to growth";
    return kind == BoundaryKind::fold ? ", where stick-slip cycles appear or vanish" : "";
}

/// What a boundary of hunting is from the design's side: hunting ends there, begins there, or gives way to something
/// worse.
std::string hunting_boundary(const SetPoint& beyond)
{
    if (beyond.diverges()) return "where hunting gives way to divergence";
    return beyond.hunting == Hunting::yes ? "where hunting begins" : "where hunting ends";
}

std::string met(const Meeting& m)
{
    return m.beyond ? hunting_boundary(*m.beyond) : "the " + kind_words(m.kind) + meaning_of(m.kind);
}

}  // namespace

std::vector<Headline> meeting_headlines(const std::vector<Meeting>& meetings, Units units)
{
    constexpr std::size_t most = 5;
    std::vector<Headline> list;
    for (const auto& m : meetings) {
        if (m.own == 0 || list.size() == most) continue;
        const double change = (m.at - m.own) / std::abs(m.own);
        const bool no_cure = m.beyond && m.beyond->diverges();
        list.push_back({no_cure ? Headline::Tone::bad : Headline::Tone::neutral,
                        m.axis.symbol + (change < 0 ? " −" : " +") + plain_number(100 * std::abs(change)) + " %",
                        "from the design to " + met(m) + ": " +
                            range_text(m.own, m.at, m.axis.quantity, units, {"", " to ", ""}, 4)});
    }
    return list;
}

std::string meeting_text(const std::vector<Meeting>& meetings, Units units)
{
    std::string text, path;
    for (const auto& m : meetings) {
        if (!m.on_chart || (!path.empty() && m.axis.path != path)) continue;
        text += (path.empty() ? "Through the design along " + m.axis.symbol + ": " : ", ") +
                (m.beyond ? hunting_boundary(*m.beyond) : kind_words(m.kind)) + " at " +
                with_unit(m.at, m.axis.quantity, units, 4);
        path = m.axis.path;
    }
    return text.empty() ? "No followed curve meets the design's own lines through the chart." : text + ".";
}

Figure precision_figure(const std::vector<FollowedBoundary>& curves, Units units)
{
    const auto& x = curves.front().x;
    LineChart chart;
    chart.title = "How sharply each point is located";
    chart.x_label = {x.name + " " + x.symbol, std::string(unit_of(x.quantity, units))};
    chart.y_label = {"relative width of the bracket", "1"};
    chart.x_log = x.log, chart.y_log = true;
    for (const auto& curve : curves) {
        LineChart::Line line{std::string(name_of(curve.kind)), {}, {}};
        for (const auto& piece : curve.pieces) {
            if (!line.x.empty()) line.x.push_back(missing), line.y.push_back(missing);
            for (const auto& p : piece.points) {
                line.x.push_back(p.x);
                line.y.push_back(std::max(p.at.precision(), std::numeric_limits<double>::epsilon()));
            }
        }
        if (!line.x.empty()) chart.lines.push_back(std::move(line));
    }
    Figure figure;
    figure.id = chart_id("precision", curves.front().x, curves.front().y);
    figure.caption =
        "The true crossing lies within the bracket of its point, along the axis that the curve crosses more steeply. "
        "The brackets themselves are in boundary.csv and boundary.json.";
    figure.finding = chart.title;
    figure.picture = std::move(chart);
    return figure;
}

Curve curve_with_brackets(const FollowedBoundary& boundary)
{
    auto curve = curve_of(boundary);
    const UnitAxis x(boundary.x), y(boundary.y);
    for (const auto& piece : boundary.pieces)
        for (const auto& p : piece.points) {
            const UnitAxis& unit = p.along_y ? y : x;
            if (!(unit.unit(p.at.high) - unit.unit(p.at.low) > line_width)) continue;
            curve.x.insert(curve.x.end(), {missing, p.along_y ? p.x : p.at.low, p.along_y ? p.x : p.at.high});
            curve.y.insert(curve.y.end(), {missing, p.along_y ? p.at.low : p.y, p.along_y ? p.at.high : p.y});
        }
    return curve;
}

}  // namespace stickslip
