#include "sweep/report/pages/outcome_report.h"

#include "analysis/diagnosis/outcomes/share.h"
#include "analysis/joint/parameters.h"
#include "analysis/results/text.h"
#include "sweep/report/figures/moved_boundary.h"
#include "sweep/report/figures/outcome_map.h"
#include "sweep/report/pages/outcome_tables.h"
#include "sweep/words/diagnosis_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace stickslip {
namespace {

using gap::LawFit;
using gap::OutcomeAnswer;
using Tone = Headline::Tone;

}  // namespace

std::string outcome_sentence(const OutcomeAnswer& a)
{
    const auto& d = a.diagnosis;
    const auto n = a.outcomes.size();
    switch (d.verdict) {
        case Verdict::gap: {
            const LawFit& best = a.laws.front();
            std::string text = fmt::format(
                "The measured boundary is that of {} (law {}): it misjudges {} of {} held-out rows, the nominal joint "
                "{}",
                best.rival->effect, best.rival->law, best.misjudged, n, a.nominal.misjudged);
            std::vector<std::string> others;
            for (const auto& f : a.laws) {
                if (&f == &best) continue;
                for (const auto& names : d.ambiguous_with)
                    if (names[0] == f.rival->effect && f.total() > best.total() - gap::clear_margin) {
                        others.emplace_back(f.rival->law);
                        break;
                    }
            }
            if (!others.empty())
                text += fmt::format("; these rows cannot distinguish it from {}", fmt::join(others, ", "));
            return text + ".";
        }
        case Verdict::no_gap:
            return fmt::format("No gap: the nominal joint explains the {} measured outcomes.", n);
        case Verdict::unknown:
            return "Neither the nominal joint nor any friction law explains the measured outcomes.";
        default:
            return "These rows do not determine the friction law.";
    }
}

std::string next_outcome_text(const OutcomeAnswer& a)
{
    if (a.next.settings.empty() || a.diagnosis.next_experiment.separates.empty()) return "";
    const auto& [one, two] = a.diagnosis.next_experiment.separates[0];
    std::string place;
    Joint joint = a.after;
    for (std::size_t k = 0; k < a.next.settings.size(); ++k) {
        const auto& path = a.outcomes.table.paths[k];
        for (const auto& p : parameters(joint))
            if (p.path == path)
                place += (place.empty() ? "" : ", ") + key_of(path) + " = " +
                         with_unit(a.next.settings[k], p.quantity, units_of(joint));
    }
    return fmt::format("start from rest at {}: {} expects stick-slip with probability {:.2f}, {} with {:.2f}", place,
                       one, a.next.one, two, a.next.two);
}

// In one piece: a page from top to bottom: its sections in their order.
Report outcome_report(const OutcomeAnswer& a, const Joint& nominal,
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
    const LawFit& best = a.laws.front();
    if (d.verdict == Verdict::gap) {
        r.headlines.push_back({Tone::warning, std::string(best.rival->law),
                               "what: the law that explains the rows (" + std::string(best.rival->effect) + ")"});
        r.headlines.push_back(
            {Tone::neutral, fmt::format("{:.0f} %", 100 * best.posterior), "how sure: its probability"});
    }
    r.headlines.push_back(
        {Tone::neutral, fmt::format("{} → {} of {}", a.nominal.misjudged, best.misjudged, a.outcomes.size()),
         "how much: rows misjudged by the nominal joint → by " + std::string(best.rival->law) + " where held out"});
    const Share* worst = nullptr;
    for (const auto& s : d.regimes)
        if (!worst || s.share > worst->share) worst = &s;
    if (worst)
        r.headlines.push_back(
            {Tone::neutral, worst->name,
             fmt::format("where: {:.0f} % of what the nominal joint gets wrong", 100 * worst->share)});

    Section map{"map", "The rows on the map", "", {}, {}};
    // maps with both outcomes show a boundary; those with more rows show it better
    std::map<double, std::pair<int, int>> dampings;
    for (std::size_t i = 0; i < a.outcomes.size(); ++i) {
        auto& [sticks, slides] = dampings[a.outcomes.joints[i].control.k_v];
        ++(a.outcomes.table.rows[i].stick_slip ? sticks : slides);
    }
    std::vector<std::tuple<int, int, double>> fullest;
    for (const auto& [k_v, rows] : dampings)
        fullest.emplace_back(-std::min(rows.first, rows.second), -rows.first - rows.second, k_v);
    std::sort(fullest.begin(), fullest.end());
    constexpr std::size_t most_maps = 4;
    for (std::size_t i = 0; i < std::min(most_maps, fullest.size()); ++i)
        map.figures.push_back(outcome_map(a, nominal, std::get<2>(fullest[i]), static_cast<int>(i) + 1));
    if (fullest.size() > most_maps)
        map.text = fmt::format("The {} values of k_{{v}}, of {}, whose rows show most of the boundary.", most_maps,
                               fullest.size());
    r.sections.push_back(std::move(map));

    Section what{"what",
                 "Which law",
                 d.effects.empty() ? "" : "Signature of the best: " + d.effects[0].tell_tale + ".",
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
    if (d.verdict == Verdict::gap) {
        auto moved = moved_boundary(nominal, a.after, d.usual_speed, "with " + std::string(best.rival->law));
        Section boundary{"boundary", "Effect on the stability map", moved.sentence, std::move(moved.figures), {}};
        if (!moved.table.rows.empty()) boundary.tables.push_back(std::move(moved.table));
        r.sections.push_back(std::move(boundary));
    }
    r.sections.push_back({"rows", "Data", "", {}, {rows_table(a)}});
    return r;
}

}  // namespace stickslip
