// Rodas5P for a system of a few equations without allocation: the step of solvers/rodas5p.h where thousands of ticks
// each take one or two.
#pragma once
#include "analysis/simulation/sampled/driven_joint.h"
#include "analysis/simulation/solvers/rodas5p_table.h"

namespace stickslip {

/// One step of ẏ = F(y) from y0, of length h, with its dense output.
class RosenbrockStep {
  public:
    DrivenState y0, y1;
    double h = 0;

    /// Fills y1. False where the matrix is singular or the law left its domain.
    bool take(const DrivenJoint& joint);
    /// Largest error over rtol (scale + |y|).
    double error(const DrivenJoint& joint, double rtol) const;
    /// y at a fraction of the step.
    void dense(double fraction, double* y) const;
    /// ẏ at the start of the step, which take() computes on its way.
    const double* first_rate() const { return first_rate_.data(); }

  private:
    template <int fixed>
    bool take_sized(const DrivenJoint& joint);

    int size_ = 0;
    DrivenState first_rate_;
    std::array<DrivenState, rodas5p::stages> U_;
};

}  // namespace stickslip
