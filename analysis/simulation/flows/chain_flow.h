// Two or three bodies with springs between them, a friction law on each, about steady sliding.
#pragma once
#include "analysis/simulation/flows/flow.h"
#include "analysis/stability/linear_joint.h"

#include <array>
#include <complex>

namespace stickslip {

/// What delayed friction resists now, per body at its own side and against positive motion if that is how the
/// body moves. Nothing for other bodies, whose friction follows from the state.
using DelayedForces = std::array<double, max_bodies>;

/// M_i v̇_i + Σ_k (K_ik ξ_k + D_ik (v_k − w_k)) + u_i (k_p ξ_m + k_v (v_m − w_m)) + N_i (f_i − f_ss,i) = d_i in joint
/// coordinates, ξ_i the displacement from the steady path, w_i the steady velocity of body i, N_i v_i the velocity that
/// its friction feels. y = (ξ_1 … ξ_n, s_1 … s_n, θ of body 1, …) with s_i = ln(v_i/w_i) for laws that need motion and
/// v_i for the others. A body whose law is set-valued at rest, or a steep contact, sticks while the force needed to
/// hold it stays within its static friction, or what makes it creep faster than rest. Position, velocity and section
/// are those of the link. Steady sliding at V_0 < 0 is mirrored.
class ChainFlow final : public SwitchingFlow {
  public:
    enum class Mode { forward, reverse, stuck };
    struct BodyFlow {
        Friction friction;
        double inertia = 0, ratio = 0, speed = 0;  ///< M_i, N_i, w_i
        double steady_friction = 0;                ///< f_ss,i at the body's own side
        double creep = 0;                          ///< creep_speed of a steep contact, 0: none; joint coordinates
        bool logarithmic = false, rests = false;
        bool delayed = false;  ///< its friction is not known from the state (DelayedFlow)
        int states = 0, first_state = 0;
        Mode mode = Mode::forward;
    };
    int bodies = 0;
    std::array<BodyFlow, max_bodies> body;
    LinearJoint loop;  ///< springs, dampers, loop
    double V0 = not_set;
    double force = 0;  ///< d on the link, constant between calls of surround()

    int size() const override { return 2 * bodies + total_states_; }
    FlowVector steady() const override;
    FlowVector scale() const override;
    void rate(const FlowVector& y, FlowVector& out) const override { rate(y, {}, out); }
    void rate(const FlowVector& y, const DelayedForces& delayed, FlowVector& rate) const;
    void jacobian(const FlowVector& y, FlowMatrix& jacobian) const override;
    double velocity(const FlowVector& y) const override { return velocity(y, link()); }
    double position(const FlowVector& y) const override { return y[link()]; }
    double speed_measure(const FlowVector& y) const override;
    FlowVector speed_gradient(const FlowVector& y) const override;
    double commanded_velocity() const override { return V0; }
    bool logarithmic_speed() const override { return body[link()].logarithmic; }
    void surround(double d, double normal_load) override { force = d, body[link()].friction.normal_load = normal_load; }
    std::unique_ptr<Flow> with_gain(double k_p) const override;
    double gain() const override { return loop.k_p; }
    double wind_up_time() const override;

    int switches() const override { return bodies; }
    void switch_values(const FlowVector& y, double* values) const override { switch_values(y, {}, values); }
    void switch_values(const FlowVector& y, const DelayedForces& delayed, double* values) const;
    void enter(FlowVector& y) override { enter(y, {}); }
    void enter(FlowVector& y, const DelayedForces& delayed);
    void pass(int which, FlowVector& y) override { pass(which, y, {}); }
    void pass(int which, FlowVector& y, const DelayedForces& delayed);
    bool anything_rests() const override;
    std::unique_ptr<Flow> copy() const override { return std::make_unique<ChainFlow>(*this); }

    int link() const { return bodies - 1; }
    bool can_rest() const;
    double velocity(const FlowVector& y, int i) const;  ///< of body i, joint coordinates
    /// Friction on the link at y: of its law, or what holds it.
    double link_friction(const FlowVector& y, const DelayedForces& delayed = {}) const;
    bool link_stuck() const { return body[link()].mode == Mode::stuck; }

    /// All bodies moving steadily at a share of V_0, those that can rest at rest if it is 0, springs in balance.
    FlowVector slow_start(double share) const;

  private:
    friend struct ChainOrReason chain_flow(const Joint& joint, bool with_delayed_friction);
    void set_velocity(FlowVector& y, int i, double v) const;
    void settle(int i, FlowVector& y, const DelayedForces& delayed);
    States states_of(const FlowVector& y, int i) const;
    FrictionResponse response(const FlowVector& y, int i, const DelayedForces& delayed) const;
    /// What friction must carry, in joint coordinates, for body i to keep its velocity.
    double needed(const FlowVector& y, int i) const;
    /// The largest friction at rest, at the body's own side.
    double static_force(int i) const;
    /// What holds body i against the force needed, in joint coordinates. What a body resisted a lag ago it may still
    /// resist when it has come to rest.
    double limit(const FlowVector& y, int i, double needed, const DelayedForces& delayed) const;
    double stiffness(int i, int k) const
    {
        return loop.stiffness_at(i, k) + (k == loop.measured ? loop.actuated[i] * loop.k_p : 0);
    }
    double damping(int i, int k) const
    {
        return loop.damping_at(i, k) + (k == loop.measured ? loop.actuated[i] * loop.k_v : 0);
    }

    int total_states_ = 0;
};

struct ChainOrReason {
    ChainFlow flow;
    Reason reason = Reason::none;
};

/// The equations of motion of a joint of any number of bodies, or the reason why there are none. Delayed
/// friction is such a reason, unless the caller supplies it (DelayedFlow).
ChainOrReason chain_flow(const Joint& joint, bool with_delayed_friction = false);

}  // namespace stickslip
