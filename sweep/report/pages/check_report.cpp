#include "sweep/report/pages/check_report.h"

#include "analysis/joint/parameters.h"
#include "analysis/results/text.h"
#include "sweep/report/figures/map_figures.h"
#include "sweep/words/heading_text.h"
#include "sweep/words/loop_text.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace stickslip {
namespace {

using Tone = Headline::Tone;

/// One crossing over the rays of a chart: theory and number.
struct Line {
    LineChart::Line old_line, new_line;
};

AxisName label(const Axis& axis, Units units)
{
    return {axis.name + " " + axis.symbol, std::string(unit_of(axis.quantity, units))};
}

std::string verdict_of(Deviation::Kind kind)
{
    switch (kind) {
        case Deviation::Kind::within:
            return "within";
        case Deviation::Kind::refined:
            return "refined";
        case Deviation::Kind::moved:
            return "moved";
        case Deviation::Kind::changed:
            return "changed its unit or its stable side";
        case Deviation::Kind::coarser:
            return "located more coarsely";
        case Deviation::Kind::vanished:
            return "vanished";
        case Deviation::Kind::appeared:
            break;
    }
    return "appeared";
}

std::string kind_words(const std::string& theory)
{
    return theory == "velocity_only"    ? "velocity-only boundary"
           : theory == "state_variable" ? "boundary with memory"
           : theory == "v_min"          ? "V_{min}"
           : theory == "fold"           ? "fold of limit cycles"
           : theory == "outcome"        ? "boundary of the outcome"
                                        : theory;
}

Figure figure_of(const Spec& spec, const Axis& x, const Axis& y, const std::vector<Deviation>& deviations)
{
    std::map<std::pair<std::string, int>, Line> lines;
    for (const auto& d : deviations) {
        const auto& shown = d.kind == Deviation::Kind::appeared ? d.now : d.stored;
        if (shown.axis != x.path || shown.at.size() != 1 || shown.at[0].first != y.path) continue;
        auto& line = lines[{shown.theory, shown.number}];
        if (d.kind != Deviation::Kind::appeared)
            line.old_line.x.push_back(d.stored.point.value), line.old_line.y.push_back(shown.at[0].second);
        if (d.kind != Deviation::Kind::vanished)
            line.new_line.x.push_back(d.now.point.value), line.new_line.y.push_back(shown.at[0].second);
    }
    LineChart chart;
    chart.title = "Boundaries before (dashed) and now, over (" + x.symbol + ", " + y.symbol + ")";
    const Units units = units_of(spec.joint);
    chart.x_label = label(x, units), chart.y_label = label(y, units);
    chart.x_log = x.log, chart.y_log = y.log;
    for (auto& [key, line] : lines) {
        const std::string name = kind_words(key.first) + (key.second > 0 ? " " + std::to_string(key.second + 1) : "");
        line.new_line.name = name + ", now";
        line.old_line.name = name + ", baseline";
        line.old_line.dashed = true;
        for (auto* l : {&line.new_line, &line.old_line})
            if (!l->x.empty()) chart.lines.push_back(std::move(*l));
    }
    Figure figure;
    figure.id = chart_id("check", x, y);
    figure.caption =
        "Each line joins the crossings of up to nine rays, straight from one to the next; the crossings themselves are "
        "located. Where dashed and solid lines coincide, nothing moved.";
    figure.finding = chart.title;
    figure.picture = std::move(chart);
    return figure;
}

/// A watched boundary as a reader names it: "boundary with memory along k_{p}, at k_{v} = 10 N·s/m".
std::string watched_words(const Spec& spec, const WatchedBoundary& w)
{
    const Units units = units_of(spec.joint);
    const auto* along = axis_of(spec, w.axis);
    std::string text = kind_words(w.theory) + " along " + (along ? along->symbol : w.axis);
    if (w.number > 0) text += ", number " + std::to_string(w.number + 1);
    for (const auto& [path, value] : w.at) {
        const auto* axis = axis_of(spec, path);
        text += ", at " + (axis ? axis->symbol + " = " + with_unit(value, axis->quantity, units)
                                : path + " = " + plain_number(value));
    }
    return text;
}

std::vector<std::string> row_of(const Spec& spec, const Deviation& d)
{
    const auto& shown = d.kind == Deviation::Kind::appeared ? d.now : d.stored;
    const auto* along = axis_of(spec, shown.axis);
    const auto value = [&](bool known, const WatchedBoundary& w) -> std::string {
        if (!known) return "none";
        const Units units = units_of(spec.joint);
        return along ? with_unit(w.point.value, along->quantity, units, 8)
                     : plain_number(w.point.value, 8) + " " + w.unit;
    };
    const bool both = d.kind != Deviation::Kind::appeared && d.kind != Deviation::Kind::vanished;
    return {watched_words(spec, shown),
            value(d.kind != Deviation::Kind::appeared, d.stored),
            value(d.kind != Deviation::Kind::vanished, d.now),
            both ? plain_number(d.relative, 2) : "–",
            both ? plain_number(shown.tolerance, 2) : "–",
            verdict_of(d.kind)};
}

std::vector<Headline> headlines_of(const Spec& spec, const std::vector<Deviation>& deviations, std::size_t failed,
                                   std::size_t refined)
{
    const auto farthest = std::max_element(deviations.begin(), deviations.end(),
                                           [](const auto& a, const auto& b) { return a.relative < b.relative; });
    const bool moved = farthest != deviations.end() && farthest->relative > 0;
    return {{failed ? Tone::bad : Tone::good, std::to_string(failed),
             "of " + std::to_string(deviations.size()) + " boundaries are out of tolerance; expected 0"},
            {Tone::neutral, moved ? plain_number(100 * farthest->relative, 2) + " %" : "0",
             "largest relative move of a boundary" +
                 (moved ? ": " + watched_words(spec, farthest->now) + ", from " + row_of(spec, *farthest)[1] + " to " +
                              row_of(spec, *farthest)[2]
                        : "; each has a tolerance of its own")},
            {Tone::neutral, std::to_string(refined), "are located more finely than in the baseline"}};
}

/// What fails, farthest beyond its tolerance first; where nothing does, the largest moves.
Section list_of(const Spec& spec, const std::vector<Deviation>& deviations, bool failed)
{
    constexpr std::size_t worth_a_row = 10;  // of what passes
    Table table;
    table.title = failed ? "Out of tolerance" : "The largest moves";
    table.columns = {"boundary", "baseline", "now", "relative move", "allowed", "verdict"};
    std::vector<const Deviation*> shown;
    for (const auto& d : deviations)
        if (!failed || !d.passes()) shown.push_back(&d);
    std::stable_sort(shown.begin(), shown.end(), [](const Deviation* a, const Deviation* b) {
        return a->relative * b->stored.tolerance > b->relative * a->stored.tolerance;
    });
    for (std::size_t i = 0; i < shown.size() && (failed || i < worth_a_row); ++i)
        table.rows.push_back(row_of(spec, *shown[i]));
    Section list{"list", table.title, "", {}, {}};
    list.tables.push_back(std::move(table));
    return list;
}

}  // namespace

std::string changed_text(const Spec& spec, const ChangedNumber& c)
{
    Joint joint = spec.joint;
    Quantity quantity = Quantity::number;
    for (const auto& p : parameters(joint))
        if (p.path == c.path) quantity = p.quantity;
    const auto text = [&](double value) {
        return is_set(value) ? with_unit(value, quantity, units_of(joint), 6) : std::string("none");
    };
    return c.path + " " + text(c.before) + " → " + text(c.after);
}

Report check_report(const Spec& spec, const std::vector<Deviation>& deviations,
                    const std::vector<ChangedNumber>& changed, const LoopUse& loop, bool design_lost,
                    const std::string& command)
{
    std::size_t failed = 0, refined = 0;
    for (const auto& d : deviations) {
        failed += !d.passes();
        refined += d.kind == Deviation::Kind::refined;
    }
    Report report;
    report.title = page_title("Boundaries against their baseline", spec.title);
    report.verdict = failed ? std::to_string(failed) + " of " + std::to_string(deviations.size()) +
                                  " boundaries are out of tolerance."
                            : "All " + std::to_string(deviations.size()) + " boundaries are unchanged.";
    if (refined) report.verdict += " " + std::to_string(refined) + " are located more finely than before.";
    report.verdict += loop_text(loop);
    if (design_lost) report.verdict = "The design itself was stable and is not. " + report.verdict;
    report.tone = without_what_matters(failed || design_lost ? Tone::bad : Tone::good, loop);
    report.headlines = headlines_of(spec, deviations, failed, refined);
    for (const auto& c : changed)
        report.findings.push_back("Changed since the baseline: " + changed_text(spec, c) + ".");
    if (changed.empty() && failed)
        report.findings.push_back(
            "The changed parameter of the joint is unknown: the baseline has none, or all are unchanged and a friction "
            "law, an axis or the version of the program differs. A baseline written with --update has the parameters.");
    Section curves{"curves", "Before and now", "", {}, {}};
    for (const auto& [x, y] : spec.report.charts)
        if (const Axis* a = axis_of(spec, x), *b = axis_of(spec, y); a && b) {
            auto figure = figure_of(spec, *a, *b, deviations);
            if (!std::get<LineChart>(figure.picture).lines.empty()) curves.figures.push_back(std::move(figure));
        }
    if (!curves.figures.empty()) report.sections.push_back(std::move(curves));
    report.sections.push_back(list_of(spec, deviations, failed > 0));
    report.not_checked = {
        "Boundaries away from the nine rays of each chart and from the rays through the design point.",
        "Whether the baseline was right."};
    report.provenance = {{"command", command}};
    return report;
}

}  // namespace stickslip
