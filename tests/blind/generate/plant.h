// The mechanism in continuous time. Friction at rest is set-valued and treated as what it is: every body is either
// stuck or slides in a known direction, and the instants at which that changes are located as events of an adaptive
// integration.
#pragma once
#include "tests/blind/generate/machine.h"
#include "tests/blind/generate/outside.h"

#include <array>
#include <deque>

namespace blind {

/// What drives the mechanism during one stretch of time: a constant signal behind a first-order lag.
struct DriveSignal {
    double begin = 0, level = 0, lagged = 0, lag = 0;
    double at(double t) const;  ///< level + (lagged − level) e^{−(t − begin)/lag}
};

struct DriveState {
    double effort = 0, current = 0, supply = 0;
};
/// Effort on the mechanism and motor current for a drive signal at a motor velocity.
DriveState drive_effort(const Drive& drive, double signal, double velocity);

class Plant {
  public:
    explicit Plant(const Machine& machine);

    /// Puts the mechanism at rest at `position`, at time 0.
    void rest_at(double position);
    /// Integrates to time `end` under `signal`. Throws std::runtime_error if the step size collapses.
    void advance(double end, const DriveSignal& signal);

    double time() const { return t_; }
    double position(int body) const { return y_[2 * body]; }
    double velocity(int body) const { return y_[2 * body + 1]; }
    bool stuck(int body) const { return bodies_[body].stuck; }
    /// Kinetic plus potential energy (spring, gravity, constant load), J.
    double energy() const;

  private:
    static constexpr int per_body = 2;
    static constexpr std::size_t dimension = 8 + slip_elements;
    /// q0 v0 q1 v1 | bristle 0, 1 | rate-and-state 0, 1 | elements of Maxwell slip on body 0
    using State = std::array<double, dimension>;
    struct Body {
        bool stuck = true;
        double direction = 1;
    };
    struct Forces {
        double applied[2];      ///< all but the body's own friction
        double transmitted[2];  ///< the effort that loads the body's friction
    };

    Forces forces(double t, const State& y) const;
    double dry_level(int body, double direction, double speed, double t, const State& y, double transmitted) const;
    double speed_felt(int body, double t, double speed) const;
    double slip(double level, double v, const State& y, State& d) const;
    State rate(double t, const State& y) const;
    double excess(int body, double t, const State& y) const;
    bool crosses(int body, double t, const State& y) const;
    void settle(int body);
    double error_norm(const State& y, const State& error) const;
    bool bristles(int body) const { return m_.friction[body].bristle_stiffness > 0; }

    const Mechanism& m_;
    const Drive& drive_;
    OutsideForce outside_;
    DriveSignal signal_;
    double t_ = 0, step_ = 1e-4;
    State y_{}, tolerance_{};
    Body bodies_[2];
    std::deque<std::array<double, 3>> history_;  ///< time and speeds, kept where a lag needs the past
};

}  // namespace blind
