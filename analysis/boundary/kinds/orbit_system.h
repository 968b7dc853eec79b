// Closed orbits of a joint as solutions of equations in the states on the section V = V_0 and in one or two of the
// joint's parameters. Internal to analysis/boundary.
#pragma once
#include "analysis/boundary/trace/chart.h"
#include "analysis/boundary/trace/continuation.h"
#include "analysis/joint/joint.h"
#include "analysis/simulation/attractor/cycle.h"

#include <string>
#include <vector>

namespace stickslip {

/// One turn of a motion that starts on the section.
struct OrbitTurn {
    Eigen::VectorXd gap;  ///< end less start, per scale, without the speed
    Eigen::MatrixXd map;  ///< ∂end/∂start on the section
    double fold = 0;      ///< det(map − 1): zero where two orbits merge
    Cycle path;
};

/// Unknowns z = (w, q): w the start on the section less steady sliding, per scale and without the speed; q the
/// parameters as shares of their axes.
class OrbitSystem {
  public:
    /// Axes give the paths and ranges of the parameters. The joint has to have a smooth flow when it is evaluated.
    OrbitSystem(const Joint& joint, const std::vector<Axis>& axes, double rtol = 1e-10);

    int section() const { return section_; }  ///< size of w
    int parameters() const { return static_cast<int>(units_.size()); }
    const UnitAxis& unit(int i) const { return units_[static_cast<std::size_t>(i)]; }
    int turns() const { return turns_; }  ///< revolutions followed so far

    Joint joint_at(const Eigen::VectorXd& q) const;
    /// A start of a flow's section as w.
    Eigen::VectorXd section_of(const Flow& flow, const FlowVector& y) const;
    /// Nothing where there is no smooth flow, or where the motion does not come back.
    std::optional<OrbitTurn> turn(const Eigen::VectorXd& z, double rtol = 0) const;

    /// Orbits of one parameter: gap = 0 in (w, q).
    CurveSystem orbits() const;
    /// Folds of two parameters: gap = 0 and fold = 0 in (w, q).
    CurveSystem folds() const;

  private:
    std::optional<OrbitTurn> followed_turn(const Eigen::VectorXd& z, double rtol) const;
    std::optional<Eigen::VectorXd> equations(const Eigen::VectorXd& z, bool with_fold) const;
    std::optional<Eigen::MatrixXd> derivatives(const Eigen::VectorXd& z, bool with_fold) const;

    Joint joint_;
    std::vector<std::string> paths_;
    std::vector<UnitAxis> units_;
    int section_ = 0;
    double rtol_;
    mutable int turns_ = 0;
    mutable Eigen::VectorXd last_z_;  ///< a residual, its Jacobian and its error ask for the same turn
    mutable std::optional<OrbitTurn> last_turn_;
};

}  // namespace stickslip
