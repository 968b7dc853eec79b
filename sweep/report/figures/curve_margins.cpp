#include "sweep/report/figures/curve_margins.h"

#include "analysis/boundary/trace/chart.h"
#include "analysis/joint/parameters.h"
#include "analysis/results/text.h"
#include "sweep/report/figures/map_figures.h"
#include "sweep/study/beyond_curves.h"

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
            return "least stable velocity";
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

/// Where a curve meets the design's own line along one of its axes, the other number held: the meeting nearest to the
/// design, interpolated between located points; NaN where it does not.
double meeting(const FollowedBoundary& c, const Joint& given, bool along_x)
{
    const Axis &along = along_x ? c.x : c.y, &across = along_x ? c.y : c.x;
    Joint joint = given;
    const auto drawn = [](const Axis& axis, double v) { return axis.log ? std::log(v) : v; };
    const double own = drawn(along, *find_parameter(joint, along.path)),
                 held = drawn(across, *find_parameter(joint, across.path));
    double found = missing;
    for (const auto& piece : c.pieces)
        for (std::size_t i = 0; i + 1 < piece.points.size(); ++i) {
            const auto &p = piece.points[i], &q = piece.points[i + 1];
            const double a = drawn(across, along_x ? p.y : p.x) - held, b = drawn(across, along_x ? q.y : q.x) - held;
            if (a * b > 0 || a == b) continue;
            const double from = drawn(along, along_x ? p.x : p.y), to = drawn(along, along_x ? q.x : q.y);
            const double at = from + (to - from) * a / (a - b);
            if (std::isnan(found) || std::abs(at - own) < std::abs(found - own)) found = at;
        }
    return along.log ? std::exp(found) : found;
}

}  // namespace

std::vector<Headline> meeting_headlines(const Joint& design, const std::vector<LocatedRay>& rays,
                                        const std::vector<FollowedBoundary>& curves)
{
    constexpr std::size_t most = 5;
    std::vector<Headline> list;
    Joint joint = design;
    const auto motion = joint.mechanism.motion;
    const auto add = [&](const Axis& axis, BoundaryKind kind, double own, double at) {
        if (std::isnan(at) || own == 0 || list.size() == most) return;
        const double change = (at - own) / std::abs(own);
        list.push_back({Headline::Tone::neutral,
                        axis.symbol + (change < 0 ? " −" : " +") + plain_number(100 * std::abs(change)) + " %",
                        "from the design to the " + kind_words(kind) + meaning_of(kind) + ": " +
                            with_unit(own, axis.quantity, motion, 4) + " to " +
                            with_unit(at, axis.quantity, motion, 4)});
    };
    for (const auto& ray : rays) {
        const double own = *find_parameter(joint, ray.axis.path);
        if (const auto* p = nearest_point(ray, own)) add(ray.axis, ray.kind, own, p->value);
    }
    for (const auto& c : curves)
        for (const bool along_x : {true, false}) {
            const Axis& axis = along_x ? c.x : c.y;
            add(axis, c.kind, *find_parameter(joint, axis.path), meeting(c, joint, along_x));
        }
    return list;
}

std::string meeting_text(const Joint& design, const std::vector<FollowedBoundary>& curves)
{
    const auto motion = design.mechanism.motion;
    for (const bool along_x : {true, false}) {
        std::string text;
        for (const auto& c : curves)
            if (const double at = meeting(c, design, along_x); !std::isnan(at)) {
                const Axis& axis = along_x ? c.x : c.y;
                text += (text.empty() ? "Through the design along " + axis.symbol + ": " : ", ") + kind_words(c.kind) +
                        " at " + with_unit(at, axis.quantity, motion, 4);
            }
        if (!text.empty()) return text + ".";
    }
    return "No followed curve meets the design's own lines through the chart.";
}

Figure precision_figure(const std::vector<FollowedBoundary>& curves, Motion motion)
{
    const auto& x = curves.front().x;
    LineChart chart;
    chart.title = "How sharply each point is located";
    chart.x_label = {x.name + " " + x.symbol, std::string(unit_of(x.quantity, motion))};
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
