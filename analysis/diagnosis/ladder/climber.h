// The search for the next rung of a ladder: which causes go on top of a set, and whether they earn their place.
// Internal to analysis/diagnosis/ladder.
#pragma once
#include "analysis/diagnosis/ladder/fit_set.h"
#include "analysis/diagnosis/ladder/ladder.h"
#include "analysis/diagnosis/ladder/windows.h"
#include "analysis/diagnosis/policy/rules.h"
#include "analysis/diagnosis/search/attribute.h"
#include "analysis/diagnosis/search/search.h"

#include <vector>

namespace stickslip::gap {

/// Whether another judged set may be the answer in the place of one: as many other causes, those below among them. What
/// could not be a rung cannot be the cause in its place either.
bool may_stand_for(const FittedSet& other, const FittedSet& set, const Candidate& below);

/// A number that the document states.
struct Stated;

/// Which sets over a scale are wanted: all that are possible, or those that are likelier than any without.
enum class Scaled { possible, likelier };

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
    std::vector<Start> looks(const FittedSet& below);

    /// Backlash between two documented masses on top of each of these sets, where the misfit over its width has the
    /// deepest dips. Alone, every width misses by more than none: what belongs to another cause puts the link on the
    /// wrong flank.
    std::vector<Start> with_hidden_backlash(const std::vector<FittedSet>& sets) const;

    /// Fitted to all rows and every fold, best first. Of a cause whose numbers came to their bounds the other forms,
    /// too.
    std::vector<FittedSet> judged(const std::vector<Start>& starts);

    /// The best of those that could not be distinguished from the first, each fitted anew to the lower prediction
    /// floor.
    FittedSet compared(const std::vector<FittedSet>& rivals);

    /// The set with one of its causes exchanged for another that was judged on the way, best first: what came nearest
    /// beside others, or alone, need not be what belongs beside these.
    std::vector<FittedSet> exchanged(const FittedSet& set);

    /// Of sets that were tried on top of one the best, without that of its causes which is a correction, if it so comes
    /// nearer than the one below: a cause that only stood in for what was tried now shrinks to an error of the
    /// document.
    std::optional<FittedSet> without_correction(const FittedSet& below, const std::vector<FittedSet>& tried);

    /// On top of a set the numbers of the document that are further off than documents are, where at least two are,
    /// those of the set among them, all fitted at once and held back by nothing: one of them alone beside corrections
    /// comes no nearer than an effect that imitates them all. `held_back`: only where at least one of the corrections
    /// is; what it may not take goes into others, which then stay within their bounds.
    std::optional<FittedSet> wrong_numbers(const FittedSet& below, const Corrections& corrections,
                                           bool held_back) const;
    /// Numbers of a document: one is a cause like any other, and is tried as one.
    static constexpr std::size_t several = 2;
    /// How many of the corrections of a set stand at their bounds.
    static std::size_t held_back(const FittedSet& set, const Corrections& corrections);

    /// Other causes of a set beside a scale of the effort, over which the numbers of the document are what it says but
    /// for those that are wrong by another factor: a torque constant that is off makes all of them wrong by one. The
    /// likeliest such sets, judged, best first; nothing where a scale brings the numbers hardly nearer.
    std::vector<FittedSet> over_a_scale(const FittedSet& set, const Corrections& corrections, Scaled wanted);
    /// The set, or one of those in its place that is nearer and likelier.
    FittedSet with_shared_scale(FittedSet set, const Corrections& corrections);

    /// The set with those of its corrections as causes that stand at the bound of what a document is off: held back,
    /// they bend what is fitted with them.
    FittedSet freed(FittedSet set);

    /// The set with its causes in other forms of theirs, where these predict better: the form that came nearest alone
    /// had to stand in for what else acts, and what it still says of that would be left beside the others.
    FittedSet reformed(FittedSet set);

    /// The set with the flexible members of its causes' families, where these predict so much better that they would
    /// earn a rung: what only differs in shape from the catalogue's formula belongs to the cause, not to another one.
    FittedSet flexed(FittedSet set);

    /// The set with one part of a form in the form's place, where the rest of it gains nothing: a curve that is
    /// followed late by less than can be told is a curve. With all of its parts, where they are distinguished from the
    /// form.
    FittedSet in_parts(FittedSet set);

    /// The set without one of its causes.
    FittedSet without(const FittedSet& set, std::size_t member) const;
    /// The set anew from the numbers that the others have in `less`, which lacks this member.
    FittedSet with(const FittedSet& less, const FittedSet& set, std::size_t member) const;

    /// Of the causes of a set the one without which least is lost goes last, and so on down. Without a cause its number
    /// is as documented: where its correction came back and took most of the cause's place, the gap would not be the
    /// cause's. Where corrections stand in for it, they stay as they are beside it. Small terms of every machine go
    /// behind all others: alone one of them may grow into another's place. Causes that take something only together
    /// are one rung, unless they are the first.
    std::vector<FittedSet> in_order(FittedSet set) const;

    /// Other sets of as many causes as this one that hold all causes of the one below it, best first. What stands in
    /// the place of a cause does without the cause's number: one that leaves it to a correction says that the cause
    /// acts, too.
    std::vector<FittedSet> in_place_of(const FittedSet& set, const Candidate& below) const;

    /// A set with the causes of a rival in the place of those of one of its rungs; its misfit is infinite where it
    /// cannot be a rung. Nothing where the set has them already.
    std::optional<FittedSet> rival_in(const FittedSet& last, const Candidate& rung, const FittedSet& rival);

  private:
    /// What the stated numbers are where nothing holds them to the document, beside other causes of the set.
    void take_freed(const FittedSet& set, const Candidate& others, const Eigen::VectorXd& of_others,
                    std::vector<Stated>& numbers) const;
    /// Causes with a scale of the effort, in each form that it may have.
    std::vector<Start> scaled_by(double factor, const Candidate& causes, const Eigen::VectorXd& of_causes) const;
    /// Which of the causes goes last, by what is lost without each.
    std::size_t last_of(const FittedSet& set, std::vector<double> lost) const;
    /// The causes but one, with the numbers that they have in the set.
    FittedSet unfitted_without(const FittedSet& set, std::size_t member) const;
    std::vector<FittedSet> fitted(const std::vector<Start>& starts);
    /// The folds of sets that were fitted to all rows, but of those that are out of sight of the best.
    void hold_out(std::vector<FittedSet>& sets) const;
    /// The looks in groups, the dearest first.
    void look_at(std::span<const Look> looks) const;
    /// A divided mass in its plain form, with no numbers to start from: beside a larger cause, or numbers of the
    /// document that were off, it came nearest alone in another form, or with a spring so stiff that nothing moved.
    std::vector<Start> divided_anew(const FittedSet& below) const;
    /// Misfit without one of the causes, with everything else as it is.
    double misfit_held(const FittedSet& set, std::size_t member) const;
    /// Misfit of a set with the number that this effect changes as documented, if a correction of it is in the set.
    double misfit_as_documented(const FittedSet& set, const Effect& effect) const;
    /// On top of these causes, before a first look.
    std::vector<Start> other_forms(const Candidate& below, const Effect& effect, const EffectForm* than,
                                   std::size_t records) const;
    std::vector<Start> in_other_forms(const FittedSet& set, const Effect& effect) const;
    /// Without a number that stands at its bound, where a form lacks it.
    std::vector<Start> in_simpler_forms(const FittedSet& set) const;
    /// Where a set may start with the flexible member of one of its causes: from the shape it has, and, of a wave whose
    /// second harmonic may have been taken for the first, from a wave of twice the length.
    std::vector<Start> with_flexible_member(const FittedSet& set, std::size_t member) const;
    /// Every part of one of its causes' forms alone, from the numbers of the form, and behind them all together.
    std::vector<Start> parts_of(const FittedSet& set, std::size_t member) const;
    /// Whether this cause was judged before, and not yet in the place of the one that the set has beside `below`.
    bool worth_an_exchange(const FittedSet& set, const FittedSet& below, const Effect& other) const;

    std::vector<FittedSet> pool_;  ///< all sets that were judged
    const std::vector<Attribution>& singles_;
    SetFitter& fitter_;
    const LadderRules& rules_;
    const ParallelFor& parallel_;
};

}  // namespace stickslip::gap
