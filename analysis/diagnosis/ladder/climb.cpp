#include "analysis/diagnosis/ladder/climb.h"

#include "analysis/diagnosis/ladder/climber.h"
#include "analysis/diagnosis/ladder/fit_set.h"
#include "analysis/diagnosis/search/search.h"

#include <algorithm>
#include <cmath>

namespace stickslip::gap {
namespace {

constexpr std::size_t known_pairs = 3;  // of a search of their own, that are tried as two rungs

std::vector<Start> known_sets(const std::vector<Attribution>& pairs, const SetFitter& fitter, const FittedSet& below)
{
    std::vector<Start> known;
    for (std::size_t i = 0; i < std::min(known_pairs, pairs.size()); ++i)
        if (known.empty() || !two_mass_edit(pairs[i].candidate))
            known.push_back({pairs[i].candidate,
                             nullptr,
                             nullptr,
                             {},
                             0,
                             fitter.start(pairs[i].candidate, below, pairs[i].x[ladder_level])});
    return known;
}

}  // namespace

double margin_of(const FittedSet& better, const LadderRules& rules)
{
    double rows = 0, beyond = 0, all = 0;
    for (const auto& w : better.all_left()) {
        rows += w.rows(), beyond += w.beyond_noise();
        all += w.rows() * (w.position + (is_set(w.effort) ? w.effort : 0));
    }
    return rules.margin * std::clamp(beyond / std::max(all, 1e-300), 0.0, 1.0) +
           rules.rows_of_margin / std::max(rows, 1.0);
}

LadderSearch::LadderSearch(const std::vector<Case>& cases, const Scales& scales,
                           const std::vector<Attribution>& singles, const LadderRules& rules,
                           const ParallelFor& parallel)
    : scales_(scales),
      rules_(rules),
      parallel_(parallel),
      corrections_(std::make_shared<Corrections>(cases, scales, rules.prior)),
      data_(cases),
      fitter_(std::make_unique<SetFitter>(data_, scales, *corrections_, rules.ranges)),
      climber_(std::make_unique<Climber>(singles, *fitter_, rules, parallel))
{
    for (std::size_t f = 0; f < HeldOutData::folds; ++f)
        for (const auto& w : data_.judge(f, {}, {})) documented_.push_back(w);
    data_.raise_floor({}, {});
    fitter_->renew();
    correct(corrected_);
    if (singles.empty()) return;
    auto looks = climber_->looks(corrected_);
    find_small_terms(looks);
    first_ = climber_->judged(looks);
}

LadderSearch::~LadderSearch() = default;

void LadderSearch::correct(FittedSet& set)
{
    // Against a floor as high as the whole gap the prior weighs too much. What the first fit leaves is a lower floor,
    // which lets the next one go further, until both agree.
    constexpr int most_rounds = 5;
    constexpr double settled = 0.02;  // of mean log square
    Eigen::VectorXd x = fitter_->start({}, set, {});
    double before = infinity;
    for (int round = 0; round < most_rounds; ++round) {
        x = fitter_->refit({}, x).x;
        const auto model = corrections_->beside({});
        const auto si = in_si(model.candidate, x, scales_);
        const double now = data_.raise_floor(model.candidate, si);
        fitter_->renew();
        if (!(now < before - settled)) break;
        before = now;
    }
    set = fitter_->fit({}, x);
}

void LadderSearch::settle(const FittedSet& set)
{
    data_.raise_floor(set.model.candidate, in_si(set.model.candidate, set.fit.x, scales_));
    fitter_->renew();
}

Ladder LadderSearch::climb(const std::vector<Attribution>& pairs, std::size_t most_rungs, const OnlyNoise& only_noise)
{
    FittedSet set = corrected_;
    const auto best_first = [](const auto& a, const auto& b) { return a.misfit < b.misfit; };
    const auto flexed = [&](FittedSet found) {
        const auto forms = found.causes.forms;
        found = climber_->flexed(std::move(found));
        if (found.causes.forms != forms) settle(found);
        return found;
    };
    const std::size_t most_rounds = 2 * most_rungs;  // an exchange may come back to where it was
    for (std::size_t round = 0; round < most_rounds && set.causes.effects.size() < most_rungs; ++round) {
        const bool at_start = set.causes.effects.empty();
        if (!at_start && only_noise && only_noise(set)) break;
        auto tried = at_start ? first_ : climber_->next(set);
        // what comes nearest in most windows may take nothing of a gap that a few windows hold: then another one does
        const auto earning = [&] {
            return std::ranges::find_if(
                tried, [&](const auto& t) { return t.plausible && !t.correction && earns(set, t, rules_); });
        };
        // what a search of pairs has found may be more than its parts
        if (set.causes.effects.size() == 1 || (at_start && earning() == tried.end())) {
            for (auto& s : climber_->judged(known_sets(pairs, *fitter_, set))) tried.push_back(std::move(s));
            std::stable_sort(tried.begin(), tried.end(), best_first);
        }
        const auto next = earning();
        if (next == tried.end()) break;
        std::vector<FittedSet> rivals{*next};
        for (const auto& t : tried)
            if (&t != &*next && t.plausible && !t.correction &&
                t.causes.effects.size() == next->causes.effects.size() &&
                t.misfit < next->misfit + margin_of(*next, rules_))
                rivals.push_back(t);
        set = rivals[0];
        settle(set);
        set = flexed(climber_->compared(rivals));
        // exchange: a cause that only stood in for what came later goes, and makes room
        for (std::size_t i = 0; i < set.causes.effects.size() && set.causes.effects.size() > 1;) {
            FittedSet less = climber_->without(set, i);
            if (earns(less, set, rules_))
                ++i;
            else
                set = std::move(less), i = 0;
        }
        if (set.causes.effects.size() < 2) continue;
        const auto others = climber_->exchanged(set);
        const auto better = std::ranges::find_if(
            others, [&](const auto& o) { return o.plausible && !o.correction && o.misfit < set.misfit; });
        if (better == others.end()) continue;
        settle(*better);
        set = flexed(climber_->compared({*better}));
    }
    if (!set.causes.effects.empty() && set.causes.effects.size() < most_rungs) set = climber_->freed(std::move(set));
    return finished(std::move(set));
}

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
