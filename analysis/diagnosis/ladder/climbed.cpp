// The ladder of the set that a climb has ended at, and what is asked of it.
#include "analysis/diagnosis/ladder/climb.h"

#include "analysis/diagnosis/ladder/climber.h"
#include "analysis/diagnosis/ladder/fit_set.h"
#include "analysis/diagnosis/search/search.h"

#include <algorithm>

namespace stickslip::gap {

Ladder LadderSearch::of(const Attribution& known)
{
    const Eigen::VectorXd x = fitter_->start(known.candidate, {}, known.x[ladder_level]);
    if (!two_mass_edit(known.candidate)) return finished(fitter_->fit(known.candidate, x));
    // ten times as slow, and its search has been long
    LevelFit found;
    found.x = x;
    return finished(fitter_->fit_folds(known.candidate, std::move(found)));
}

Ladder LadderSearch::without(const Ladder& ladder, const Effect& cause)
{
    const auto& all = ladder.last().causes.effects;
    return finished(
        climber_->without(ladder.last(), static_cast<std::size_t>(std::ranges::find(all, &cause) - all.begin())));
}

Ladder LadderSearch::finished(FittedSet set)
{
    Ladder ladder;
    ladder.corrections = corrections_;
    ladder.documented = documented_;
    ladder.corrected = corrected_;
    if (set.causes.effects.empty()) {
        ladder.corrected_as_last = corrected_.all_left();
        ladder.rivals.push_back(first_);
        return ladder;
    }
    ladder.rungs = climber_->in_order(std::move(set));
    for (std::size_t i = 0; i < ladder.rungs.size(); ++i) {
        const Candidate below = i > 0 ? ladder.rungs[i - 1].causes : Candidate{};
        ladder.rivals.push_back(climber_->in_place_of(ladder.rungs[i], below));
    }
    correct_alone(ladder);
    return ladder;
}

bool LadderSearch::usually_off() const
{
    const Candidate& c = corrected_.model.candidate;
    std::size_t at = 0;
    for (std::size_t i = 0; i < corrected_.model.corrections; at += c.count_of(*c.forms[i++]))
        if (Corrections::deviations(c, i, at, corrected_.fit.x) >= rules_.far_off) return false;
    return true;
}

std::vector<FarNumber> LadderSearch::far_off(const Ladder& ladder) const
{
    std::vector<FarNumber> far;
    const FittedSet& last = ladder.last();
    const Candidate& c = last.model.candidate;
    std::size_t at = 0;
    for (std::size_t i = 0; i < last.model.corrections; at += c.count_of(*c.forms[i++])) {
        // what differs from record to record is no number of the document
        if (c.forms[i]->own > 0 || Corrections::deviations(c, i, at, last.fit.x) < rules_.far_off) continue;
        far.push_back({c.effects[i], fitter_->fit_without(last, i).all_left()});
    }
    return far;
}

void LadderSearch::shorten(Ladder& ladder) const
{
    ladder.rungs.pop_back();
    if (ladder.rungs.empty()) {
        ladder.corrected_as_last = corrected_.all_left();
        return;
    }
    ladder.rivals.pop_back();
    correct_alone(ladder);
}

/// The corrections that belong to the whole set, alone.
void LadderSearch::correct_alone(Ladder& ladder) const
{
    const FittedSet& last = ladder.rungs.back();
    ladder.corrected_as_last.clear();
    const auto alone = corrections_->beside({});
    for (std::size_t f = 0; f < HeldOutData::folds; ++f) {
        const auto x = Corrections::start(alone, last.model, last.x[f], {});
        for (const auto& w : data_.judge(f, alone.candidate, in_si(alone.candidate, x, scales_)))
            ladder.corrected_as_last.push_back(w);
    }
}

}  // namespace stickslip::gap
