#include "sweep/report/pages/boundary_report.h"

#include "analysis/joint/parameters.h"
#include "analysis/results/text.h"
#include "analysis/stability/verdict.h"
#include "sweep/files/toml/spec_file.h"
#include "sweep/report/figures/beyond_curves.h"
#include "sweep/report/figures/curve_margins.h"
#include "sweep/report/figures/hunting_map.h"
#include "sweep/report/figures/map_figures.h"
#include "sweep/study/hunting_field.h"
#include "sweep/study/samples.h"
#include "sweep/words/set_point_text.h"

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
    table.columns = {
        "kind", "pieces", "points", "coarsest bracket", "evaluations", "ends", "not excluded by this search"};
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

Figure curve_figure(StabilityMap map, const std::vector<FollowedBoundary>& curves, const std::string& outcome_means)
{
    const auto& first = curves.front();
    std::string kinds;
    bool outcomes = false;
    for (const auto& c : curves) {
        kinds += (kinds.empty() ? "" : ", ") + std::string(name_of(c.kind)) + " (" + std::to_string(c.points()) +
                 " points, brackets ≤ " + scientific(c.precision()) + ")";
        outcomes = outcomes || c.kind == BoundaryKind::outcome;
    }
    const double bistable = share_of_area(map, Region::bistable);
    Figure figure;
    figure.id = chart_id("boundaries", first.x, first.y);
    figure.finding = "Boundaries over " + first.x.name + " and " + first.y.name + ": " + kinds + ".";
    figure.caption =
        "Located curves: " + kinds +
        ". Brackets that are wider than the line are drawn across it. Field: largest real part of the spectrum, with "
        "memory.";
    if (outcomes) figure.caption += " Outcomes follow a disturbance: " + outcome_means + ".";
    if (bistable > 0) {
        figure.finding += " " + percent(bistable) + " of the chart is bistable.";
        figure.caption += " On " + percent(bistable) +
                          " of the chart, up to the curve of the nonlinear joint, small disturbances decay and a "
                          "larger one ends in stick-slip.";
    }
    figure.picture = std::move(map);
    return figure;
}

/// The map under all curves of one pair of axes, with what lies between linear and nonlinear ones.
StabilityMap marked_map(const Joint& design, const std::vector<FollowedBoundary>& curves, const ParallelFor& parallel)
{
    auto map = map_under(design, curves.front().x, curves.front().y, parallel);
    mark_bistable(map, curves);
    for (const auto& c : curves)
        if (!c.pieces.empty()) map.curves.push_back(curve_with_brackets(c));
    return map;
}

/// Curves that share their axes stand together.
std::vector<std::vector<FollowedBoundary>> charts_of(const std::vector<FollowedBoundary>& curves)
{
    std::vector<std::vector<FollowedBoundary>> charts;
    for (const auto& c : curves) {
        if (charts.empty() || !same_axes(charts.back().front(), c)) charts.emplace_back();
        charts.back().push_back(c);
    }
    return charts;
}

bool is_hunting(BoundaryKind kind)
{
    return kind == BoundaryKind::hunting;
}

/// What one chart's curves show: sliding under all of them, and what a set point does under those of hunting.
void add_charts(Section& section, Region& region, const BoundaryAnswer& answer,
                const std::vector<FollowedBoundary>& together, const ParallelFor& parallel)
{
    const auto motion = answer.design.mechanism.motion;
    std::vector<FollowedBoundary> hunting;
    for (const auto& c : together)
        if (is_hunting(c.kind)) hunting.push_back(c);
    if (hunting.size() < together.size()) {
        auto map = marked_map(answer.design, together, parallel);
        if (map.design.region == Region::bistable) region = Region::bistable;
        section.figures.push_back(curve_figure(std::move(map), together, answer.outcome_means));
    }
    if (!hunting.empty()) {
        const auto& first = hunting.front();
        for (auto& figure : hunting_figures(hunting_field(answer.design, first.x, first.y, parallel), hunting, motion))
            section.figures.push_back(std::move(figure));
    }
    if (auto sharp = precision_figure(together, motion); !std::get<LineChart>(sharp.picture).lines.empty())
        section.figures.push_back(std::move(sharp));
}

/// Nothing but set points was asked about.
bool asks_of_set_points_only(const BoundaryAnswer& answer)
{
    const auto hunting = [](const auto& b) { return is_hunting(b.kind); };
    return answer.set_point && std::all_of(answer.rays.begin(), answer.rays.end(), hunting) &&
           std::all_of(answer.curves.begin(), answer.curves.end(), hunting);
}

Tone set_point_tone(const SetPoint& s)
{
    if (s.hunting == Hunting::undecided) return Tone::warning;
    return s.hunting == Hunting::yes || s.reason == SetPointReason::loop_unstable ? Tone::bad : Tone::good;
}

void warn_of_lost_pieces(Report& report, const FollowedBoundary& c)
{
    for (const auto& piece : c.pieces)
        for (const auto end : {piece.first, piece.last})
            if (end == CurveEnd::lost)
                report.alerts.push_back({Tone::warning, "A piece of the " + std::string(name_of(c.kind)) +
                                                            " boundary could not be followed to its end."});
}

}  // namespace

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
    const auto& design = answer.design;
    const bool set_points_only = asks_of_set_points_only(answer);
    Report report;
    report.title = !answer.title.empty() ? answer.title
                   : set_points_only     ? "Hunting at a set point"
                                         : "Boundaries of sliding";
    report.subtitle = "boundaries, located";
    if (!answer.outcome_means.empty()) report.subtitle += " · outcomes follow a disturbance: " + answer.outcome_means;
    Section curves{"curves", "Curves", "", {}, {}};
    Region region = linear_point(design).region;
    if (beyond_rays(design, answer.rays)) region = Region::bistable;
    for (const auto& together : charts_of(answer.curves)) add_charts(curves, region, answer, together, parallel);
    if (!set_points_only) report.tone = design_tone(region), report.verdict = design_words(region);
    if (answer.set_point) {
        if (set_points_only) report.tone = set_point_tone(*answer.set_point);
        report.verdict += (set_points_only ? "" : " ") + set_point_text(*answer.set_point, design.mechanism.motion);
    }
    for (const auto& ray : answer.rays) report.verdict += " " + ray_text(design, ray);
    if (!answer.curves.empty()) report.verdict += " " + meeting_text(design, answer.curves);
    report.headlines = meeting_headlines(design, answer.rays, answer.curves);
    if (!answer.curves.empty()) {
        curves.tables.push_back(guard_table(answer.curves));
        report.sections.push_back(std::move(curves));
    }
    Section rays{"rays", "Along single parameters", "", {}, {}};
    for (const auto& ray : answer.rays)
        if (!ray.points.empty()) rays.tables.push_back(ray_table(design, ray));
    if (!rays.tables.empty()) report.sections.push_back(std::move(rays));
    const auto nonlinear = [](const auto& b) {
        return b.kind == BoundaryKind::fold || b.kind == BoundaryKind::outcome;
    };
    if (!set_points_only && std::none_of(answer.rays.begin(), answer.rays.end(), nonlinear) &&
        std::none_of(answer.curves.begin(), answer.curves.end(), nonlinear))
        report.not_checked.push_back("Large disturbances: ask for --kind fold or outcome.");
    for (const auto& ray : answer.rays)
        report.not_checked.push_back(std::string(name_of(ray.kind)) + " along " + ray.axis.symbol + ": " +
                                     could_be_missed(ray) + ".");
    for (const auto& c : answer.curves) {
        report.not_checked.push_back(std::string(name_of(c.kind)) + " over " + c.x.symbol + " and " + c.y.symbol +
                                     ": " + could_be_missed(c) + ".");
        warn_of_lost_pieces(report, c);
    }
    report.provenance = {{"command", answer.command}};
    return report;
}

}  // namespace stickslip
