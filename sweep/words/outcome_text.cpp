#include "sweep/words/outcome_text.h"

#include "analysis/joint/parameters.h"
#include "analysis/results/text.h"
#include "sweep/words/effect_words.h"
#include "sweep/words/symbols.h"

#include <fmt/format.h>

namespace stickslip {

std::string key_of(const std::string& path)
{
    return path.substr(path.rfind('.') + 1);
}

std::string third_text(const std::string& name, const gap::OutcomeAnswer& a)
{
    for (const auto& path : a.outcomes.table.paths)
        if (const auto key = key_of(path); name.ends_with(" " + key))
            return name.substr(0, name.size() - key.size()) + symbol_of(path, units_of(a.after));
    return name;
}

std::string outcome_sentence(const gap::OutcomeAnswer& a)
{
    const auto& d = a.diagnosis;
    const auto n = a.outcomes.size();
    switch (d.verdict) {
        case Verdict::gap: {
            const gap::LawFit& best = a.laws.front();
            std::string text = fmt::format(
                "The measured boundary is that of {} (law {}): it misjudges {} of {} held-out rows, the nominal joint "
                "{}",
                effect_words(best.rival->effect), best.rival->law, best.misjudged, n, a.nominal.misjudged);
            if (!a.alike.empty())
                text += fmt::format("; these rows cannot distinguish it from {}", fmt::join(a.alike, ", "));
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

std::string next_outcome_text(const gap::OutcomeAnswer& a)
{
    if (a.next.settings.empty() || a.diagnosis.next_experiment.separates.empty()) return "";
    const auto& [one, two] = a.diagnosis.next_experiment.separates[0];
    std::string place;
    Joint joint = a.after;
    for (std::size_t k = 0; k < a.next.settings.size(); ++k) {
        const auto& path = a.outcomes.table.paths[k];
        for (const auto& p : parameters(joint))
            if (p.path == path)
                place += (place.empty() ? "" : ", ") + symbol_of(path, units_of(joint)) + " = " +
                         with_unit(a.next.settings[k], p.quantity, units_of(joint));
    }
    return fmt::format("start from rest at {}: {} expects stick-slip with probability {:.2f}, {} with {:.2f}", place,
                       effect_words(one), a.next.one, effect_words(two), a.next.two);
}

}  // namespace stickslip
