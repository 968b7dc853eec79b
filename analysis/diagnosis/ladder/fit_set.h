// Fits one set of causes beside the corrections: a first look on excerpts, then all rows and every fold.
#pragma once
#include "analysis/diagnosis/ladder/climb.h"

namespace stickslip::gap {

/// A set of causes that is to be looked at, and where its fit may start.
struct Start {
    Candidate causes;
    std::array<Eigen::VectorXd, levels.size()> alone{};  ///< numbers of the last cause, as fitted alone
    double objective = infinity;                         ///< after a first look
    Eigen::VectorXd x0 = {};                             ///< with the corrections
};

class SetFitter {
  public:
    SetFitter(const HeldOutData& data, const Scales& scales, const Corrections& corrections,
              std::span<const PhysicalRange> ranges)
        : data_(data), scales_(scales), corrections_(corrections), ranges_(ranges)
    {
    }
    /// Excerpts anew, after the floors have moved.
    void renew();
    /// Numbers of a set: corrections as in `like`, causes as given.
    Eigen::VectorXd start(const Candidate& causes, const FittedSet& like, const Eigen::VectorXd& of_causes) const;
    /// A few steps on excerpts from the best of the starts of the last cause, the others as in `below`.
    void look(Start& start, const FittedSet& below) const;
    FittedSet fit(const Candidate& causes, const Eigen::VectorXd& x0) const;

  private:
    const HeldOutData& data_;
    const Scales& scales_;
    const Corrections& corrections_;
    std::span<const PhysicalRange> ranges_;
    std::vector<Case> brief_, whole_;
};

}  // namespace stickslip::gap
