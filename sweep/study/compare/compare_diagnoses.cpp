#include "sweep/study/compare/compare_diagnoses.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

bool holds(const std::vector<std::string>& names, const std::string& name)
{
    return std::find(names.begin(), names.end(), name) != names.end();
}

/// Those of the first that the second lacks.
std::vector<std::string> without(const std::vector<std::string>& names, const std::vector<std::string>& others)
{
    std::vector<std::string> left;
    for (const auto& name : names)
        if (!holds(others, name)) left.push_back(name);
    return left;
}

bool cannot_tell_from(const DiagnosisFacts& facts, const std::vector<std::string>& names)
{
    return std::any_of(facts.ambiguous_with.begin(), facts.ambiguous_with.end(), [&](const auto& rival) {
        return std::any_of(rival.begin(), rival.end(), [&](const auto& name) { return holds(names, name); });
    });
}

GapChange change_of_gap(const DiagnosisFacts& before, const DiagnosisFacts& after)
{
    if (!before.answered() || !after.answered()) return GapChange::not_comparable;
    if (!before.differs()) return after.differs() ? GapChange::appeared : GapChange::none;
    if (!after.differs()) return GapChange::gone;
    const double was = before.overall.before, is = after.overall.before;
    if (is > (1 + share_of_another_gap) * was) return GapChange::grown;
    return was > (1 + share_of_another_gap) * is ? GapChange::shrunk : GapChange::same;
}

NumberChange change_of(const FoundNumber& was, const FoundNumber& is)
{
    NumberChange c{is.number.name, is.number.unit, is.of, was.number, is.number};
    c.change = is.number.value - was.number.value;
    c.standard_errors = c.change / std::hypot(was.number.standard_error, is.number.standard_error);
    return c;
}

NumberChange alone(const FoundNumber& found, bool after)
{
    NumberChange c{found.number.name, found.number.unit, found.of};
    (after ? c.after : c.before) = found.number;
    c.change = c.standard_errors = missing;
    return c;
}

std::vector<NumberChange> changes_of(const DiagnosisFacts& before, const DiagnosisFacts& after)
{
    std::vector<NumberChange> changes;
    const auto same_as = [](const FoundNumber& wanted) {
        return [&wanted](const FoundNumber& other) {
            return other.of == wanted.of && other.number.name == wanted.number.name &&
                   other.number.unit == wanted.number.unit;
        };
    };
    for (const auto& is : after.numbers) {
        const auto was = std::find_if(before.numbers.begin(), before.numbers.end(), same_as(is));
        changes.push_back(was == before.numbers.end() ? alone(is, true) : change_of(*was, is));
    }
    for (const auto& was : before.numbers)
        if (std::none_of(after.numbers.begin(), after.numbers.end(), same_as(was)))
            changes.push_back(alone(was, false));
    const auto size = [](const NumberChange& c) {
        return std::isnan(c.standard_errors) ? -1 : std::abs(c.standard_errors);
    };
    std::stable_sort(changes.begin(), changes.end(), [&](const auto& a, const auto& b) { return size(a) > size(b); });
    return changes;
}

}  // namespace

bool NumberChange::moved(double errors) const
{
    return in_both() && std::abs(standard_errors) > errors;
}

DiagnosisComparison compare_diagnoses(DiagnosisFacts before, DiagnosisFacts after)
{
    DiagnosisComparison c;
    c.gap = change_of_gap(before, after);
    c.appeared = without(after.causes, before.causes);
    c.gone = without(before.causes, after.causes);
    c.kept = without(after.causes, c.appeared);
    c.perhaps_same_cause = (!c.appeared.empty() && cannot_tell_from(before, c.appeared)) ||
                           (!c.gone.empty() && cannot_tell_from(after, c.gone));
    c.numbers = changes_of(before, after);
    c.before = std::move(before);
    c.after = std::move(after);
    return c;
}

std::string name_of(GapChange change)
{
    switch (change) {
        case GapChange::none:
            return "none";
        case GapChange::same:
            return "same";
        case GapChange::appeared:
            return "appeared";
        case GapChange::gone:
            return "gone";
        case GapChange::grown:
            return "grown";
        case GapChange::shrunk:
            return "shrunk";
        case GapChange::not_comparable:
            break;
    }
    return "not-comparable";
}

}  // namespace stickslip
