#include "sweep/report/pages/outcome_report.h"

#include "analysis/results/text.h"
#include "sweep/report/figures/moved_boundary.h"
#include "sweep/report/figures/outcome_map.h"
#include "sweep/report/pages/outcome_tables.h"
#include "sweep/words/diagnosis_text.h"
#include "sweep/words/effect_words.h"
#include "sweep/words/outcome_text.h"
#include "sweep/words/signature_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace stickslip {
namespace {

using gap::LawFit;
using gap::OutcomeAnswer;
using Tone = Headline::Tone;

std::vector<Headline> headlines(const OutcomeAnswer& a)
{
    const auto& d = a.diagnosis;
    std::vector<Headline> list;
    const LawFit& best = a.laws.front();
    if (d.verdict == Verdict::gap) {
        list.push_back({Tone::warning, std::string(best.rival->law),
                        "cause: the law that explains the rows (" + effect_words(best.rival->effect) + ")"});
        list.push_back({Tone::neutral, percent(best.posterior), "how sure: its probability"});
    }
    list.push_back(
        {Tone::neutral, fmt::format("{} → {} of {}", a.nominal.misjudged, best.misjudged, a.outcomes.size()),
         "how much: rows misjudged by the nominal joint → by " + std::string(best.rival->law) + " where held out"});
    const Share* worst = nullptr;
    for (const auto& s : d.regimes)
        if (!worst || s.share > worst->share) worst = &s;
    if (worst)
        list.push_back({Tone::neutral, third_text(worst->name, a),
                        fmt::format("location: {:.0f} % of what the nominal joint gets wrong", 100 * worst->share)});
    return list;
}

}  // namespace

Report outcome_report(const OutcomeAnswer& a, const OutcomeMaps& maps, const Joint& nominal, const MovedBoundary& moved,
                      std::vector<std::pair<std::string, std::string>> provenance)
{
    const auto& d = a.diagnosis;
    Report r;
    r.title = "Which friction law explains the measured outcomes";
    r.subtitle = fmt::format("{} rows of {}", a.outcomes.size(), a.outcomes.table.name);
    r.verdict = outcome_sentence(a);
    r.tone = d.verdict == Verdict::no_gap ? Tone::good : d.verdict == Verdict::gap ? Tone::warning : Tone::bad;
    for (const auto& reason : d.reasons) r.alerts.push_back({Tone::warning, note_sentence(reason)});
    for (const auto& note : d.notes) r.not_checked.push_back(note_text(note));
    r.not_checked.emplace_back(
        "laws left out: kernel (its numbers are a measured table), maxwell-slip (slides like coulomb-viscous), "
        "rate-and-state-regularised (equals rate-and-state away from rest)");
    r.not_checked.emplace_back(
        "laws with memory are fitted by their linear boundary; the motion from rest is followed for those near the "
        "best");
    r.provenance = std::move(provenance);
    if (a.laws.empty()) return r;
    r.headlines = headlines(a);

    Section map{"map", "The rows on the map", "", {}, {}};
    auto ascending = maps.maps;
    std::ranges::sort(ascending, {}, &OutcomeMap::k_v);
    for (const auto& found : ascending) map.figures.push_back(outcome_map(a, found, map.figures.size() + 1));
    if (maps.velocity_gains > maps.maps.size())
        map.text = fmt::format("The {} values of k_{{v}}, of {}, whose rows show most of the boundary.",
                               maps.maps.size(), maps.velocity_gains);
    r.sections.push_back(std::move(map));

    Section what{"what",
                 "Which law",
                 d.effects.empty() ? "" : "Signature of the best: " + signature_text(d.effects[0].signatures) + ".",
                 {},
                 {laws_table(a), numbers_table(a)}};
    Section where{"where", "Where the nominal joint is wrong", "", {}, {}};
    where.tables.push_back(settings_table(a));
    const auto text = next_outcome_text(a);
    Section next{"next",
                 "Next experiment",
                 text.empty() ? "No setting near these rows distinguishes the best laws of two kinds any better."
                              : "Next: " + text + ".",
                 {},
                 {}};
    r.sections.insert(r.sections.end(), {std::move(what), std::move(where), std::move(next)});
    if (d.verdict == Verdict::gap)
        r.sections.push_back(moved_section(moved, units_of(nominal), "with " + std::string(a.laws.front().rival->law)));
    r.sections.push_back({"rows", "Data", "", {}, {rows_table(a)}});
    return r;
}

}  // namespace stickslip
