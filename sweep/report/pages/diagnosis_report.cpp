#include "sweep/report/pages/diagnosis_report.h"

#include "analysis/results/text.h"
#include "sweep/report/figures/diagnosis_figures.h"
#include "sweep/report/figures/ladder_drawing.h"
#include "sweep/report/figures/moved_boundary.h"
#include "sweep/report/figures/where_drawing.h"
#include "sweep/report/pages/corrected_section.h"
#include "sweep/report/pages/guarantee_card.h"
#include "sweep/words/cause_text.h"
#include "sweep/words/diagnosis_first_screen.h"
#include "sweep/words/diagnosis_tables.h"
#include "sweep/words/diagnosis_text.h"
#include "sweep/words/experiment_text.h"
#include "sweep/words/signature_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

using Tone = Headline::Tone;

Section next_section(const Diagnosis& d)
{
    Section next{"next", "Next experiment", next_experiment_text(d), {}, {}};
    if (has_motion(d.next_experiment)) next.figures.push_back(experiment_figure(d));
    return next;
}

}  // namespace

namespace {

/// A rig measures a coefficient, or a force: its record does not say which, and neither does the page.
Diagnosis in_units_of_the_record(Diagnosis d)
{
    const std::string per = d.motion == Motion::prismatic ? "m" : "rad";
    const std::pair<Quantity, std::string> units[] = {
        {Quantity::effort, ""}, {Quantity::damping, "·s/" + per}, {Quantity::stiffness, "/" + per}};
    const auto as_logged = [&](std::string& unit) {
        for (const auto& [quantity, rest] : units)
            if (unit == unit_of(quantity, Units(d.motion))) {
                unit = "as logged" + rest;
                return;
            }
    };
    for (auto* shares : {&d.signals, &d.regimes})
        for (auto& s : *shares) as_logged(s.unit);
    for (auto& cause : d.effects)
        for (auto& p : cause.parameters) as_logged(p.unit);
    for (auto& g : d.gap) as_logged(g.unit);
    return d;
}

Section where_section(const Diagnosis& d)
{
    Section where{"where",
                  "Where the gap lies",
                  "Bars are shares of the gap, whiskers their 95 % intervals; stages are compared as efforts on the "
                  "mechanism.",
                  {},
                  {shares_table("By stage of the chain", d.signals)}};
    if (!d.signals.empty()) {
        where.figures.push_back(where_figure(d));
        where.tables.front().bars.clear();  // the figure has them
    }
    if (!d.regimes.empty())
        where.tables.push_back(
            shares_table("Motion error by regime: stuck, low speed and sliding exclude each other", d.regimes));
    return where;
}

Section what_section(const Diagnosis& d)
{
    Section what{"what", "What causes it", "", {}, {causes_table(d)}};
    auto values = values_table(d), parameters = parameters_table(d);
    const bool all_said = values.rows.size() >= parameters.rows.size();
    if (!values.rows.empty()) what.tables.push_back(std::move(values));
    if (!all_said) what.tables.push_back(std::move(parameters));
    if (!d.ladder.empty()) what.figures.push_back(ladder_figure(d));
    what.text = d.verdict == Verdict::gap ? "Signature of the first: " + signature_text(d.effects[0].signatures) + "."
                                          : "No cause is named; these are the candidates.";
    return what;
}

Section much_section(const Diagnosis& d)
{
    const bool named = d.verdict == Verdict::gap;
    Section much{"how-much",
                 named ? "How far the gap shrinks" : "How large the gap is",
                 named ? "All numbers are from held-out data." : "The documented joint compared with the records.",
                 {},
                 {gap_table(d)}};
    much.figures = trace_figures(d);
    return much;
}

Section boundary_section(const Diagnosis& d, const MovedBoundary& moved, const CorrectedGains& gains, Units units)
{
    const std::string with = "with " + together(d.effects[0].names);
    auto section =
        moved_section(moved, units, with,
                      " Friction, inertia, gains, delays, filters and sampling move the boundary; limits and "
                      "terms that depend on position or time are not in this theory, and are simulated.");
    add_corrected_gains(section, gains, units, with);
    return section;
}

}  // namespace

Report diagnosis_report(const Diagnosis& diagnosis, const Joint& before, const Joint& after, const MovedBoundary& moved,
                        const CorrectedGains& gains, std::vector<std::pair<std::string, std::string>> provenance,
                        std::vector<Snippet> snippets, bool rig)
{
    const Diagnosis d = rig ? in_units_of_the_record(diagnosis) : diagnosis;
    Report r;
    r.title = "Sim-to-real gap of one joint";
    if (!d.records.empty())
        r.subtitle =
            d.records.size() == 1 ? "One record: " + d.records[0].file : fmt::format("{} records", d.records.size());
    r.verdict = diagnosis_sentence(d);
    if (d.verdict == Verdict::gap) {
        r.findings.push_back(r.verdict);
        r.verdict = heading_of(d, before, after);
    }
    r.snippets = std::move(snippets);
    r.tone = d.verdict == Verdict::no_gap ? Tone::good : d.verdict == Verdict::gap ? Tone::warning : Tone::bad;
    // that nothing is wrong is the verdict already, and no warning
    if (d.verdict != Verdict::no_gap)
        for (const auto& reason : d.reasons) r.alerts.push_back({Tone::warning, note_sentence(reason)});
    r.not_checked = gathered_notes(d);
    r.provenance = std::move(provenance);
    // nothing was concluded: pages of empty tables would hide the reason
    if (d.verdict == Verdict::insufficient_data && d.signals.empty()) return r;

    r.headlines.push_back(what_card(d));
    if (d.overall.before > 0) r.headlines.push_back(how_much_card(d));
    if (d.verdict == Verdict::gap) {
        r.headlines.push_back(how_sure_card(d));
        for (auto& card : remains_card(d)) r.headlines.push_back(std::move(card));
    }
    if (!d.signals.empty()) r.headlines.push_back(where_card(d));
    for (auto& card : guarantee_card(d)) r.headlines.push_back(std::move(card));

    if (auto played = played_figures(d); !played.empty())
        r.sections.push_back({"played", "The motion, measured and simulated", "", std::move(played), {}});
    // shares of noise would look like findings
    if (d.verdict != Verdict::no_gap) r.sections.push_back(where_section(d));
    if (!d.effects.empty()) r.sections.push_back(what_section(d));
    r.sections.push_back(much_section(d));
    r.sections.push_back(next_section(d));
    if (d.verdict == Verdict::gap && !rig) r.sections.push_back(boundary_section(d, moved, gains, units_of(before)));
    const std::string method = method_text(d);
    r.sections.push_back({"data",
                          "Data",
                          (method.empty() ? "" : method + " ") +
                              "diagnosis.json beside this page has every number of this page under stable names.",
                          {},
                          {records_table(d)}});
    return r;
}

}  // namespace stickslip
