// The ladder of the set that a climb has ended at, and what is asked of it.
#include "analysis/diagnosis/ladder/ladder.h"

#include "analysis/diagnosis/fit/candidate_numbers.h"
#include "analysis/diagnosis/ladder/climber.h"
#include "analysis/diagnosis/ladder/fit_set.h"
#include "analysis/diagnosis/policy/ladder.h"
#include "analysis/diagnosis/search/search.h"

#include <algorithm>

namespace stickslip::gap {

Ladder LadderSearch::of(const Attribution& known)
{
    const Eigen::VectorXd x = fitter_->start(known.candidate, {}, known.x[ladder_level]);
    if (!divides_mass(known.candidate)) {
        FittedSet set = climber_->in_parts(fitter_->fit(known.candidate, x));
        if (set.causes.effects.size() > 1) return finished(std::move(set));
        wrong_numbers_ = climber_->wrong_numbers(corrected_, *corrections_, false);
        auto numbers = nearer_numbers(&set);
        return finished(numbers ? std::move(*numbers) : std::move(set));
    }
    // ten times as slow, and its search has been long
    LevelFit found;
    found.x = x;
    return finished(with_wrong_numbers(fitter_->fit_folds(known.candidate, std::move(found)), rules_.most_rungs));
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
        ladder.rivals.emplace_back(first_.begin(), first_.end());
        return ladder;
    }
    ladder.rungs = climber_->in_order(std::move(set));
    for (std::size_t i = 0; i < ladder.rungs.size(); ++i) {
        const Candidate below = i > 0 ? ladder.rungs[i - 1].causes : Candidate{};
        const auto others = climber_->in_place_of(ladder.rungs[i], below);
        ladder.rivals.emplace_back(others.begin(), others.end());
    }
    // what makes the very motion of the last rung cannot be distinguished from it, unless it was judged at a higher
    // floor
    auto& of_last = ladder.rivals.back();
    const double near = ladder.last().misfit + margin_of(ladder.last(), rules_);
    for (FittedSet& rival : of_last)
        if (rival.misfit > near && move_alike(ladder.last().causes, rival.causes)) rival = climber_->compared({rival});
    std::ranges::stable_sort(of_last, {}, &FittedSet::misfit);
    if (ladder.rungs.size() == 1) add_wrong_numbers(ladder);
    try_rivals_in_the_last(ladder);
    correct_alone(ladder);
    return ladder;
}

void LadderSearch::add_wrong_numbers(Ladder& ladder) const
{
    const auto& causes = ladder.rungs[0].causes.effects;
    if (!wrong_numbers_ || std::ranges::any_of(wrong_numbers_->causes.effects,
                                               [&](const Effect* e) { return std::ranges::count(causes, e) > 0; }))
        return;
    auto& rivals = ladder.rivals[0];
    for (const auto& set : climber_->judged({{wrong_numbers_->causes, nullptr, nullptr, {}, 0, wrong_numbers_->fit.x}}))
        if (set.plausible && !set.correction) rivals.emplace_back(set);
    std::ranges::stable_sort(rivals, {}, &FittedSet::misfit);
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
    const FittedSet& last = ladder.last();
    const Candidate& c = last.model.candidate;
    struct Off {
        std::size_t correction;
        double deviations;
        bool unstated_load;
        bool stated;  ///< and no small term of every machine
    };
    const bool states_load = fitter_->joint().load.constant != 0;
    std::vector<Off> off;
    for (std::size_t i = 0, at = 0; i < last.model.corrections; at += c.count_of(*c.forms[i++]))
        if (c.forms[i]->own == 0) {  // what differs from record to record is no number of the document
            const bool load = !states_load && c.effects[i]->name == "constant-load";
            off.push_back({i, Corrections::deviations(c, i, at, last.fit.x), load,
                           !load && !Corrections::is_small_term(*c.effects[i])});
        }
    // one document has errors of one size: beside causes a number has to be much further off than all others
    const auto one_of_many = [&](const Off& number) {
        return !ladder.rungs.empty() && number.stated && std::ranges::any_of(off, [&](const Off& other) {
            return other.stated && other.correction != number.correction &&
                   number.deviations < rules_.beyond_the_others * other.deviations;
        });
    };
    std::vector<FarNumber> far;
    for (const Off& number : off)
        if (number.deviations >= rules_.far_off && !one_of_many(number))
            far.push_back({c.effects[number.correction], number.unstated_load,
                           fitter_->fit_without(last, number.correction).all_left()});
    return far;
}

Ladder LadderSearch::with_load_released(const std::vector<Attribution>& pairs, const OnlyNoise& only_noise)
{
    corrections_->release_load(true);
    look_anew();
    return climb(pairs, rules_.most_rungs, only_noise);
}

void LadderSearch::hold_load()
{
    corrections_->release_load(false);
}

void LadderSearch::shorten(Ladder& ladder) const
{
    ladder.rungs.pop_back();
    if (ladder.rungs.empty()) {
        ladder.corrected_as_last = corrected_.all_left();
        return;
    }
    ladder.rivals.pop_back();
    try_rivals_in_the_last(ladder);
    correct_alone(ladder);
}

std::vector<Ladder> LadderSearch::over_a_scale(const Ladder& ladder)
{
    const FittedSet& last = ladder.last();
    std::vector<FittedSet> bases{last};
    // a cause may be what imitates the scale
    for (std::size_t i = 0; i < last.causes.effects.size(); ++i)
        if (!corrections_->same_number(*last.causes.effects[i], *last.causes.forms[i]))
            bases.push_back(climber_->without(last, i));
    std::vector<Ladder> ladders;
    for (const auto& base : bases)
        for (const auto& set : climber_->over_a_scale(base, *corrections_, Scaled::possible))
            if (set.misfit < last.misfit + margin_of(last, rules_) && set.causes.effects != last.causes.effects)
                ladders.push_back(finished(climber_->compared({set})));
    return ladders;
}

void LadderSearch::try_rivals_in_the_last(Ladder& ladder) const
{
    constexpr std::size_t most = 3;  // of each rung, the nearest
    for (std::size_t i = 0; i + 1 < ladder.rungs.size(); ++i) {
        const FittedSet& rung = ladder.rungs[i];
        auto& rivals = ladder.rivals[i];
        for (std::size_t k = 0; k < std::min(most, rivals.size()); ++k) {
            rivals[k].in_the_last.reset(), rivals[k].whole.reset();
            if (rivals[k].misfit < rung.misfit + policy::out_of_question * margin_of(rung, rules_) ||
                makes_the_motion_of(rung.causes, rivals[k].causes))
                if (auto whole = climber_->rival_in(ladder.last(), rung.causes, rivals[k])) {
                    rivals[k].in_the_last = whole->misfit;
                    if (whole->misfit < infinity) rivals[k].whole = std::make_shared<FittedSet>(std::move(*whole));
                }
        }
    }
}

/// The corrections that belong to the whole set, alone.
void LadderSearch::correct_alone(Ladder& ladder) const
{
    const FittedSet& last = ladder.rungs.back();
    ladder.corrected_as_last.clear();
    const auto alone = corrections_->beside({});
    std::array<std::vector<double>, HeldOutData::folds> si;
    for (std::size_t f = 0; f < HeldOutData::folds; ++f)
        si[f] = in_si(alone.candidate, Corrections::start(alone, last.model, last.x[f], {}), scales_);
    for (const auto& fold : data_.judge(alone.candidate, si))
        ladder.corrected_as_last.insert(ladder.corrected_as_last.end(), fold.begin(), fold.end());
}

}  // namespace stickslip::gap
