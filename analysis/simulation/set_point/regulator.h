// A loop with integral action that holds a set point, and the motion under it between stops.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/simulation/flows/flow.h"

namespace stickslip {

/// u = k_p e + k_v ė + w, ẇ = k_i e, in units of effort on the mechanism, with what bounds it: the dead zone takes its
/// width from the error, as in the sampled loop, the integral grows only within its band and up to its limit, the
/// output up to its own.
struct Regulator {
    double inertia = not_set;
    double per_signal = 1;  ///< effort per command
    double k_p = not_set, k_v = 0, k_i = 0;
    double drag = 0;  ///< what a motor on a voltage resists by its back-EMF, whatever the controller gives
    double dead_zone = 0, integral_limit = infinity, integral_band = infinity, effort_limit = infinity;
    AntiWindup anti_windup = AntiWindup::none;
    double tracking_time = not_set;
    FeedForward push;   ///< against dry friction, its level in effort on the mechanism; the rest acts on no set point
    double dither = 0;  ///< amplitude

    /// The error −x as the controller counts it.
    double error(double x) const { return std::abs(x) <= dead_zone ? 0 : std::copysign(dead_zone, x) - x; }
    /// Nothing but gains: what slip.h has in closed form.
    bool linear() const
    {
        return dead_zone == 0 && integral_limit == infinity && integral_band == infinity && effort_limit == infinity &&
               !push.fed_back() && dither == 0;
    }
    /// What holds or moves the mass at rest beside the integral: k_p e and the push towards the set point.
    double push_at_rest(double x) const
    {
        const double e = error(x);
        return push.by_error() ? k_p * e + push.coulomb * push.side(e) : k_p * e;
    }
    /// The error outside the dead zone up to which that holds no more than a force.
    double error_holding(double force) const
    {
        if (!(force > 0)) return 0;
        if (!push.by_error()) return force / k_p;
        const double w = push.coulomb_width, within = w > 0 ? force / (k_p + push.coulomb / w) : infinity;
        return within <= w ? within : std::max(w, (force - push.coulomb) / k_p);
    }
};

/// The joint's loop as a regulator. The motion is about the effort, so that the actuator's gain, a motor's constants
/// and the limits on the way are in it; sampling, dead time, lag, sensor and reference are not.
Regulator regulator_of(const Joint& joint);

/// m v̇ = u(x, v, w) − drag v − f(v, θ), y = (x, v, w, θ_i), x from the set point.
class RegulatorFlow final : public Flow {
  public:
    /// `position` and `speed` are sizes of the expected motion.
    RegulatorFlow(const Regulator& regulator, const Friction& friction, double position, double speed);

    Branch branch = Branch::forward;  ///< of a friction that is set-valued at rest
    double side = 1;                  ///< of the error, where a push jumps with it: 1, 0 in the dead zone, −1
    bool along_limit = false;         ///< an integral that waits at the effort limit keeps the command on it

    int size() const override { return 3 + states_; }
    FlowVector steady() const override { return FlowVector::Zero(size()); }
    FlowVector scale() const override;
    void rate(const FlowVector& y, FlowVector& rate) const override;
    void jacobian(const FlowVector& y, FlowMatrix& jacobian) const override;
    double velocity(const FlowVector& y) const override { return y[1]; }
    double position(const FlowVector& y) const override { return y[0]; }
    double speed_measure(const FlowVector& y) const override { return y[1] / speed_; }
    FlowVector speed_gradient(const FlowVector&) const override;
    double commanded_velocity() const override { return 0; }
    bool logarithmic_speed() const override { return false; }
    void surround(double force, double normal_load) override;
    std::unique_ptr<Flow> with_gain(double k_p) const override;
    double gain() const override { return regulator_.k_p; }
    std::unique_ptr<Flow> copy() const override { return std::make_unique<RegulatorFlow>(*this); }

    /// What the controller gives at y.
    double effort(const FlowVector& y, double* asked = nullptr) const { return output(y, asked).value; }
    /// Of an integral that waits at the effort limit: the share of its time that it would have to wind up to keep the
    /// command there. Within (0, 1) it does: winding up crosses the limit and waiting falls back from it, a sliding
    /// mode in the sense of A. Filippov, Differential Equations with Discontinuous Righthand Sides, 1988. NaN where it
    /// never waits.
    double share_along_limit(const FlowVector& y) const;
    const Regulator& regulator() const { return regulator_; }
    const Friction& friction() const { return friction_; }
    double speed() const { return speed_; }

  private:
    /// A function of y and its derivatives by x, v and w.
    struct Linearised {
        double value = 0, by_x = 0, by_v = 0, by_w = 0;
    };
    Linearised output(const FlowVector& y, double* asked = nullptr) const;
    Linearised pushed(const FlowVector& y) const;
    Linearised winding(const FlowVector& y) const;
    Linearised along(const FlowVector& y, double limit) const;
    FrictionResponse response(const FlowVector& y) const;

    Regulator regulator_;
    Friction friction_;
    double position_, speed_, force_ = 0;
    int states_;
};

}  // namespace stickslip
