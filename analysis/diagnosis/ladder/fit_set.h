// Fits one set of causes beside the corrections: a first look on excerpts, then all rows and every fold.
#pragma once
#include "analysis/diagnosis/ladder/ladder.h"

#include <algorithm>

namespace stickslip::gap {

/// Adds a cause to a set and its numbers to theirs, in the order of the catalogue: edits that change the model of the
/// joint come last.
Eigen::VectorXd insert(Candidate& causes, const Effect* effect, const EffectForm* form, const Eigen::VectorXd& numbers,
                       const Eigen::VectorXd& of_effect);

/// A set of causes that is to be looked at, and where its fit may start.
struct Start {
    Candidate causes;                ///< those below, until the first look adds the other
    const Effect* effect = nullptr;  ///< the cause that is added
    const EffectForm* form = nullptr;
    std::array<Eigen::VectorXd, levels.size()> alone{};  ///< its numbers, as fitted alone
    double objective = infinity;                         ///< after a first look
    Eigen::VectorXd x0 = {};                             ///< with the corrections
};

/// A first look: at what, on top of what.
struct Look {
    Start* start;
    const FittedSet* below;
};

class SetFitter {
  public:
    SetFitter(const HeldOutData& data, const Scales& scales, const Corrections& corrections,
              std::span<const PhysicalRange> ranges)
        : data_(data), scales_(scales), corrections_(corrections), ranges_(ranges)
    {
    }
    const Joint& joint() const { return data_.cases()[0].joint; }
    bool logs_effort() const
    {
        return std::ranges::any_of(data_.cases(), [](const Case& c) { return c.ticks.has_effort; });
    }
    /// Whether this cause of a set is a small term of every machine, and no larger than they are.
    bool is_usual(const FittedSet& set, const Effect& cause) const
    {
        return corrections_.is_usual(set.causes, set.of_causes(set.fit.x), cause);
    }
    /// Whether one of the causes of a set is a number that a correction changes.
    bool is_of_document(const FittedSet& set, std::size_t cause) const
    {
        return corrections_.same_number(*set.causes.effects[cause], *set.causes.forms[cause]);
    }
    /// How many of the causes of a set are numbers of the document.
    std::size_t of_document(const FittedSet& set) const
    {
        std::size_t numbers = 0;
        for (std::size_t i = 0; i < set.causes.effects.size(); ++i) numbers += is_of_document(set, i);
        return numbers;
    }
    /// Excerpts anew, after the prediction floors have moved.
    void renew();
    /// Numbers of a set: corrections as in `like`, causes as given.
    Eigen::VectorXd start(const Candidate& causes, const FittedSet& like, const Eigen::VectorXd& of_causes) const;
    /// A set with these numbers that nothing was fitted to.
    FittedSet unfitted(const Candidate& causes, const FittedSet& like, const Eigen::VectorXd& of_causes) const;
    /// Adds the cause: a few steps on excerpts from the best of its starts, the others as in the set below. All side by
    /// side.
    void look(std::span<const Look> looks) const;
    /// On top of a set: the widths of backlash, so many times apart, at which the misfit has a dip, without any fit.
    std::vector<Start> dips(const FittedSet& below, const Effect& effect, const EffectForm& form, double step) const;
    /// To all rows alone.
    LevelFit refit(const Candidate& causes, const Eigen::VectorXd& x0) const;
    FittedSet fit(const Candidate& causes, const Eigen::VectorXd& x0) const;
    /// Some sets side by side, to all rows and not to the folds: what they leave and miss by there is with numbers that
    /// have seen them, and so less than what is held out.
    std::vector<FittedSet> fit_rows(std::span<const Start* const> starts) const;
    /// The folds of sets whose rows are fitted.
    void fit_folds(std::span<FittedSet* const> sets) const;
    /// What is left of a set after a cause was taken away: waves stay where they are. One that moved into the place of
    /// what was taken away would be another cause.
    FittedSet fit_rest(const Candidate& causes, const Eigen::VectorXd& x0) const;
    /// The same of numbers that a search has found: only the folds are fitted.
    FittedSet fit_folds(const Candidate& causes, LevelFit found) const;
    /// The set with the number of one of its corrections as documented, the others refitted, waves where they are.
    FittedSet fit_without(const FittedSet& set, std::size_t correction) const;

    /// What each fold leaves with the numbers that the set has there, the misfit, and whether the set may be one.
    void judge(FittedSet& set) const;

  private:
    enum class Waves { move, stay };
    /// A descent from where the numbers already are.
    Fitting<LevelFit> near(const std::vector<Case>& cases, const Candidate& candidate, const Eigen::VectorXd& x,
                           int steps, Waves waves) const;
    /// As well as the set that it is compared with: what is jagged is searched there, too.
    LevelFit rest(const Candidate& candidate, const Eigen::VectorXd& x) const;
    FittedSet fit_folds(Corrected model, const Candidate& causes, LevelFit found, Waves waves) const;
    /// What was found in all rows, the folds to be fitted.
    FittedSet found_set(Corrected model, const Candidate& causes, LevelFit found) const;
    void fit_folds(std::span<FittedSet* const> sets, Waves waves) const;
    /// The fits that a look consists of, of a model that has to outlive them.
    std::vector<Fitting<LevelFit>> begun(Start& start, const FittedSet& below, Corrected& model) const;
    const HeldOutData& data_;
    const Scales& scales_;
    const Corrections& corrections_;
    std::span<const PhysicalRange> ranges_;
    std::vector<Case> brief_, whole_;
};

}  // namespace stickslip::gap
