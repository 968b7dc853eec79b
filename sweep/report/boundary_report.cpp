#include "sweep/report/boundary_report.h"

#include "analysis/joint/parameters.h"
#include "analysis/results/text.h"
#include "analysis/stability/verdict.h"
#include "sweep/files/spec_file.h"
#include "sweep/report/curve_margins.h"
#include "sweep/report/map_figures.h"
#include "sweep/report/verdict_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

using Tone = Headline::Tone;
constexpr int map_nodes = 81;

std::string scientific(double value)
{
    if (!(value > 0)) return "0";
    const int exponent = static_cast<int>(std::floor(std::log10(value)));
    return fmt::format("{:.1f}×10^{{{}{}}}", value / std::pow(10, exponent), exponent < 0 ? "−" : "",
                       std::abs(exponent));
}

std::string direction_text(int direction)
{
    return direction > 0 ? "unstable above" : direction < 0 ? "stable above" : "–";
}

Table ray_table(const Joint& design, const LocatedRay& ray)
{
    const auto motion = design.mechanism.motion;
    Table table;
    table.title = std::string(name_of(ray.kind)) + " boundaries along " + ray.axis.symbol;
    table.columns = {
        ray.axis.name + " " + ray.axis.symbol, "side", "relative bracket", "status", "method", "evaluations"};
    for (const auto& p : ray.points)
        table.rows.push_back({with_unit(p.value, ray.axis.quantity, motion, 10), direction_text(p.direction),
                              scientific(p.precision()), p.converged ? "located" : "coarse",
                              std::string(name_of(p.method)), std::to_string(p.evaluations)});
    return table;
}

Table guard_table(const std::vector<FollowedBoundary>& curves)
{
    Table table;
    table.title = "How each curve was followed";
    table.columns = {"kind", "pieces", "points", "coarsest bracket", "evaluations", "ends", "what could be missed"};
    for (const auto& c : curves) {
        std::string ends;
        for (const auto& piece : c.pieces) {
            ends += ends.empty() ? "" : "; ";
            ends += piece.last == CurveEnd::closed
                        ? std::string("closed")
                        : std::string(name_of(piece.first)) + " – " + std::string(name_of(piece.last));
        }
        table.rows.push_back({std::string(name_of(c.kind)), std::to_string(c.pieces.size()), std::to_string(c.points()),
                              scientific(c.precision()), std::to_string(c.evaluations), ends.empty() ? "–" : ends,
                              could_be_missed(c)});
    }
    return table;
}

bool same_axes(const FollowedBoundary& a, const FollowedBoundary& b)
{
    return a.x.path == b.x.path && a.y.path == b.y.path && a.x.values == b.x.values && a.y.values == b.y.values;
}

Figure curve_figure(const BoundaryAnswer& answer, const std::vector<FollowedBoundary>& curves,
                    const ParallelFor& parallel)
{
    const auto& first = curves.front();
    auto map = map_under(answer.design, first.x, first.y, parallel);
    std::string kinds;
    for (const auto& c : curves) {
        if (!c.pieces.empty()) map.curves.push_back(curve_with_brackets(c));
        kinds += (kinds.empty() ? "" : ", ") + std::string(name_of(c.kind)) + " (" + std::to_string(c.points()) +
                 " points, brackets ≤ " + scientific(c.precision()) + ")";
    }
    Figure figure;
    figure.id = chart_id("boundaries", first.x, first.y);
    figure.finding = "Boundaries over " + first.x.name + " and " + first.y.name + ": " + kinds + ".";
    figure.caption =
        "Located curves: " + kinds +
        ". Brackets that are wider than the line are drawn across it. Field: largest real part of the spectrum, with "
        "memory.";
    figure.picture = std::move(map);
    return figure;
}

/// What lies beyond a range without boundaries.
std::string outside_text(const LocatedRay& ray, Motion motion)
{
    if (!ray.outside) return "";
    const auto& o = *ray.outside;
    const auto quantity = ray.axis.quantity;
    if (!o.nearest)
        return " None lies within " + with_unit(o.low, quantity, motion) + " … " + with_unit(o.high, quantity, motion) +
               " either.";
    return " The nearest one outside lies at " + ray.axis.symbol + " = " +
           with_unit(o.nearest->value, quantity, motion, ray.kind == BoundaryKind::outcome ? 4 : 8) + ".";
}

/// What the scanned points of a ray without boundaries say.
std::string throughout(const LocatedRay& ray)
{
    if (ray.kind == BoundaryKind::fold) return "";
    const double judged = 1 - static_cast<double>(ray.undecided) / ray.nodes;
    const char* side = ray.stable_share == 0               ? ": unstable "
                       : ray.stable_share > judged - 1e-12 ? ": stable "
                                                           : nullptr;
    if (!side) return "";
    return side + (ray.undecided == 0
                       ? std::string("throughout")
                       : "at all of the " + std::to_string(ray.nodes - ray.undecided) +
                             " scanned points that have a verdict; " + std::to_string(ray.undecided) + " have none");
}

}  // namespace

std::string could_be_missed(const LocatedRay& ray)
{
    std::string text = fmt::format("two boundaries of one kind within 1/{} of the range", ray.nodes - 1);
    if (ray.climbed > 0) text += fmt::format(" ({} near touches were searched)", ray.climbed);
    if (ray.kind == BoundaryKind::fold)
        text += "; cycles that neither a subcritical linear boundary nor a start from near rest leads to";
    if (ray.undecided > 0) text += fmt::format("; {} of {} scanned points have no verdict", ray.undecided, ray.nodes);
    return text;
}

std::string could_be_missed(const FollowedBoundary& c)
{
    std::string text = fmt::format("a closed piece smaller than 1/{:.0f} of an axis", 1 / c.guard.cell);
    if (c.guard.climbed > 0)
        text += fmt::format(" that none of {} climbs between the nodes met ({} islands found so)", c.guard.climbed,
                            c.guard.islands);
    if (c.kind == BoundaryKind::fold)
        text += "; cycles that neither a subcritical linear boundary nor a start from near rest leads to";
    if (c.guard.unexplained > 0)
        text += fmt::format("; {} of {} changes of side on the grid were not followed", c.guard.unexplained,
                            c.guard.changes);
    if (c.guard.undecided > 0)
        text += fmt::format("; {} of {} grid points have no verdict", c.guard.undecided, c.guard.nodes);
    return text;
}

std::string ray_text(const Joint& design, const LocatedRay& ray)
{
    const auto motion = design.mechanism.motion;
    const std::string range = with_unit(ray.axis.values.front(), ray.axis.quantity, motion) + " … " +
                              with_unit(ray.axis.values.back(), ray.axis.quantity, motion);
    if (ray.undecided == ray.nodes) {
        Joint first = design;
        *find_parameter(first, ray.axis.path) = ray.axis.values.front();
        const auto reason = linear_verdict(first).steady.reason;
        return "No verdict along " + ray.axis.symbol + ": the joint cannot be judged at any of the " +
               std::to_string(ray.nodes) + " points of the scan" +
               (reason == Reason::none ? "." : ". At the first: " + reason_text(reason) + ".");
    }
    if (ray.points.empty())
        return "No " + std::string(name_of(ray.kind)) + " boundary along " + ray.axis.symbol + " within " + range +
               throughout(ray) + "." + outside_text(ray, motion);
    std::string text = std::string(name_of(ray.kind)) + " boundary along " + ray.axis.symbol + " at ";
    for (const auto& p : ray.points)
        text += (&p == &ray.points.front() ? "" : ", ") + with_unit(p.value, ray.axis.quantity, motion, 8) + " (" +
                direction_text(p.direction) + ")";
    return text + ".";
}

StabilityMap map_under(const Joint& design, Axis x, Axis y, const ParallelFor& parallel)
{
    x.values = spaced(x.values.front(), x.values.back(), map_nodes, x.log);
    y.values = spaced(y.values.front(), y.values.back(), map_nodes, y.log);
    StabilityMap map;
    map.motion = design.mechanism.motion;
    map.title = "Boundaries of sliding over (" + x.symbol + ", " + y.symbol + ")";
    map.abscissa.resize(x.values.size() * y.values.size());
    map.region.resize(map.abscissa.size());
    parallel(y.values.size(), [&](std::size_t j) {
        Joint joint = design;
        double &u = *find_parameter(joint, x.path), &v = *find_parameter(joint, y.path);
        for (std::size_t i = 0; i < x.values.size(); ++i) {
            u = x.values[i], v = y.values[j];
            const auto row = linear_point(joint);
            map.abscissa[j * x.values.size() + i] = row.spectral_abscissa;
            map.region[j * x.values.size() + i] = row.region;
        }
    });
    const auto shares = area_shares(x, y);
    for (std::size_t i = 0; i < shares.size(); ++i) {
        if (map.region[i] == Region::memory_only || map.region[i] == Region::velocity_only)
            map.disagreement += shares[i];
        if (map.region[i] == Region::undecided) map.undecided += shares[i];
    }
    Joint joint = design;
    const auto row = linear_point(design);
    map.design.x = *find_parameter(joint, x.path), map.design.y = *find_parameter(joint, y.path);
    map.design.inside = map.design.x >= x.values.front() && map.design.x <= x.values.back() &&
                        map.design.y >= y.values.front() && map.design.y <= y.values.back();
    map.design.region = row.region;
    map.design.spectral_abscissa = row.spectral_abscissa;
    map.has_design = true;
    map.x = std::move(x), map.y = std::move(y);
    return map;
}

Report boundary_report(const BoundaryAnswer& answer, const ParallelFor& parallel)
{
    Report report;
    report.title = answer.title.empty() ? "Boundaries of sliding" : answer.title;
    report.subtitle = "boundaries, located";
    for (const auto& ray : answer.rays)
        report.verdict += (report.verdict.empty() ? "" : " ") + ray_text(answer.design, ray);
    if (!answer.curves.empty()) {
        report.verdict += (report.verdict.empty() ? "" : " ") + meeting_text(answer.design, answer.curves);
        report.headlines = meeting_headlines(answer.design, answer.curves);
    }
    if (linear_point(answer.design).spectral_abscissa > 0) {
        report.tone = Tone::bad;
        report.alerts.push_back({Tone::bad, "The design itself is unstable: small disturbances of sliding grow."});
    }
    Section curves{"curves", "Curves", "", {}, {}};
    for (std::size_t i = 0; i < answer.curves.size();) {
        std::vector<FollowedBoundary> together;
        while (i < answer.curves.size() && (together.empty() || same_axes(together.front(), answer.curves[i])))
            together.push_back(answer.curves[i++]);
        curves.figures.push_back(curve_figure(answer, together, parallel));
        if (auto sharp = precision_figure(together, answer.design.mechanism.motion);
            !std::get<LineChart>(sharp.picture).lines.empty())
            curves.figures.push_back(std::move(sharp));
    }
    if (!answer.curves.empty()) {
        curves.tables.push_back(guard_table(answer.curves));
        report.sections.push_back(std::move(curves));
    }
    Section rays{"rays", "Along single parameters", "", {}, {}};
    for (const auto& ray : answer.rays)
        if (!ray.points.empty()) rays.tables.push_back(ray_table(answer.design, ray));
    if (!rays.tables.empty()) report.sections.push_back(std::move(rays));
    for (const auto& ray : answer.rays)
        report.not_checked.push_back(std::string(name_of(ray.kind)) + " along " + ray.axis.symbol + ": " +
                                     could_be_missed(ray) + ".");
    for (const auto& c : answer.curves) {
        report.not_checked.push_back(std::string(name_of(c.kind)) + " over " + c.x.symbol + " and " + c.y.symbol +
                                     ": " + could_be_missed(c) + ".");
        for (const auto& piece : c.pieces)
            for (const auto end : {piece.first, piece.last})
                if (end == CurveEnd::lost)
                    report.alerts.push_back({Tone::warning, "A piece of the " + std::string(name_of(c.kind)) +
                                                                " boundary could not be followed to its end."});
    }
    report.provenance = {{"command", answer.command}};
    return report;
}

}  // namespace stickslip
