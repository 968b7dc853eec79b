// The loop of a record around a mechanism that CVODE integrates between events: the joint's description read anew, in
// continuous time, with bodies that stick. Nothing of the record simulator is used.
#pragma once
#include "analysis/joint/joint.h"

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <vector>

namespace stickslip::test {

class ContinuousMachine {
  public:
    explicit ContinuousMachine(const Joint& joint) : j_(joint), two_(joint.mechanism.model == Model::two_mass)
    {
        const double reading = 0, q = (reading - j_.sensor.position_offset) / j_.sensor.position_scale;
        state_.fill(0);
        for (int b = 0; b < bodies(); ++b) {
            state_[position(b)] = q;
            if (friction(b).memory.lag_viscous) state_[each * b + 4] = curve(b, 0);
        }
#if SUNDIALS_VERSION_MAJOR >= 7
        SUNContext_Create(SUN_COMM_NULL, &context_);
        SUNContext_ClearErrHandlers(context_);
#else
        SUNContext_Create(nullptr, &context_);
#endif
        y_ = N_VNew_Serial(size, context_);
        cvode_ = CVodeCreate(CV_BDF, context_);
#if SUNDIALS_VERSION_MAJOR < 7
        CVodeSetErrHandlerFn(
            cvode_, [](int, const char*, const char*, char*, void*) {}, nullptr);
#endif
        CVodeInit(cvode_, rate, 0, y_);
        CVodeSStolerances(cvode_, 1e-9, 1e-11);
        matrix_ = SUNDenseMatrix(size, size, context_);
        linear_ = SUNLinSol_Dense(y_, matrix_, context_);
        CVodeSetLinearSolver(cvode_, linear_, matrix_);
        CVodeSetMaxNumSteps(cvode_, 100000);
        CVodeSetUserData(cvode_, this);
        CVodeRootInit(cvode_, bodies(), events);
    }
    ~ContinuousMachine()
    {
        CVodeFree(&cvode_);
        SUNLinSolFree(linear_);
        SUNMatDestroy(matrix_);
        N_VDestroy(y_);
        SUNContext_Free(&context_);
    }
    ContinuousMachine(const ContinuousMachine&) = delete;

    /// What the encoder reads at every tick while the joint follows a reference and its rate (docs/theory.md, real
    /// loops).
    std::vector<double> follow(const std::function<double(double)>& reference,
                               const std::function<double(double)>& rate, int ticks)
    {
        const auto& c = j_.control;
        const double T = c.period;
        std::vector<double> readings, commands;
        double estimate = 0, last = 0;
        // a late reading is taken so many whole ticks and a part of one before the tick that gets it
        const int late = static_cast<int>(std::floor(j_.sensor.delay / T + 1e-9));
        const double late_part = std::max(0.0, j_.sensor.delay - late * T);
        const int seen = two_ && j_.control.feedback == Feedback::link ? 1 : 0;
        std::vector<double> taken(static_cast<std::size_t>(late) + 1, state_[position(seen)]);
        for (int k = 0; k < ticks; ++k) {
            if (late_part < 1e-9 * T) taken.push_back(state_[position(seen)]);
            const double q =
                late_part < 1e-9 * T ? taken[static_cast<std::size_t>(k) + 1] : taken[static_cast<std::size_t>(k)];
            double y = j_.sensor.position_scale * q + j_.sensor.position_offset;
            if (j_.sensor.encoder_quantum > 0)
                y = j_.sensor.encoder_quantum * std::round(y / j_.sensor.encoder_quantum);
            if (k > 0) estimate += T / (c.velocity_estimate.tau + T) * ((y - last) / T - estimate);
            last = y;
            readings.push_back(y);
            const double error = reference(k * T) - y;
            const double counted = error > c.dead_zone    ? error - c.dead_zone
                                   : error < -c.dead_zone ? error + c.dead_zone
                                                          : 0;
            const auto& fed = c.feed_forward;
            const double r = rate(k * T), bend = k > 0 ? (r - rate((k - 1) * T)) / T : 0;
            const double u = c.k_p * counted + c.k_v * (fed.velocity * r - estimate) + fed.acceleration * bend +
                             fed.coulomb * std::tanh(r / fed.coulomb_speed);
            commands.push_back(std::clamp(u, -c.effort_limit, c.effort_limit));
            // the command that arrives changes once a tick, part of a tick after it, with dead time
            const int whole = static_cast<int>(std::floor(c.delay / T + 1e-9));
            const double part = c.delay - whole * T;
            const auto at = [&](int n) { return n < 0 ? 0.0 : commands[static_cast<std::size_t>(n)]; };
            const double now = k * T;
            double from = now;
            const auto to = [&](double instant) {
                if (instant > from) integrate(from, instant), from = instant;
            };
            const auto arrive = [&] {
                if (part > 1e-9 * T) to(now + part);
                arrived_ = at(k - whole);
            };
            if (part > 1e-9 * T) arrived_ = at(k - whole - 1);
            const double taking = T - late_part;
            if (part <= taking) arrive();
            if (late_part >= 1e-9 * T) to(now + taking), taken.push_back(state_[position(seen)]);
            if (part > taking) arrive();
            to(now + T);
        }
        return readings;
    }

  private:
    // q, v, bristle, memory, lagged speed of either body, and the command behind the actuator's lag
    static constexpr int each = 5, size = 2 * each + 1, lagged = 2 * each;
    static int position(int b)
    {
        return each * b;
    }
    static int velocity(int b)
    {
        return each * b + 1;
    }
    int bodies() const
    {
        return two_ ? 2 : 1;
    }
    const Friction& friction(int b) const
    {
        return !two_ ? j_.friction : b == 0 ? j_.frictions.motor : j_.frictions.link;
    }
    double inertia(int b) const
    {
        const auto& m = j_.mechanism;
        return !two_ ? m.inertia : b == 0 ? m.motor_inertia : m.link_inertia;
    }

    double effort(const double* y) const
    {
        const auto& a = j_.actuator;
        const double u = a.lag > 0 ? y[lagged] : arrived_;
        double e = 0;
        if (a.kind == ActuatorKind::dc_motor) {
            const double duty = std::clamp(u, -1.0, 1.0), volts = duty * a.supply_voltage;
            // R i = duty (V_0 − R_b |i|) − k_e ω; the sign of i is that of what is left without the sag
            const double left = volts - a.k_e * y[velocity(0)];
            const double current = left / (a.resistance + std::copysign(duty, duty * left) * a.supply_resistance);
            e = a.effort_gain * a.k_t * current;
        } else {
            e = a.effort_gain * u;
            if (std::isfinite(a.sag_effort)) e /= 1 + std::abs(e) / a.sag_effort;
        }
        return std::clamp(e, -a.limit, a.limit);
    }

    double transmission(const double* y) const
    {
        const auto& t = j_.mechanism.transmission;
        double stretch = y[position(0)] / t.ratio - y[position(1)];
        const double rate = y[velocity(0)] / t.ratio - y[velocity(1)], half = t.backlash / 2;
        if (half > 0 && std::abs(stretch) <= half) return 0;
        stretch -= half > 0 ? std::copysign(half, stretch) : 0;
        const double force = t.stiffness * stretch + t.cubic_stiffness * std::pow(stretch, 3) + t.damping * rate;
        return half > 0 && force * stretch < 0 ? 0 : force;
    }

    double load(double q, double t) const
    {
        const Load& l = j_.load;
        return l.constant - l.gravity_amplitude * std::sin(q + l.gravity_phase) +
               l.cogging.amplitude * std::sin(l.cogging.periods * q + l.cogging.phase) +
               l.disturbance.amplitude * std::sin(l.disturbance.frequency * t + l.disturbance.phase);
    }

    /// What acts on a body apart from its friction, and what its transmission carries.
    std::pair<double, double> push(const double* y, int b, double t) const
    {
        if (!two_) return {effort(y) + load(y[0], t), effort(y)};
        const double spring = transmission(y);
        if (b == 0) return {effort(y) - spring / j_.mechanism.transmission.ratio, spring};
        return {spring + load(y[position(1)], t), spring};
    }

    static constexpr double least_ratio = 1e-3;  // of V*, in the logarithms of the memory

    /// Of a gear, in motion along `direction` while `effort` reaches the load.
    double gear(double direction, double effort) const
    {
        const auto& g = j_.friction.gear;
        return (direction * effort > 0 ? g.forward : g.backward) * std::abs(effort);
    }
    /// The effort that reaches the load while the joint accelerates so.
    double at_load(double q, double t, double acceleration) const
    {
        return -load(q, t) + j_.friction.gear.beyond * j_.mechanism.inertia * acceleration;
    }

    /// Size of the dry friction for motion in one direction.
    double dry(const double* y, int b, double direction, double speed, double t, double transmitted) const
    {
        const Friction& f = friction(b);
        double level = 0;
        const double late = f.memory.lag > 0 ? y[each * b + 4] : speed;
        if (const auto* law = std::get_if<CoulombViscous>(&f.law)) level = law->coulomb;
        if (const auto* law = std::get_if<Stribeck>(&f.law))
            level = law->c0 + law->c2 * std::exp(-std::pow(late / law->c3, law->c4));
        if (f.memory.lag_viscous) level = y[each * b + 4];
        level += direction * f.asymmetry.coulomb + f.load_coefficient * std::abs(transmitted) +
                 f.ripple.amplitude * std::sin(f.ripple.periods * y[position(b)] + f.ripple.phase) +
                 f.drift.change * (1 - std::exp(-t / f.drift.time_constant));
        if (f.memory.A != 0 || f.memory.B != 0)
            level += f.memory.A * std::log(speed / f.memory.V_star + least_ratio) + y[each * b + 3];
        return std::max(level, 0.0);
    }
    double at_rest(const double* y, int b, double direction, double t, double transmitted) const
    {
        const double level = dry(y, b, direction, 0, t, transmitted);
        return friction(b).gear.acts() ? level + gear(direction, at_load(y[position(b)], t, 0)) : level;
    }
    /// Of the law alone, in steady sliding.
    double curve(int b, double speed) const
    {
        const Friction& f = friction(b);
        if (const auto* law = std::get_if<CoulombViscous>(&f.law)) return law->coulomb + law->viscous * speed;
        const auto& law = std::get<Stribeck>(f.law);
        return law.c0 + law.c2 * std::exp(-std::pow(speed / law.c3, law.c4)) + law.c1 * speed;
    }
    double slope(int b, double direction) const
    {
        const Friction& f = friction(b);
        if (f.memory.lag_viscous) return direction * f.asymmetry.viscous;
        double viscous = 0;
        if (const auto* law = std::get_if<CoulombViscous>(&f.law)) viscous = law->viscous;
        if (const auto* law = std::get_if<Stribeck>(&f.law)) viscous = law->c1;
        return viscous + direction * f.asymmetry.viscous;
    }

    void rates(double t, const double* y, double* d) const
    {
        std::fill(d, d + size, 0.0);
        if (j_.actuator.lag > 0) d[lagged] = (arrived_ - y[lagged]) / j_.actuator.lag;
        for (int b = 0; b < bodies(); ++b) {
            const Friction& f = friction(b);
            const auto [force, transmitted] = push(y, b, t);
            const double v = y[velocity(b)];
            const bool bristles = f.bristle.stiffness > 0;
            const double direction = bristles ? std::copysign(1.0, v) : sliding_[b];
            const double speed = direction == 0 ? 0 : std::abs(v);
            const double level = dry(y, b, direction, speed, t, transmitted);
            double resisting = direction * level + slope(b, direction) * v;
            if (bristles) {
                const double z = y[each * b + 2], dz = v - f.bristle.stiffness * std::abs(v) * z / level;
                d[each * b + 2] = dz;
                resisting = f.bristle.stiffness * z + f.bristle.damping * dz + slope(b, direction) * v;
            }
            if (bristles || direction != 0) {
                d[position(b)] = v;
                d[velocity(b)] = (force - resisting) / inertia(b);
                // what the gear takes depends on the acceleration that it leaves: again and again, it converges
                for (int i = 0; i < 200 && f.gear.acts(); ++i) {
                    const double loss = gear(direction, at_load(y[position(b)], t, d[velocity(b)]));
                    d[velocity(b)] = (force - resisting - direction * loss) / inertia(b);
                }
            }
            const Memory& m = f.memory;
            if (m.A != 0 || m.B != 0) {
                const double theta = y[each * b + 3];
                const double age = m.L / m.V_star * std::exp(theta / m.B);
                d[each * b + 3] = m.form == MemoryForm::ageing
                                      ? m.B * (1 / age - speed / m.L)
                                      : -speed / m.L * (theta + m.B * std::log(speed / m.V_star + least_ratio));
            }
            if (m.lag > 0) d[each * b + 4] = ((m.lag_viscous ? curve(b, speed) : speed) - y[each * b + 4]) / m.lag;
        }
    }

    /// A sliding body: its velocity along its direction. One at rest: how far the force is from breaking it loose.
    double event(double t, const double* y, int b) const
    {
        if (friction(b).bristle.stiffness > 0) return 1;
        if (sliding_[b] != 0) return sliding_[b] * y[velocity(b)];
        const auto [force, transmitted] = push(y, b, t);
        return at_rest(y, b, std::copysign(1.0, force), t, transmitted) - std::abs(force);
    }

    /// Chooses who slides: a body at rest stays while its friction can hold it.
    void settle(double t)
    {
        for (int b = 0; b < bodies(); ++b) {
            if (friction(b).bristle.stiffness > 0) continue;
            double& v = state_[velocity(b)];
            constexpr double rest = 1e-9;  // m/s
            if (sliding_[b] != 0 && sliding_[b] * v > rest) continue;
            v = 0;
            sliding_[b] = 0;
            const auto [force, transmitted] = push(state_.data(), b, t);
            if (std::abs(force) <= at_rest(state_.data(), b, std::copysign(1.0, force), t, transmitted)) continue;
            sliding_[b] = std::copysign(1.0, force);
            v = sliding_[b] * 2 * rest;
        }
    }

    void integrate(double from, double to)
    {
        double t = from;
        for (int pieces = 0; t < to - 1e-12; ++pieces) {
            if (pieces > 200) throw std::runtime_error("a tick with more than 200 events");
            settle(t);
            std::copy(state_.begin(), state_.end(), NV_DATA_S(y_));
            CVodeReInit(cvode_, t, y_);
            CVodeSetStopTime(cvode_, to);
            const int flag = CVode(cvode_, to, y_, &t, CV_NORMAL);
            if (flag < 0) throw std::runtime_error("CVODE fails with " + std::to_string(flag));
            std::copy(NV_DATA_S(y_), NV_DATA_S(y_) + size, state_.begin());
            if (flag == CV_ROOT_RETURN)
                for (int b = 0; b < bodies(); ++b)
                    if (sliding_[b] == 0 && event(t, state_.data(), b) < 1e-9) {
                        const auto [force, transmitted] = push(state_.data(), b, t);
                        sliding_[b] = std::copysign(1.0, force);
                        state_[velocity(b)] = sliding_[b] * 2e-9;
                    }
        }
        settle(t);
    }

    static int rate(sunrealtype t, N_Vector y, N_Vector d, void* self)
    {
        static_cast<ContinuousMachine*>(self)->rates(t, NV_DATA_S(y), NV_DATA_S(d));
        return 0;
    }
    static int events(sunrealtype t, N_Vector y, sunrealtype* values, void* self)
    {
        const auto& machine = *static_cast<ContinuousMachine*>(self);
        for (int b = 0; b < machine.bodies(); ++b) values[b] = machine.event(t, NV_DATA_S(y), b);
        return 0;
    }

    Joint j_;
    bool two_;
    std::array<double, size> state_{};
    std::array<double, 2> sliding_{};  ///< direction, 0 at rest
    double arrived_ = 0;
    SUNContext context_ = nullptr;
    N_Vector y_ = nullptr;
    SUNMatrix matrix_ = nullptr;
    SUNLinearSolver linear_ = nullptr;
    void* cvode_ = nullptr;
};

}  // namespace stickslip::test
