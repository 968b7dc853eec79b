#include "sweep/report/pages/timeline_report.h"

#include "analysis/results/point.h"
#include "analysis/results/text.h"
#include "sweep/words/comparison_text.h"
#include "sweep/words/diagnosis_tables.h"
#include "sweep/words/timeline_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace stickslip {
namespace {

using Tone = Headline::Tone;
using Line = DetailedChart::Line;

constexpr std::size_t most_charts = 8;  ///< of numbers; the table and timeline.json have all

Tone tone_of(const DiagnosisFacts& facts)
{
    if (!facts.answered()) return Tone::bad;
    return facts.differs() ? Tone::warning : Tone::good;
}

Tone tone_of(GapChange change)
{
    switch (change) {
        case GapChange::appeared:
        case GapChange::grown:
        case GapChange::not_comparable:
            return Tone::warning;
        case GapChange::none:
        case GapChange::gone:
            return Tone::good;
        default:
            return Tone::neutral;
    }
}

std::string gap_text(double gap)
{
    return std::isfinite(gap) && gap > 0 ? plain_number(gap, 3) : "–";
}

std::vector<double> days_of(const Timeline& t)
{
    std::vector<double> days;
    for (const auto& run : t.runs) days.push_back(days_between(t.runs.front().at, run.at));
    return days;
}

AxisName days_label(const Timeline& t)
{
    return {"days since " + date_text(t.runs.front().at)};
}

/// Where the gap came, went or changed its size.
std::vector<std::pair<std::string, double>> marks_of(const Timeline& t)
{
    std::vector<std::pair<std::string, double>> marks;
    for (std::size_t i = 0; i < t.steps.size(); ++i) {
        const auto change = t.steps[i].gap;
        if (change == GapChange::none || change == GapChange::same || change == GapChange::not_comparable) continue;
        marks.emplace_back(name_of(change), days_between(t.runs.front().at, t.runs[i + 1].at));
    }
    return marks;
}

Figure gap_figure(const Timeline& t)
{
    DetailedChart chart;
    chart.title = "Gap over time";
    chart.x_label = days_label(t), chart.y_label = {"gap, × the noise floor"};
    Line documented{"as documented", days_of(t), {}}, with{"with the named cause", days_of(t), {}, true};
    for (const auto& run : t.runs) {
        const auto& facts = run.facts;
        documented.y.push_back(facts.answered() ? facts.overall.before : missing);
        with.y.push_back(facts.answered() && !facts.causes.empty() ? facts.overall.after : missing);
    }
    chart.lines = {documented, with};
    chart.x_marks = marks_of(t);
    return {
        "gap", chart,
        "RMS difference between measured and simulated signals on held-out data, each signal in its own noise floor: "
        "1 is what noise alone makes.",
        timeline_sentence(t)};
}

Figure number_figure(const Timeline& t, const NumberSeries& series, std::size_t index)
{
    DetailedChart chart;
    const std::string name = parameter_words(series.name);
    chart.title = name;
    chart.x_label = days_label(t);
    chart.y_label = {name, series.unit == "1" ? "" : series.unit};
    constexpr double errors_of_a_95_percent_interval = 1.96;
    const auto days = days_of(t);
    Line value{"value", days, series.value}, bars{"95 % interval", {}, {}};
    if (series.found == 1) value.look = Line::Look::points;
    for (std::size_t i = 0; i < series.value.size(); ++i) {
        if (!std::isfinite(series.value[i])) continue;
        const double half = errors_of_a_95_percent_interval * series.standard_error[i];
        bars.x.insert(bars.x.end(), {days[i], days[i], days[i]});
        bars.y.insert(bars.y.end(), {series.value[i] - half, series.value[i] + half, missing});
    }
    bars.look = Line::Look::rule;
    chart.lines = {value, bars};
    return {fmt::format("number-{}", index + 1), chart,
            "Bars: 95 % intervals. Runs that do not name this cause have no value here.",
            fmt::format("{} in {} of {}", name, series.found, counted(t.runs.size(), "run"))};
}

/// Of a cause's parameters and the numbers of the data sheet that they change, the latter.
std::vector<NumberSeries> drawn_numbers(const Timeline& t)
{
    std::vector<NumberSeries> sheet;
    for (const auto& series : t.numbers)
        if (series.of == FoundNumber::Of::sheet) sheet.push_back(series);
    return sheet.empty() ? t.numbers : sheet;
}

/// A date on one line: with hyphens that do not break.
std::string unbroken(std::string date)
{
    for (auto at = date.find('-'); at != std::string::npos; at = date.find('-', at + 3)) date.replace(at, 1, "‑");
    return date;
}

/// The cause has a column of its own.
std::string outcome_word(const DiagnosisFacts& facts)
{
    return facts.verdict == Verdict::gap && !facts.interrupted ? "gap" : outcome_name(facts);
}

Table runs_table(const Timeline& t, CellMarks& marks)
{
    Table table{"Runs",
                {"date", "outcome", "gap as documented", "gap with the cause", "causes",
                 "parameters of causes that changed since the previous run"},
                {}};
    for (std::size_t i = 0; i < t.runs.size(); ++i) {
        const auto& facts = t.runs[i].facts;
        std::string moved;
        if (i > 0)
            for (const auto& change : t.steps[i - 1].numbers)
                if (change.of != FoundNumber::Of::correction && is_reported(change, t.steps[i - 1]) &&
                    change.moved(standard_errors_of_a_move))
                    moved += (moved.empty() ? "" : "; ") + change_text(change);
        table.rows.push_back({unbroken(date_text(t.runs[i].at)), outcome_word(facts), gap_text(facts.overall.before),
                              facts.causes.empty() ? "–" : gap_text(facts.overall.after),
                              facts.causes.empty() ? "–" : together(facts.causes), moved.empty() ? "–" : moved});
        marks.links.push_back(t.runs[i].page);
    }
    return table;
}

/// The name of the folder of a diagnosis, where that distinguishes it from the other's.
std::string short_name(const DiagnosisFacts& of, const DiagnosisFacts& other)
{
    const auto folder = [](const DiagnosisFacts& facts) {
        return std::filesystem::path(facts.source).parent_path().filename().string();
    };
    return folder(of).empty() || folder(of) == folder(other) ? of.source : folder(of);
}

}  // namespace

Report comparison_report(const DiagnosisComparison& c, Provenance provenance)
{
    Report r;
    r.title = "Two diagnoses compared";
    r.subtitle = "before: " + short_name(c.before, c.after) + " · now: " + short_name(c.after, c.before);
    r.verdict = comparison_sentence(c);
    r.tone = tone_of(c.gap);
    r.headlines = {
        {tone_of(c.before), gap_text(c.before.overall.before), "× the noise floor before: " + outcome_name(c.before)},
        {tone_of(c.after), gap_text(c.after.overall.before), "× the noise floor now: " + outcome_name(c.after)}};
    for (const auto& change : c.numbers)
        if (change.in_both() && change.of != FoundNumber::Of::correction && is_reported(change, c)) {
            r.headlines.push_back({change.moved(standard_errors_of_a_move) ? Tone::warning : Tone::neutral,
                                   plain_number(std::abs(change.standard_errors), 3),
                                   "standard errors between the two values of " + parameter_words(change.name)});
            break;
        }
    r.sections.push_back({"numbers",
                          "Which parameter moved",
                          "A change is compared with the standard error of both values together; beyond 3 it exceeds "
                          "noise. A parameter that only one diagnosis names cannot be compared.",
                          {},
                          {changes_table(c)}});
    r.sections.push_back(
        {"gap",
         "Is the gap new",
         "RMS differences between measured and simulated signals as documented. They can be compared as far as the "
         "motions are alike.",
         {},
         {compared_gap_table(c)}});
    r.not_checked = {"Whether both diagnoses began from the same joint file, and whether the motions were the same."};
    r.provenance = std::move(provenance);
    return r;
}

TimelinePage timeline_report(const Timeline& t, Provenance provenance)
{
    TimelinePage page;
    Report& r = page.report;
    r.title = t.title.empty() ? "A joint over time" : t.title + " over time";
    r.subtitle =
        counted(t.runs.size(), "run") + ", " + date_text(t.runs.front().at) + " to " + date_text(t.runs.back().at);
    r.verdict = timeline_sentence(t);
    const auto& last = t.runs.back().facts;
    r.tone = tone_of(last);
    r.headlines = {
        {tone_of(t.runs.front().facts), gap_text(t.runs.front().facts.overall.before),
         "× the noise floor in the first run: " + outcome_name(t.runs.front().facts)},
        {tone_of(last), gap_text(last.overall.before), "× the noise floor in the last run: " + outcome_name(last)}};
    Section runs{"runs", "Runs", "", {gap_figure(t)}, {}};
    runs.tables.push_back(runs_table(t, page.marks["Runs"]));
    if (std::ranges::any_of(t.runs, [](const auto& run) { return !run.page.empty(); }))
        runs.text = "The date of a run links to its page.";
    r.sections.push_back(std::move(runs));
    Section numbers{"numbers", "Parameters of the causes", "", {}, {}};
    const auto drawn = drawn_numbers(t);
    for (std::size_t i = 0; i < drawn.size() && i < most_charts; ++i)
        numbers.figures.push_back(number_figure(t, drawn[i], i));
    if (t.numbers.size() > numbers.figures.size())
        numbers.text = fmt::format(
            "{} parameters in all; those of the joint that most runs name are drawn, timeline.json has every one.",
            t.numbers.size());
    if (!numbers.figures.empty()) r.sections.push_back(std::move(numbers));
    r.not_checked = {
        "Whether all runs began from the same joint file: parameters of causes are changes of its values."};
    r.provenance = std::move(provenance);
    return page;
}

}  // namespace stickslip
