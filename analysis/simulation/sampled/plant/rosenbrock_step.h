// Steps of a driven joint without allocation, where thousands of ticks each take a few: Dormand and Prince's method
// while the equations are not stiff, Rodas5P where they are.
#pragma once
#include "analysis/simulation/sampled/plant/driven_joint.h"
#include "analysis/simulation/solvers/dormand_prince.h"
#include "analysis/simulation/solvers/rodas5p_table.h"

namespace stickslip {

/// One step of ẏ = F(y) from y0, of length h, with its dense output.
class RosenbrockStep {
  public:
    DrivenState y0, y1;
    double h = 0;
    bool implicit_only = false;  ///< one method for all steps, as differences of neighbouring motions need

    /// Fills y1. False where the matrix is singular or the law left its domain.
    bool take(const DrivenJoint& joint);
    /// Largest error over rtol (scale + |y|).
    double error(const DrivenJoint& joint, double rtol) const;
    /// y at a fraction of the step.
    void dense(double fraction, double* y) const;
    /// ẏ at the start of the step, which take() computes on its way.
    const double* first_rate() const { return k_[0].data(); }
    /// ẏ at its end.
    const double* last_rate(const DrivenJoint& joint, DrivenState& room) const;
    /// The next step begins where this one ends, under the same equations.
    void carry();
    /// The next step begins anew.
    void forget() { carried_ = false; }

  private:
    template <int fixed>
    bool take_sized(const DrivenJoint& joint);
    bool take_explicit(const DrivenJoint& joint);

    int size_ = 0;
    bool stiff_ = false;                                 ///< what comes is taken for stiff
    bool explicit_ = false;                              ///< this step was explicit
    bool carried_ = false;                               ///< k_[0] holds already
    double stiffness_ = 0;                               ///< h |λ| of the last step, about
    std::array<DrivenState, dormand_prince::stages> k_;  ///< rates of an explicit step; the first of either
    std::array<DrivenState, rodas5p::stages> U_;
};

}  // namespace stickslip
