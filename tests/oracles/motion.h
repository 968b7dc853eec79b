// Equations of motion of every joint model, for simulation and for checking the linear theory.
#pragma once
#include <vector>

#include "analysis/joint/joint.h"
#include "analysis/stability/linear_joint.h"

namespace stickslip {

/// ẏ = F(t, y) in joint coordinates:
///   y = (x_1 … x_n, v_1 … v_n, θ of body 1, θ of body 2, …), bodies in order motor, transmission, link.
/// Position control: the loop pulls the motor with k_p (V_0 t − x) + k_v (V_0 − v), x and v of the measured body, as
/// (8). Force control: the finger pulls the link with −k_p x − k_v v, its force is fed back to the motor with the force
/// gain, and the motor's force rises so that the link can slide at V_0, as (10). Covers what the maps cover: friction
/// as respond(Friction), contact and constant load; no backlash, gravity, cogging, limits or sampling. A law whose
/// memory is no state answers as if its velocity had been constant.
class JointMotion {
  public:
    /// Throws std::invalid_argument where the joint cannot slide steadily at its commanded velocity.
    explicit JointMotion(const Joint& joint);
    JointMotion(const JointMotion&) = delete;
    JointMotion& operator=(const JointMotion&) = delete;

    int size() const { return size_; }
    int bodies() const { return chain_.bodies; }
    double commanded_velocity() const { return V0_; }

    /// y of steady sliding at time t.
    std::vector<double> steady(double t) const;

    /// F(t, y); `disturbance` acts on the link: d(t) of (9).
    void rate(double t, const double* y, double* dydt, double disturbance = 0) const;

    /// Kinetic energy and that of the transmission's springs.
    double energy(const double* y) const;
    /// What friction and the transmission's dampers take out per time, Σ f_i v_i + Σ d (v_i − v_k)².
    double dissipation(const double* y) const;
    /// What loop, contact and load bring in per time, so that d energy/dt = input − dissipation.
    double input(double t, const double* y) const;

  private:
    double friction(int body, const double* y, double* state_rates) const;
    /// Force of loop, contact and load on each body.
    std::array<double, max_bodies> outer_forces(double t, const double* y) const;
    /// Force of spring and damper i on the body before it, against the body behind it.
    double spring_force(int i, const double* y) const;

    Joint joint_;
    Chain chain_;  // refers to joint_
    double V0_ = 0;
    int size_ = 0;
    std::array<int, max_bodies> first_state_{};
    std::array<double, max_bodies> offset_{};  // of the steady position at t = 0
    double feedforward_ = 0, feedforward_rate_ = 0;
};

}  // namespace stickslip
