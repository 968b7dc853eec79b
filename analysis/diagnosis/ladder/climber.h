// The search for the next rung of a ladder: which causes go on top of a set, and whether they earn their place.
// Internal to analysis/diagnosis/ladder.
#pragma once
#include "analysis/diagnosis/ladder/climb.h"
#include "analysis/diagnosis/ladder/fit_set.h"
#include "analysis/diagnosis/ladder/windows.h"
#include "analysis/diagnosis/policy/rules.h"
#include "analysis/diagnosis/search/attribute.h"
#include "analysis/diagnosis/search/search.h"

#include <algorithm>

namespace stickslip::gap {

constexpr std::size_t near = 3, dear_looks = 6;  // singles, best first

/// Whether the causes beyond those of `without` earn their place.
bool earns(const FittedSet& without, const FittedSet& with, const LadderRules& rules);

/// Whether another judged set may be the answer in the place of one: as many other causes, those below among them. What
/// could not be a rung cannot be the cause in its place either.
bool may_stand_for(const FittedSet& other, const FittedSet& set, const Candidate& below);

class Climber {
  public:
    Climber(const std::vector<Attribution>& singles, SetFitter& fitter, const LadderRules& rules,
            const ParallelFor& parallel)
        : singles_(singles), fitter_(fitter), rules_(rules), parallel_(parallel)
    {
    }

    /// Sets that were judged beside other corrections are no rivals of those to come.
    void forget() { pool_.clear(); }

    /// Every cause that is not yet in the set on top of it; the best few of a first look, judged, best first.
    std::vector<FittedSet> next(const FittedSet& below) { return judged(looks(below)); }

    /// The best few before they are judged.
    std::vector<Start> looks(const FittedSet& below)
    {
        std::vector<Start> looks;
        // divided masses cost ten times as much: beside another cause only those that come near alone, and beside them
        // only what does. With the document's numbers as they are anything that mends those comes nearer: the first
        // rung looks at all
        const std::size_t most = two_mass_edit(below.causes) ? dear_looks : rules_.first_look;
        for (std::size_t i = 0; i < singles_.size() && looks.size() < most; ++i) {
            const Candidate& single = singles_[i].candidate;
            const auto& in = below.causes.effects;
            const bool too_dear = two_mass_edit(single) && i >= near && !in.empty();
            if (std::find(in.begin(), in.end(), single.effects[0]) != in.end() || too_dear) continue;
            looks.push_back({below.causes, single.effects[0], single.forms[0], singles_[i].x});
            looks.back().causes.records = single.records;
        }
        for (auto& look : divided_anew(below)) looks.push_back(std::move(look));
        parallel_(looks.size(), [&](std::size_t i) { fitter_.look(looks[i], below); });  // adds the cause
        std::stable_sort(looks.begin(), looks.end(),
                         [](const Start& a, const Start& b) { return a.objective < b.objective; });
        std::vector<const Effect*> nearer;
        std::erase_if(looks, [&](const Start& s) {
            const bool again = std::ranges::count(nearer, s.effect) > 0;
            nearer.push_back(s.effect);
            return again || s.x0.size() == 0;
        });
        if (looks.size() > rules_.finalists) looks.resize(rules_.finalists);
        return looks;
    }

    /// Fitted to all rows and every fold, best first. Of a cause whose numbers came to their bounds the other forms,
    /// too.
    std::vector<FittedSet> judged(const std::vector<Start>& starts);

    /// The best of those that could not be distinguished from the first, each fitted anew to the lower noise floor.
    FittedSet compared(const std::vector<FittedSet>& rivals)
    {
        std::vector<Start> again;
        for (const auto& set : rivals) again.push_back({set.causes, nullptr, nullptr, {}, 0, set.fit.x});
        const auto sets = judged(again);
        const auto best = std::ranges::find_if(sets, [](const auto& s) { return s.plausible && !s.correction; });
        return best == sets.end() ? rivals[0] : *best;
    }

    /// The set with one of its causes exchanged for another that was judged on the way, best first: what came nearest
    /// beside others, or alone, need not be what belongs beside these.
    std::vector<FittedSet> exchanged(const FittedSet& set)
    {
        constexpr std::size_t most = 3;  // go on after a first look
        std::vector<FittedSet> less;
        for (std::size_t i = 0; i < set.causes.effects.size(); ++i) less.push_back(unfitted_without(set, i));
        std::vector<std::pair<Start, const FittedSet*>> looks;
        for (const auto& below : less)
            for (const auto& single : singles_) {
                const Candidate& other = single.candidate;
                if (two_mass_edit(other) || !worth_an_exchange(set, below, *other.effects[0])) continue;
                looks.emplace_back(Start{below.causes, other.effects[0], other.forms[0], single.x}, &below);
                looks.back().first.causes.records = other.records;
            }
        parallel_(looks.size(), [&](std::size_t i) { fitter_.look(looks[i].first, *looks[i].second); });
        std::vector<Start> starts;
        for (auto& [start, below] : looks)
            if (start.x0.size() > 0) starts.push_back(std::move(start));
        std::ranges::stable_sort(starts, {}, &Start::objective);
        if (starts.size() > most) starts.resize(most);
        return judged(starts);
    }

    /// The set with those of its corrections as causes that stand at the bound of what a document is off: held back,
    /// they bend what is fitted with them.
    FittedSet freed(FittedSet set)
    {
        for (std::size_t i = 0, at = 0; i < set.model.corrections;) {
            const Candidate& all = set.model.candidate;
            const bool bound = Corrections::at_its_bound(all, i, at, set.fit.x);
            const auto single = std::ranges::find_if(
                singles_, [&](const Attribution& s) { return s.candidate.effects[0]->name == all.effects[i]->name; });
            at += all.count_of(*all.forms[i++]);
            if (!bound || all.forms[i - 1]->own > 0 || Corrections::is_small_term(*all.effects[i - 1]) ||
                single == singles_.end())
                continue;
            const Effect* effect = single->candidate.effects[0];
            Start start{set.causes, effect, &effect->forms[0], single->x};
            fitter_.look(start, set);
            if (start.x0.size() == 0) continue;
            FittedSet more = judged({start})[0];
            if (more.plausible && !more.correction && more.misfit < set.misfit) set = std::move(more), i = at = 0;
        }
        return set;
    }

    /// The set with the flexible members of its causes' families, where these predict so much better that they would
    /// earn a rung: what only differs in shape from the catalogue's formula belongs to the cause, not to another one.
    FittedSet flexed(FittedSet set);

    /// The set without one of its causes.
    FittedSet without(const FittedSet& set, std::size_t member) const
    {
        const FittedSet less = unfitted_without(set, member);
        return fitter_.fit(less.causes, less.fit.x);
    }

    /// Of the causes of a set the one without which least is lost goes last, and so on down. Without a cause its number
    /// is as documented: where its correction came back and took most of the cause's place, the gap would not be the
    /// cause's.
    std::vector<FittedSet> in_order(FittedSet set) const;

    /// Other sets of as many causes as this one that hold all causes of the one below it, best first. What stands in
    /// the place of a cause does without the cause's number: one that leaves it to a correction says that the cause
    /// acts, too.
    std::vector<FittedSet> in_place_of(const FittedSet& set, const Candidate& below) const;

  private:
    /// The causes but one, with the numbers that they have in the set.
    FittedSet unfitted_without(const FittedSet& set, std::size_t member) const
    {
        Candidate causes;
        causes.records = set.causes.records;
        const Eigen::VectorXd own = set.of_causes(set.fit.x);
        Eigen::VectorXd x;
        Eigen::Index at = 0;
        for (std::size_t i = 0; i < set.causes.effects.size(); ++i) {
            const auto count = static_cast<Eigen::Index>(set.causes.count_of(*set.causes.forms[i]));
            if (i != member) x = insert(causes, set.causes.effects[i], set.causes.forms[i], x, own.segment(at, count));
            at += count;
        }
        return fitter_.unfitted(causes, set, x);
    }
    std::vector<FittedSet> fitted(const std::vector<Start>& starts);
    /// A divided mass in its plain form, with no numbers to start from: beside a larger cause, or numbers of the
    /// document that were off, it came nearest alone in another form, or with a spring so stiff that nothing moved.
    std::vector<Start> divided_anew(const FittedSet& below) const;
    /// Misfit of a set with the number that this effect changes as documented, if a correction of it is in the set.
    double misfit_as_documented(const FittedSet& set, const Effect& effect) const;
    std::vector<Start> in_other_forms(const FittedSet& set, const Effect& effect) const;
    /// Where a set may start with the flexible member of one of its causes: from the shape it has, and, of a wave whose
    /// second harmonic may have been taken for the first, from a wave of twice the length.
    std::vector<Start> with_flexible_member(const FittedSet& set, std::size_t member) const;
    /// Whether this cause was judged before, and not yet in the place of the one that the set has beside `below`.
    bool worth_an_exchange(const FittedSet& set, const FittedSet& below, const Effect& other) const
    {
        if (std::ranges::count(set.causes.effects, &other) > 0) return false;
        auto effects = below.causes.effects;
        effects.insert(std::ranges::upper_bound(effects, &other), &other);
        const auto holds = [&](const FittedSet& s) { return std::ranges::count(s.causes.effects, &other) > 0; };
        const auto same = [&](const FittedSet& s) { return s.causes.effects == effects; };
        return std::ranges::any_of(pool_, holds) && std::ranges::none_of(pool_, same);
    }

    std::vector<FittedSet> pool_;  ///< all sets that were judged
    const std::vector<Attribution>& singles_;
    SetFitter& fitter_;
    const LadderRules& rules_;
    const ParallelFor& parallel_;
};

}  // namespace stickslip::gap
