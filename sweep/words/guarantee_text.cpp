#include "sweep/words/guarantee_text.h"

#include "sweep/words/diagnosis_tables.h"

#include <fmt/format.h>

#include <cmath>

namespace stickslip {
namespace {

using guarantee::Stranger;

std::string joined(const std::vector<std::string>& words, const char* last)
{
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i)
        text += (i == 0 ? "" : i + 1 == words.size() ? last : ", ") + words[i];
    return text;
}

/// The names of a few, the number of many: diagnosis.json has all of them.
std::string listed_or_counted(const std::vector<std::string>& names)
{
    constexpr std::size_t few = 6;
    return names.size() <= few ? joined(names, " and ") : fmt::format("{} outcomes", names.size());
}

std::string unit_of_number(const std::string& name)
{
    if (name == "duration" || name == "period" || name == "step") return " s";
    return name == "bandwidth" ? " rad/s" : "";
}

std::string meaning_of_number(const std::string& name)
{
    if (name == "records") return "number of records";
    if (name == "duration") return "duration of all records";
    if (name == "period") return "period of the loop";
    if (name == "step") return "time between two rows";
    if (name == "noise") return "documented noise as a part of the travel";
    return "bandwidth √(k_p/inertia)";
}

}  // namespace

std::string of_hundred(double share)
{
    return fmt::format("{:g}", std::round(1000 * share) / 10);
}

std::string possible_text(const CauseSet& set)
{
    std::vector<std::string> possible;
    for (const auto& names : set.names) possible.push_back(together(names));
    if (set.no_gap) possible.emplace_back("no gap");
    if (set.none_of_these) possible.emplace_back("a cause outside the catalogue");
    return possible.empty() ? "none" : joined(possible, " or ");
}

std::string cause_set_text(const CauseSet& set)
{
    const std::string right = fmt::format("right for at least {} of 100 such joints.", of_hundred(set.coverage));
    if (set.size() == 0)
        return "No cause stays possible: this answer is unlike those of the calibration, and the set is empty.";
    if (set.size() == 1) return fmt::format("The cause is {}: {}", possible_text(set), right);
    constexpr std::size_t many = 12;
    if (set.size() > many)
        return fmt::format("{} causes stay possible: this calibration excludes little at {} %.", set.size(),
                           of_hundred(set.coverage));
    return fmt::format("The cause is {}, or several of them act: {}", possible_text(set), right);
}

std::string promise_text(const CauseSet& set)
{
    std::string text = fmt::format("The promise rests on {} blind cases and holds with a confidence of {} %", set.cases,
                                   of_hundred(set.confidence));
    if (set.holds == CauseSet::Holds::every_cause) {
        text += " for every cause by itself, in joints drawn as these were: " + set.population + ".";
        if (!set.uncalibrated.empty())
            text += " Without a case, so never excluded: " + listed_or_counted(set.uncalibrated) + ".";
        return text;
    }
    text += " over joints drawn as these were, not for each cause by itself: " + set.population + ".";
    if (!set.uncalibrated.empty())
        text += " It does not cover what has no case there: " + listed_or_counted(set.uncalibrated) + ".";
    return text;
}

std::string stranger_text(const Stranger& s)
{
    switch (s.why) {
        case Stranger::Why::joint:
            return "the calibration is of another joint";
        case Stranger::Why::kind:
            return fmt::format("the calibration has no joint of this kind ({}), it has {}", s.given, s.known);
        case Stranger::Why::columns:
            return fmt::format("the calibration has no records with these columns ({}), it has {}", s.given, s.known);
        case Stranger::Why::noise:
            return fmt::format("sensor.position_noise is {} here, and {} in every case of the calibration", s.given,
                               s.known);
        default:
            return fmt::format("{}: {}{}, the calibration's cases have {:.3g} to {:.3g}{}", meaning_of_number(s.number),
                               std::isnan(s.value) ? "not stated" : fmt::format("{:.3g}", s.value),
                               std::isnan(s.value) ? "" : unit_of_number(s.number), s.low, s.high,
                               unit_of_number(s.number));
    }
}

std::string too_few_cases_text(const guarantee::Promise& p)
{
    return fmt::format(
        "{} cases promise nothing at {} %: {} are needed over the population, or of every cause, for a confidence of "
        "{} %",
        p.cases, of_hundred(p.coverage), p.needed, of_hundred(p.confidence));
}

}  // namespace stickslip
