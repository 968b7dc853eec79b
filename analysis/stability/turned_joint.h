// A joint of the ideal loop at any k_p, linearised where it then slides, and what its roots say there.
#pragma once
#include <optional>
#include <vector>

#include "analysis/base/crossing.h"
#include "analysis/joint/joint.h"
#include "analysis/stability/linear_joint.h"
#include "analysis/stability/resolution.h"

namespace stickslip {

/// The roots of one gain.
struct RootsAtGain {
    struct Root {
        std::complex<double> s;      ///< Im s > 0
        std::complex<double> slope;  ///< ds/d ln k_p
    };
    double k_p = missing;
    int right = 0;  ///< how many lie right of the axis
    std::vector<Root>
        roots;  ///< all pairs of a rational joint; with delays or tables those near the axis that are found
};

class TurnedJoint {
  public:
    TurnedJoint(const Joint& joint, Theory theory);

    /// Friction has delays or tables at the joint's own gain.
    bool delayed() const { return delayed_; }

    /// Nothing where the joint does not slide steadily, numbers overflow or the roots cannot be counted.
    /// `near`: the same joint at a gain not far off, from whose roots those of a delayed joint are looked for, too.
    std::optional<RootsAtGain> look(double k_p, const RootsAtGain* near = nullptr);

    /// The root of a delayed joint that Newton's method finds from `start`, if it lies above the real axis.
    std::optional<RootsAtGain::Root> root_near(double k_p, std::complex<double> start);

    /// The gain and frequency that put a root on the axis, by Newton's method in ω and ln k_p from a near start.
    std::optional<Crossing> polished(Crossing near);

    /// Places on the axis that were looked at so far, or roots of rational joints.
    long work() const { return work_; }

  private:
    std::optional<LinearJoint> at(double k_p);
    void add_slopes(RootsAtGain& here);

    Joint joint_;
    Theory theory_;
    bool delayed_ = false;
    long work_ = 0;
};

}  // namespace stickslip
