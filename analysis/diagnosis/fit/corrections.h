// The numbers of a joint file are a few per cent off: inertia, Coulomb and viscous friction and load enter every
// comparison as numbers with a prior, refitted on both sides. So do the small terms that every machine has and no
// document: a ripple, a cogging, a drift. They are corrections of the document, no causes.
#pragma once
#include "analysis/diagnosis/fit/fit.h"
#include "analysis/diagnosis/policy/rules.h"

#include <deque>
#include <optional>

namespace stickslip::gap {

/// A cause, or several, with the corrections in front.
struct Corrected {
    Candidate candidate;
    std::size_t corrections = 0;  ///< effects at the head that are corrections
    std::size_t numbers = 0;      ///< how many parameters these have
};

/// The corrections that a joint can have. They are named as the effects of the catalogue that change the same number:
/// where such an effect is a cause, its prior must not hold it back, and its correction is left out.
class Corrections {
  public:
    Corrections(const std::vector<Case>& cases, const Scales& scales, const CorrectionPrior& prior);

    /// One of the small terms, as the effect of the catalogue that it is: a size with a prior around nothing, and where
    /// or how fast it acts around these numbers of a fit.
    void add_small_term(const Effect& effect, const EffectForm& form, const Eigen::VectorXd& x);
    bool has(std::string_view name) const;
    /// Whether a load that no document states is no correction from now on, of any size, and neither is an angle of
    /// gravity, which is one over a small travel.
    void release_load(bool released);
    /// The effects that may be small terms, in the order in which they are looked for.
    static std::span<const std::string_view> small_terms();
    /// Whether a correction is a small term, no number of the document.
    static bool is_small_term(const Effect& correction);

    /// The causes behind the corrections.
    Corrected beside(const Candidate& causes) const;
    /// The same with one of the corrections left out: its number stays as documented.
    static Corrected but(Corrected all, std::size_t correction);
    /// Whether a cause is one of the small terms that every machine has, and no larger than they are.
    bool is_usual(const Candidate& causes, const Eigen::VectorXd& x, const Effect& cause) const;
    /// Which of the causes changes a number that a correction changes, or is a small term that is one, and is no larger
    /// than its prior allows, if one is: then it is that correction, held back by nothing.
    std::optional<std::size_t> one_of(const Candidate& causes, const Eigen::VectorXd& x) const;
    /// Whether this form of a cause changes a number that a correction changes.
    bool same_number(const Effect& effect, const EffectForm& form) const;
    /// How far a correction with numbers from `at` on is from the document, in standard deviations of its prior: of a
    /// wave its amplitude, wherever it lies.
    static double deviations(const Candidate& candidate, std::size_t correction, std::size_t at,
                             const Eigen::VectorXd& x);
    /// As far off as a document is at most, where its correction holds a cause back.
    static bool at_its_bound(const Candidate& candidate, std::size_t correction, std::size_t at,
                             const Eigen::VectorXd& x);
    /// Numbers for that: corrections from `corrections` (empty: as documented) of `from`, causes from `causes`.
    static Eigen::VectorXd start(const Corrected& to, const Corrected& from, const Eigen::VectorXd& corrections,
                                 const Eigen::VectorXd& causes);

  private:
    bool is_released(std::string_view name) const;
    void add(std::string_view name, const EffectParameter& parameter, void (*apply)(Joint&, const double*), bool own);

    std::deque<Effect> effects_;            // candidates point at them
    std::vector<std::vector<double>> sds_;  // of the numbers of each
    std::size_t records_;
    bool load_released_ = false;
    double weight_, widest_;
    double usual_effort_ = 0, usual_drag_ = 0;  ///< largest small term, in units of a parameter's scale
    double small_sd_ = 0;                       ///< of the prior of its size
};

}  // namespace stickslip::gap
