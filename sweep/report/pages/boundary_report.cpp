#include "sweep/report/pages/boundary_report.h"

#include "analysis/results/text.h"
#include "sweep/report/figures/hunting_map.h"
#include "sweep/report/figures/map_figures.h"
#include "sweep/report/figures/meeting_headlines.h"
#include "sweep/study/beyond_curves.h"
#include "sweep/words/heading_text.h"
#include "sweep/words/idle_text.h"
#include "sweep/words/loop_text.h"
#include "sweep/words/set_point_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

using Tone = Headline::Tone;

std::string scientific(double value)
{
    if (!(value > 0)) return "0";
    const int exponent = static_cast<int>(std::floor(std::log10(value)));
    return fmt::format("{:.1f}×10^{{{}{}}}", value / std::pow(10, exponent), exponent < 0 ? "−" : "",
                       std::abs(exponent));
}

Table ray_table(const Joint& design, const LocatedRay& ray)
{
    const Units units = units_of(design);
    Table table;
    table.title = std::string(name_of(ray.kind)) + " boundaries along " + ray.axis.symbol;
    table.columns = {
        ray.axis.name + " " + ray.axis.symbol, "side", "relative bracket", "status", "method", "evaluations"};
    for (const auto& p : ray.points)
        table.rows.push_back({with_unit(p.value, ray.axis.quantity, units, 10), direction_text(p.direction),
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

/// The map under all curves of one chart.
StabilityMap marked_map(const BoundaryChart& chart)
{
    auto map = *chart.sliding;
    map.title = "Boundaries of sliding over (" + map.x.symbol + ", " + map.y.symbol + ")";
    for (const auto& c : chart.curves)
        if (!c.pieces.empty()) map.curves.push_back(curve_with_brackets(c));
    return map;
}

bool is_hunting(BoundaryKind kind)
{
    return kind == BoundaryKind::hunting;
}

void add_figures(Section& section, const BoundaryAnswer& answer, const BoundaryChart& chart)
{
    const Units units = units_of(answer.design);
    if (chart.sliding) section.figures.push_back(curve_figure(marked_map(chart), chart.curves, answer.outcome_means));
    if (chart.at_rest) {
        std::vector<FollowedBoundary> hunting;
        for (const auto& c : chart.curves)
            if (is_hunting(c.kind)) hunting.push_back(c);
        for (auto& figure : hunting_figures(*chart.at_rest, hunting, units))
            section.figures.push_back(std::move(figure));
    }
    if (auto sharp = precision_figure(chart.curves, units); !std::get<LineChart>(sharp.picture).lines.empty())
        section.figures.push_back(std::move(sharp));
}

/// All questions are about set points.
bool asks_of_set_points_only(const BoundaryAnswer& answer)
{
    const auto hunting = [](const auto& b) { return is_hunting(b.kind); };
    return answer.set_point && std::all_of(answer.rays.begin(), answer.rays.end(), hunting) &&
           std::all_of(answer.curves.begin(), answer.curves.end(), hunting);
}

bool slides_smoothly(Region region)
{
    return region == Region::stable || region == Region::memory_only || region == Region::bistable;
}

Tone set_point_tone(const SetPoint& s)
{
    if (s.hunting == Hunting::undecided) return Tone::warning;
    return s.hunting == Hunting::yes || s.diverges() ? Tone::bad : Tone::good;
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

Report boundary_report(const BoundaryAnswer& answer)
{
    const auto& design = answer.design;
    const Units units = units_of(design);
    const bool set_points_only = asks_of_set_points_only(answer);
    Report report;
    report.title = page_title(set_points_only ? "Hunting at a set point" : "Boundaries of sliding", answer.title);
    if (!answer.outcome_means.empty()) report.subtitle = "outcomes follow a disturbance: " + answer.outcome_means;
    Section curves{"curves", "Curves", "", {}, {}};
    for (const auto& chart : answer.charts) add_figures(curves, answer, chart);
    if (!answer.curves.empty() && answer.charts.empty())
        report.alerts.push_back({Tone::warning, "Interrupted before the regions under the curves were computed."});
    if (!set_points_only) {
        report.tone = without_what_matters(design_tone(answer.region), answer.loop);
        report.verdict = design_words(answer.region) + loop_text(answer.loop);
    }
    if (!set_points_only) tell_idle(answer.idle, false, report);
    const bool none_judged =
        !answer.rays.empty() && std::all_of(answer.rays.begin(), answer.rays.end(),
                                            [](const LocatedRay& ray) { return ray.undecided == ray.nodes; });
    if (none_judged && answer.curves.empty() && report.tone == Tone::good) report.tone = Tone::warning;
    if (answer.left_out) {
        tell_left_out(*answer.left_out, slides_smoothly(answer.region), report);
        report.verdict = of_ideal_loop(report.verdict);
    }
    if (answer.set_point) {
        if (set_points_only) report.tone = set_point_tone(*answer.set_point);
        report.verdict += (set_points_only ? "" : " ") + set_point_text(*answer.set_point, units);
    }
    for (const auto& ray : answer.rays) report.verdict += " " + ray_text(design, ray, answer.idle);
    if (!answer.curves.empty() && !set_points_only) report.verdict += " " + meeting_text(answer.meetings, units);
    for (const auto& chart : answer.charts)
        if (chart.at_rest) report.verdict += " " + hunting_shares_text(*chart.at_rest);
    report.headlines = meeting_headlines(answer.meetings, units);
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
        report.not_checked.push_back("Large disturbances: use --kind fold or outcome.");
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
