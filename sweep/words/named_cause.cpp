#include "sweep/words/named_cause.h"

#include "analysis/diagnosis/policy/page_and_plan.h"
#include "sweep/words/cause_text.h"
#include "sweep/words/diagnosis_tables.h"

#include <fmt/format.h>

#include <algorithm>

namespace stickslip {
namespace {

bool has_all(const std::vector<std::string>& names, const std::vector<std::string>& of)
{
    return std::ranges::all_of(of, [&](const auto& name) { return std::ranges::find(names, name) != names.end(); });
}

/// That it is one of the causes that the first sentence names.
double probability_of_named(const Diagnosis& d)
{
    const auto sorted = [](std::vector<std::string> names) {
        std::ranges::sort(names);
        return names;
    };
    double sum = d.effects[0].probability;
    for (std::size_t i = 1; i < d.effects.size(); ++i)
        if (std::ranges::any_of(d.ambiguous_with, [&](const auto& names) {
                return sorted(names) == sorted(d.effects[i].names) && sorted(names) != sorted(d.effects[0].names);
            }))
            sum += d.effects[i].probability;
    return std::min(sum, 1.0);
}

}  // namespace

std::string rivals_text(const Diagnosis& d)
{
    std::string text;
    for (const auto& names : d.ambiguous_with) {
        const bool same = !d.effects.empty() && names == d.effects[0].names;
        text += (text.empty() ? "" : ", ") + together(names) + (same ? " by another law" : "");
    }
    return text;
}

std::vector<std::string> one_of(const Diagnosis& d)
{
    std::vector<std::string> causes{together(d.effects[0].names)};
    for (const auto& names : d.ambiguous_with)
        if (names != d.effects[0].names) causes.push_back(together(names));
    return causes;
}

const Cause* wider_cause(const Diagnosis& d)
{
    if (d.effects.empty() || !d.ambiguous_with.empty()) return nullptr;
    const auto& named = d.effects[0].names;
    const auto found = std::find_if(d.effects.begin() + 1, d.effects.end(), [&](const Cause& c) {
        return c.names.size() > named.size() && has_all(c.names, named) && c.heldout_gain_interval.low > 0 &&
               c.probability >= gap::policy::stated_none;
    });
    return found == d.effects.end() ? nullptr : &*found;
}

std::string alone_or_wider(const Diagnosis& d, const Cause& wider)
{
    std::vector<std::string> added;
    for (const auto& name : wider.names)
        if (!has_all(d.effects[0].names, {name})) added.push_back(name);
    return fmt::format("alone {}, with {} {}", whole_percent(d.effects[0].probability), together(added),
                       whole_percent(wider.probability));
}

double probability_of_part(const Diagnosis& d)
{
    if (!wider_cause(d)) return d.effects[0].probability;
    double sum = 0;
    for (const auto& cause : d.effects)
        if (has_all(cause.names, d.effects[0].names)) sum += cause.probability;
    return std::min(sum, 1.0);
}

std::string said_by_probability(const Diagnosis& d)
{
    const auto causes = one_of(d);
    const std::string which =
        causes.size() > 1 ? fmt::format("one of {}, which these records cannot distinguish", fmt::join(causes, ", "))
                          : causes[0];
    if (const Cause* wider = wider_cause(d)) {
        const double sure = probability_of_part(d);
        return fmt::format("{} {} ({}, which predicts held-out data better)",
                           sure >= gap::policy::stated_flatly        ? "The gap comes from"
                           : sure >= gap::policy::stated_as_probable ? "The gap probably comes from"
                                                                     : "The likeliest cause of the gap is",
                           which, alone_or_wider(d, *wider));
    }
    const double sure = probability_of_named(d);
    if (sure >= gap::policy::stated_flatly) return "The gap comes from " + which;
    if (sure >= gap::policy::stated_as_probable)
        return fmt::format("The gap probably comes from {} ({})", which, whole_percent(sure));
    return fmt::format("The likeliest cause of the gap is {} ({}; that it is none of those listed: {})", which,
                       whole_percent(sure), whole_percent(probability_of_none(d)));
}

}  // namespace stickslip
