// What fits leave on rows that they have not seen: every record in contiguous parts that are held out in turn.
#pragma once
#include "analysis/diagnosis/fit/fit.h"

namespace stickslip::gap {

/// Fits and squares of a ladder are those of the middle horizon.
inline constexpr std::size_t ladder_level = 1;

/// One part of one record while it is held out: mean squares in units of the documented noise.
struct Window {
    std::size_t record = 0;
    std::size_t from = 0, to = 0;  ///< rows
    double position = 0, effort = not_set;
    double rows() const { return static_cast<double>(to - from); }
    /// What is beyond the noise, over all rows and signals.
    double beyond_noise() const
    {
        return rows() * (std::max(0.0, position - 1) + (is_set(effort) ? std::max(0.0, effort - 1) : 0));
    }
};

/// Records for fits and for judging. Every fold holds out one third of each record, a different third of each, so that
/// numbers which a record has for itself are known in every fold, and no fold lacks a whole kind of motion.
class HeldOutData {
  public:
    static constexpr std::size_t folds = 3;
    explicit HeldOutData(std::vector<Case> documented);

    const std::vector<Case>& cases() const { return documented_; }
    /// With the floor that fits weigh by.
    const std::vector<Case>& fitted() const { return fitted_; }
    const std::vector<Case>& without(std::size_t fold) const { return rest_[fold]; }
    /// The noise of every record becomes what this model leaves, and never less than the documented one: where more
    /// than noise is left, the model's error is what the next comparison has to go by. Gives the mean log square that
    /// is left.
    double raise_floor(const Candidate& candidate, const std::vector<double>& si);

    /// The windows of a fold with their squares under a model.
    std::vector<Window> judge(std::size_t fold, const Candidate& candidate, const std::vector<double>& si) const;
    /// The windows of every fold with their squares under a model that has these numbers there.
    std::array<std::vector<Window>, folds> judge(const Candidate& candidate,
                                                 const std::array<std::vector<double>, folds>& si) const;
    /// The windows of all folds, without squares.
    const std::vector<Window>& windows(std::size_t fold) const { return windows_[fold]; }

  private:
    std::vector<Window> squares(std::size_t fold, const std::vector<double>& residuals) const;

    std::vector<Case> documented_, fitted_;
    std::array<std::vector<Case>, folds> rest_;
    std::array<std::vector<Window>, folds> windows_;
};

/// Mean over windows and signals of the logarithm of what is left: one lost step counts once, however far it leads.
double mean_log(const std::vector<Window>& windows);
/// The same for a reader: what is below the noise counts as noise, so that 0 is noise, as in the score of a single fit.
double misfit(const std::vector<Window>& windows);
/// Sum of what is beyond the noise.
double beyond_noise(const std::vector<Window>& windows);

}  // namespace stickslip::gap
