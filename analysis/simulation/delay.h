// Friction that answers late, f(t) = f_ss(V(t − τ)): the method of steps. The motion of the last τ is part of the
// state, so the solver keeps its own dense output and never steps beyond the lag; neither CVODE nor the flows here can
// do that.
#pragma once
#include <complex>
#include <deque>
#include <functional>
#include <optional>
#include <set>

#include "analysis/friction/law.h"
#include "analysis/joint/joint.h"
#include "analysis/results/point.h"
#include "analysis/simulation/disturbance.h"
#include "analysis/simulation/motion.h"

namespace stickslip {

/// m ẍ + k_v ẋ + k_p x + f_ss(V(t − τ)) = f_ss(V_0), V = V_0 + ẋ > 0, and sticking while the force needed to hold the
/// mass stays within the static friction.
struct DelayedJoint {
    double inertia = missing, k_v = 0, k_p = missing, V0 = missing, lag = missing, steady_friction = missing;
    CurveLaw curve;
    double normal_load = 1;  ///< factor on the friction
    double force = 0;        ///< d of (9); both constant between calls of DelayMotion::surround()

    /// The curve at a delayed speed; at and below V = 0 its limit from above, since velocities keep their sign here.
    double friction(double delayed) const;
    double static_force() const { return normal_load * stickslip::static_force(curve); }
    double holding_force(double x) const { return steady_friction + force + k_v * V0 - k_p * x; }
};

/// The joint if its law is a time lag on a single mass; steady sliding was checked before.
std::optional<DelayedJoint> delayed_joint(const Joint& joint);

/// Time of the slowest motion, √(m/k_p).
double natural_time(const DelayedJoint& joint);

/// The size of a disturbance that is meant where none is given, and the state right after one. There are no states of
/// the law to disturb.
struct PositionAndSpeed {
    double x, V;
};
double default_size(const DelayedJoint& joint, DisturbanceKind kind);
PositionAndSpeed disturbed(const DelayedJoint& joint, DisturbanceKind kind, double size);

/// Follows one delayed motion turn by turn. Explicit Runge-Kutta of order 5 (Dormand & Prince 1980) with its dense
/// output of order 4 (Hairer, Nørsett & Wanner, Solving ODEs I, II.6).
class DelayMotion {
  public:
    DelayMotion(const DelayedJoint& joint, double rtol) : joint_(joint), rtol_(rtol) {}

    /// From position and velocity, after steady sliding for ever.
    void start(double x, double V);
    /// From the instant that the motion has reached: the force d, and the normal load of the friction.
    void surround(double force, double normal_load);
    /// Until V falls through V_0 again; ends `settled` where the motion of a whole lag stays within `settled_size` ·
    /// V_0.
    Turn turn(double t_end, double settled_size);
    /// Of one motion; tens of thousands are usual. More means time scales so far apart that it never ends.
    static constexpr int most_steps = 1'000'000;

    double time() const { return t_; }
    double position() const { return x_; }
    double excess_speed() const { return V_ - joint_.V0; }
    /// What the last lag adds to the projection on a mode: ∫ e^{−s(ξ + τ − t)} (V(ξ) − V_0) dξ over t − τ … t.
    std::complex<double> memory(std::complex<double> s) const;
    /// Called at the start and at the end of every step, with the time, the excess position, V, friction, and whether
    /// the mass sticks.
    using Observer = std::function<void(double t, double x, double V, double friction, bool stuck)>;
    void observe(Observer observer) { observer_ = std::move(observer); }

  private:
    struct Segment {  ///< of V over one step
        double t, h, c[5];
        double operator()(double at) const;
    };
    struct Rate {
        double x, V;
    };
    double delayed_speed(double t) const;
    Rate rate(double t, double x, double V) const;
    bool step(double t_end);
    void land_on(double level);
    void stick(double t_end, Turn& turn);
    void remember(Segment segment);
    void tell() const;
    void note_kink(double t);

    DelayedJoint joint_;
    double rtol_;
    double t_ = 0, x_ = 0, V_ = 0, h_ = 0;
    double t_before_ = 0, x_before_ = 0, V_before_ = 0;
    double x_dense_[5] = {};
    bool stuck_ = false;
    int steps_left_ = 0;
    std::deque<Segment> history_;
    std::set<double> kinks_;  ///< instants to come at which the friction has one, as V had a lag before
    Observer observer_;
};

}  // namespace stickslip
