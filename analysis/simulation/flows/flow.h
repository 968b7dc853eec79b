// The equations of motion in the variables of a solver: a smooth flow ẏ = F(y) with its Jacobian, and the section V =
// V_0.
#pragma once
#include "analysis/friction/steep_contact.h"
#include "analysis/joint/joint.h"
#include "analysis/results/point.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <memory>

namespace stickslip {

/// Three bodies, each with a law and its states.
inline constexpr int max_flow_size = 3 * (2 + max_states);
using FlowVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, max_flow_size, 1>;
using FlowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, max_flow_size, max_flow_size>;

/// ẏ = F(y) for one joint about steady sliding. The fixed point is steady sliding at V_0; time is in seconds.
class Flow {
  public:
    virtual ~Flow() = default;
    virtual int size() const = 0;
    virtual FlowVector steady() const = 0;
    /// What counts as a change of order one of each component; tolerances are relative to it.
    virtual FlowVector scale() const = 0;
    virtual void rate(const FlowVector& y, FlowVector& rate) const = 0;
    virtual void jacobian(const FlowVector& y, FlowMatrix& jacobian) const = 0;
    virtual double velocity(const FlowVector& y) const = 0;
    /// Position in excess of the steady path.
    virtual double position(const FlowVector& y) const = 0;
    /// ln(V/V_0), or V/V_0 − 1 for a law that may rest or reverse. Its zero is the Poincaré section; dV/dt is no use as
    /// one, since in quasi-static motion its zeros are roundoff.
    virtual double speed_measure(const FlowVector& y) const = 0;
    /// ∂ speed_measure / ∂y.
    virtual FlowVector speed_gradient(const FlowVector& y) const = 0;
    virtual double commanded_velocity() const = 0;
    /// Whether speed_measure is ln(V/V_0): the law cannot rest.
    virtual bool logarithmic_speed() const = 0;
    /// From now on: the force d on the link, and the normal load of its friction.
    virtual void surround(double force, double normal_load) = 0;
    /// The same joint at another position gain.
    virtual std::unique_ptr<Flow> with_gain(double k_p) const = 0;
    virtual double gain() const = 0;
    /// The longest time that bodies stick [s]: V_0 winds the springs up from what pushes them back to what drives them
    /// on. Such a phase has a closed form, however long it is.
    virtual double wind_up_time() const { return 0; }
    virtual std::unique_ptr<Flow> copy() const = 0;
};

/// ln(V/V_0) below which a law that needs motion takes V for this speed, its friction going on along its logarithm: the
/// mass then moves by less than rounding, and smaller speeds would only overflow what is divided by them.
inline constexpr double least_logarithm = -60;

/// The response of a law that needs motion at V_0 e^w, however small that is.
FrictionResponse respond_logarithmic(const Friction& friction, double w, double V0, const States& theta);

/// In which branch of a friction law that is set-valued at rest the mass slides.
enum class Branch { forward, reverse };

/// Whether V = 0 is a set of forces: memory with a direct effect, or bristles, make it a function.
bool can_rest(const Friction& friction);

/// Share of V_0 at which a branch of a set-valued law is evaluated at rest, and beyond where a solver's stage
/// oversteps.
inline constexpr double rest_speed = 1e-12;

/// Speed up to which a body held by a steep contact creeps for as long as it rests, from which on it slips. Until then
/// its inertia takes hardly a part of A: V̇ = V k V_0/A.
double creep_speed(const DirectContact& contact, double stiffness, double inertia, double V0);

/// Of creep_speed: where the friction of a steep contact that slides ends, to go on straight through V = 0.
inline constexpr double creep_edge = 0.1;

/// The response of one branch, continued smoothly through V = 0, where the event that ends the branch lies. V0 > 0 sets
/// the scale.
FrictionResponse respond_on(const Friction& friction, Branch branch, double V, double V0, const States& theta);

/// A flow whose bodies may each come to rest: which equations hold changes at switches, each the zero of a function.
class SwitchingFlow : public Flow {
  public:
    virtual int switches() const = 0;
    virtual void switch_values(const FlowVector& y, double* values) const = 0;
    /// Chooses the equations that hold at y.
    virtual void enter(FlowVector& y) = 0;
    /// Changes them at the zero of one function.
    virtual void pass(int which, FlowVector& y) = 0;
    virtual bool anything_rests() const = 0;
};

/// m ẍ + k_v ẋ + k_p x + f − f_ss(V_0) = d, V = V_0 + ẋ                                               (9)
/// y = (x, ln(V/V_0), θ_i) for laws that need motion, since V then spans twelve decades, and (x, V, θ_i) for the
/// others. Steady sliding at V_0 < 0 is mirrored: positions and velocities count along the commanded direction.
class SlidingFlow final : public Flow {
  public:
    double inertia = not_set, k_v = 0, k_p = not_set, V0 = not_set;
    Friction friction;
    double steady_friction = not_set;
    bool logarithmic = false;  ///< y[1] is ln(V/V_0)
    int states = 0;
    double creep = 0;  ///< creep_speed of a steep contact; 0: no such contact
    Branch branch = Branch::forward;
    double force = 0;  ///< d, constant between calls of surround()

    int size() const override { return 2 + states; }
    FlowVector steady() const override;
    FlowVector scale() const override;
    void rate(const FlowVector& y, FlowVector& rate) const override;
    void jacobian(const FlowVector& y, FlowMatrix& jacobian) const override;
    double velocity(const FlowVector& y) const override
    {
        return logarithmic ? V0 * std::exp(std::max(y[1], least_logarithm)) : y[1];
    }
    double position(const FlowVector& y) const override { return y[0]; }
    double speed_measure(const FlowVector& y) const override { return logarithmic ? y[1] : y[1] / V0 - 1; }
    FlowVector speed_gradient(const FlowVector& y) const override;
    double commanded_velocity() const override { return V0; }
    bool logarithmic_speed() const override { return logarithmic; }
    void surround(double d, double normal_load) override { force = d, friction.normal_load = normal_load; }
    std::unique_ptr<Flow> with_gain(double gain) const override;
    double gain() const override { return k_p; }
    double wind_up_time() const override;
    std::unique_ptr<Flow> copy() const override { return std::make_unique<SlidingFlow>(*this); }

    /// What the friction must carry for the mass to keep its speed V = 0: f_ss + d + k_v V_0 − k_p x.
    double holding_force(double x) const { return steady_friction + force + k_v * V0 - k_p * x; }
    /// The holding force in the direction of a branch at which rest ends. It exceeds the static friction, or what a
    /// steep contact resists at its creep speed, by `excess` of the forces that balance there: by default less than any
    /// tolerance and more than their rounding, which could else hold the mass again at once, and again.
    double release_force(const FlowVector& y, Branch direction, double excess = least_excess) const;
    static constexpr double least_excess = 1e-12;
    /// Largest friction at rest; 0 for a law that is a function at V = 0.
    double static_force() const;
    bool can_rest() const { return stickslip::can_rest(friction); }
    bool steep() const { return creep > 0; }
    /// Whether the mass may stick: at rest, or at what is rest to any tolerance.
    bool sticks() const { return steep() || can_rest(); }
    States states_of(const FlowVector& y) const;

  private:
    FrictionResponse response(const FlowVector& y) const;
};

/// The same joint with m → 0: y = (x, θ_i), V from the balance of forces k_v (V − V_0) + k_p x + f(V, θ) = f_ss(V_0).
class QuasiStaticFlow final : public Flow {
  public:
    explicit QuasiStaticFlow(const SlidingFlow& full) : full_(full) {}
    int size() const override { return 1 + full_.states; }
    FlowVector steady() const override;
    FlowVector scale() const override;
    void rate(const FlowVector& y, FlowVector& rate) const override;
    void jacobian(const FlowVector& y, FlowMatrix& jacobian) const override;
    double velocity(const FlowVector& y) const override;
    double position(const FlowVector& y) const override { return y[0]; }
    double speed_measure(const FlowVector& y) const override;
    FlowVector speed_gradient(const FlowVector& y) const override;
    double commanded_velocity() const override { return full_.V0; }
    bool logarithmic_speed() const override { return true; }
    void surround(double d, double normal_load) override { full_.surround(d, normal_load); }
    std::unique_ptr<Flow> with_gain(double gain) const override;
    double gain() const override { return full_.k_p; }
    std::unique_ptr<Flow> copy() const override { return std::make_unique<QuasiStaticFlow>(*this); }

  private:
    SlidingFlow full_;
};

/// The equations of motion of a joint, or the reason why there are none: no velocity, a law without meaning there, or a
/// term (several inertias, loads, position-locked friction, …) that a steady nonlinear outcome does not cover.
struct SlidingOrReason {
    SlidingFlow flow;
    Reason reason = Reason::none;
};
SlidingOrReason sliding_flow(const Joint& joint);

/// Terms that leave no steady sliding in the strict sense.
bool has_unsteady_terms(const Friction& friction, const Load& load);

}  // namespace stickslip
