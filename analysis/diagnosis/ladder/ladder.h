// The ladder of causes: in the order in which they pay on data that no fit has seen, each given those above it, with
// the nuisance parameters refitted on both sides of every comparison.
#pragma once
#include "analysis/diagnosis/fit/corrections.h"
#include "analysis/diagnosis/fit/problem.h"
#include "analysis/diagnosis/ladder/windows.h"
#include "analysis/diagnosis/policy/rules.h"
#include "analysis/diagnosis/search/attribute.h"

#include <functional>
#include <memory>
#include <optional>

namespace stickslip::gap {

/// Causes beside the corrections, fitted to all rows and, in turn, to those that a fold leaves.
struct FittedSet {
    Candidate causes;
    Corrected model;
    LevelFit fit;                                       ///< to all rows
    std::array<Eigen::VectorXd, HeldOutData::folds> x;  ///< without each fold
    std::array<std::vector<Window>, HeldOutData::folds> left;
    bool plausible = true;
    /// Which of the causes is no larger than a correction of the same number, if one is.
    std::optional<std::size_t> correction;
    double misfit = infinity;  ///< held-out mean log square, with what the priors and the number of parameters cost

    std::vector<Window> all_left() const;
    /// Numbers of one of the causes.
    Eigen::VectorXd of_member(std::size_t member) const;
    /// Squares of what the corrections are off by, in standard deviations of their priors.
    double deviations() const;
    /// Numbers of the causes alone.
    Eigen::VectorXd of_causes(const Eigen::VectorXd& of_all) const
    {
        return of_all.tail(of_all.size() - static_cast<Eigen::Index>(model.numbers));
    }
};

/// A number of the document that is far off beside the causes of a ladder.
struct FarNumber {
    const Effect* effect;               ///< the correction
    bool unstated_load;                 ///< a load that the document does not mention
    std::vector<Window> as_documented;  ///< what is left with the number as it stands there, all others refitted
};

/// A set that was tried in the place of a rung.
struct Rival : FittedSet {
    Rival(FittedSet set) : FittedSet(std::move(set)) {}
    /// Misfit of the last rung with this one's cause in the place of the rung's own, where that was fitted.
    std::optional<double> in_the_last;
    std::shared_ptr<const FittedSet> whole;  ///< that set, where it can be the answer

    /// What is named if this cause is.
    const FittedSet& named() const { return whole ? *whole : *this; }
};

struct Ladder {
    std::shared_ptr<const Corrections> corrections;  ///< the models point at its effects
    std::vector<Window> documented;                  ///< what the joint leaves as the document describes it
    FittedSet corrected;                             ///< the corrections alone
    std::vector<FittedSet> rungs;                    ///< the first cause, the first two, …
    /// Of every rung the other causes that were tried in its place, best first.
    std::vector<std::vector<Rival>> rivals;
    /// The corrections that go with the last rung, alone.
    std::vector<Window> corrected_as_last;

    const FittedSet& last() const { return rungs.empty() ? corrected : rungs.back(); }
};

/// By how much of held-out mean log square one set has to beat another to be distinguished from it: model error is as
/// large as what the better one leaves beyond the noise, noise itself as the rows allow.
double margin_of(const FittedSet& better, const LadderRules& rules);

/// By how much of misfit a set has to beat one of fewer numbers.
double least_gain(const FittedSet& with, const LadderRules& rules);

/// What part of what a set leaves beyond the noise a larger one takes: of the sum of squares, or, with a jagged cause,
/// of their geometric mean over windows, if that is more. Where a joint falls on the wrong flank of its backlash a few
/// windows are lost whatever the numbers, and hold most of the squares.
double part_taken(const FittedSet& without, const FittedSet& with);

/// Whether the causes beyond those of `without` earn their place.
bool earns(const FittedSet& without, const FittedSet& with, const LadderRules& rules);

class Climber;
class SetFitter;
struct Start;
/// Whether all that a set leaves is noise: then there is nothing to climb for.
using OnlyNoise = std::function<bool(const FittedSet&)>;

/// Climbs from singles, each in its best form and with the numbers that its fit came to, best first.
class LadderSearch {
  public:
    LadderSearch(const Fit& fit, const std::vector<Attribution>& singles, const LadderRules& rules);
    ~LadderSearch();
    LadderSearch(const LadderSearch&) = delete;

    /// The best cause alone, worth a rung or not; null where there is none to try.
    const FittedSet* first() const { return first_.empty() ? nullptr : &first_[0]; }
    /// At most so many rungs; pairs that a search of their own has found are tried as the first two.
    Ladder climb(const std::vector<Attribution>& pairs, std::size_t most_rungs, const OnlyNoise& only_noise = {});
    /// The corrections beside the last rung, or alone, that are far off, and what keeping each one as documented costs.
    std::vector<FarNumber> far_off(const Ladder& ladder) const;
    /// Takes the last rung away.
    void shorten(Ladder& ladder) const;
    /// Without this one of its causes.
    Ladder without(const Ladder& ladder, const Effect& cause);
    /// Climbed anew with the last of the causes among the corrections, as a small term of every machine; nothing where
    /// it can be none, or a term of its kind is one already.
    std::optional<Ladder> with_small_term(const Ladder& ladder, const std::vector<Attribution>& pairs,
                                          const OnlyNoise& only_noise);
    /// Climbed anew without a load that no document states among the corrections: a cause like any other, it has
    /// rivals.
    Ladder with_load_released(const std::vector<Attribution>& pairs, const OnlyNoise& only_noise);
    /// The load is a correction again: what is climbed with it stays the answer.
    void hold_load();
    /// Ladders of sets with a scale of the effort (`Climber::over_a_scale`) that predict rows as well as this one does.
    std::vector<Ladder> over_a_scale(const Ladder& ladder);
    /// The ladder of causes that are known.
    Ladder of(const Attribution& known);

    /// The joint with its corrections and no cause.
    const FittedSet& corrected() const { return corrected_; }
    /// Whether these corrections are no further off than documents usually are.
    bool usually_off() const;

    const HeldOutData& data() const { return data_; }

  private:
    void begin();
    /// Causes of the first rung and wrong numbers, beside other corrections than before.
    void look_anew();
    /// Those that a rung could as well be, compared at the floor that the first of them leaves.
    FittedSet nearest_of(const std::vector<FittedSet>& tried, const FittedSet& next);
    FittedSet in_best_forms(FittedSet found);
    /// Without the causes that earn nothing beside what came after them.
    FittedSet without_idle(FittedSet set) const;
    /// Of sets that were tried on top of one, best first: the nearest, where it would earn its place but for a number
    /// at its bounds. The cause of that number may only stand in for another one, which is found by an exchange.
    const FittedSet* nearest_at_bounds(const std::vector<FittedSet>& tried, const FittedSet& below) const;
    /// With a cause exchanged for another, if that comes nearer.
    FittedSet with_an_exchange(FittedSet set);
    /// Whether numbers of the document are nearer than a set of other causes.
    bool nearer_than(const FittedSet& set, const FittedSet& numbers) const;
    /// Several wrong numbers in the place of a cause, or of none, where they are nearer.
    std::optional<FittedSet> nearer_numbers(const FittedSet* than) const;
    /// With numbers of the document in the place of a cause that only imitates them.
    FittedSet with_wrong_numbers(FittedSet set, std::size_t most_rungs) const;
    FittedSet climbed(const std::vector<Attribution>& pairs, std::size_t most_rungs, const OnlyNoise& only_noise);
    /// What was climbed beside new corrections, or the set that they were found beside where it is nearer with them:
    /// a search that begins elsewhere may end in a worse place.
    FittedSet or_before(FittedSet anew, const FittedSet& before);
    void correct(FittedSet& set);
    void find_small_terms(std::vector<Start>& looks);
    bool found_small_terms(const FittedSet& set);
    /// The prediction floor down to what these numbers leave; gives the mean log square of that.
    double lower_floor(const Corrected& model, const Eigen::VectorXd& x);
    /// Fitted anew to the floor that it leaves, until both agree.
    FittedSet settled(FittedSet set);
    Ladder finished(FittedSet set);
    void correct_alone(Ladder& ladder) const;
    /// Several numbers of the document, where they could be the answer in the place of one cause.
    void add_wrong_numbers(Ladder& ladder) const;
    /// What is near to a lower rung alone may be out of the question beside the rungs on top of it.
    void try_rivals_in_the_last(Ladder& ladder) const;

    const Scales& scales_;
    const LadderRules& rules_;
    const ParallelFor& parallel_;
    std::shared_ptr<Corrections> corrections_;
    HeldOutData data_;
    std::vector<Window> documented_;
    FittedSet corrected_;
    std::unique_ptr<SetFitter> fitter_;
    std::unique_ptr<Climber> climber_;
    std::vector<FittedSet> first_;            ///< causes in place of the first rung, best first
    std::optional<FittedSet> wrong_numbers_;  ///< of the document, two and more that are further off than documents are
};

}  // namespace stickslip::gap
