// Several wrong numbers of the document in the place of a cause.
#include "analysis/diagnosis/ladder/climber.h"
#include "analysis/diagnosis/ladder/fit_set.h"
#include "analysis/diagnosis/ladder/ladder.h"

namespace stickslip::gap {
namespace {

constexpr std::size_t most_of_numbers = 2;  // parameters of a cause that two wrong numbers are no simpler than

}  // namespace

/// Errors of a document need no more proof than a cause that has as many parameters.
bool LadderSearch::nearer_than(const FittedSet& set, const FittedSet& numbers) const
{
    const bool as_simple = numbers.causes.parameter_count() <= set.causes.parameter_count();
    return numbers.misfit < set.misfit - (as_simple ? 0 : least_gain(numbers, rules_));
}

/// Several numbers of the document take the place of a cause of as many parameters where they come nearer, of a simpler
/// one where they are distinguished from it, and of none where several are held back. One alone is a cause like any
/// other, and is tried as one.
std::optional<FittedSet> LadderSearch::nearer_numbers(const FittedSet* than) const
{
    if (!wrong_numbers_) return std::nullopt;
    if (than ? !nearer_than(*than, *wrong_numbers_) : Climber::held_back(corrected_, *corrections_) < Climber::several)
        return std::nullopt;
    FittedSet numbers = without_idle(*wrong_numbers_);
    if (numbers.causes.effects.size() < Climber::several) return std::nullopt;
    return numbers;
}

FittedSet LadderSearch::with_wrong_numbers(FittedSet set, std::size_t most_rungs) const
{
    for (std::size_t i = 0; set.causes.effects.size() > 1 && i < set.causes.effects.size(); ++i) {
        if (corrections_->same_number(*set.causes.effects[i], *set.causes.forms[i])) continue;
        const auto less = climber_->without(set, i);
        // without a cause of many parameters numbers may take each other's place and be held back by nothing
        const bool few = set.causes.count_of(*set.causes.forms[i]) <= most_of_numbers;
        auto other = climber_->wrong_numbers(less, *corrections_, few);
        if (!other || other->causes.effects.size() > most_rungs) continue;
        if (nearer_than(set, *other)) return without_idle(std::move(*other));
    }
    return set;
}

}  // namespace stickslip::gap
