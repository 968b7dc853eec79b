// A machine for the tests of the diagnosis, simulated in another way than the diagnosis does: explicit steps of 10 µs
// with Karnopp's stick band.
#pragma once
#include "analysis/diagnosis/records/record.h"
#include "analysis/joint/joint.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace stickslip::test {

struct Machine {
    double inertia = 1.2, coulomb = 2, viscous = 1.5, k_p = 1200, k_v = 45, tau = 0.003, load = 0, gain = 1;
    double noise = 2e-6, quantum = 5e-6, drag = 0;
    double cubic = 0;             ///< N/m³: a spring to the ground that stiffens
    double bellows = 0;           ///< N/m: a spring to the ground that follows the position behind a play
    double bellows_play = 0;      ///< m, half of it
    bool bellows_creeps = false;  ///< takes its play up little by little, as Dahl's friction does
    double command_step = 0;      ///< N: the command is rounded to whole steps
    double limit = 1e9;           ///< N, of the effort that reaches the mass
    double amplitude = 1;         ///< of the motion, as a factor
    double effort_noise = 0;      ///< N; above 0 the effort that reaches the mass is logged, too
    double step = 0;              ///< m: by this much the reference jumps at step_time
    double step_time = 2;         ///< s
    double command_limit = 1e9;   ///< N, of the controller
    double dead_zone = 0;         ///< m: by this much less of a position error counts
    double gravity = 0;           ///< N, times the sine of the position and of this angle
    double gravity_angle = 0;     ///< rad
    double picked_up = 0;         ///< kg, little by little from picked_up_at on for half a second
    double picked_up_at = 3;      ///< s
    double k_i = 0;               ///< N/(m·s)
    double integral_limit = 1e9;  ///< N, of the integral's share of the command
    double fed = 0;               ///< kg: so much of the acceleration of a planner at 50 Hz is added to the command
    double pushed = 0;  ///< N, added to the command along the velocity of the reference, all of it from there on
    double pushed_from = 0.01;    ///< m/s
    double ripple = 0;            ///< N, of the Coulomb level over the position
    double cogging = 0;           ///< N
    double swing = 0;             ///< N: a force that comes and goes with the time
    double swing_period = 1;      ///< s
    double peak = 0;              ///< N: friction falls from this much above its level as 1/(1 + (v/peak_velocity)²)
    double peak_velocity = 0.02;  ///< m/s
    double waves = 200;           ///< rad/m, of both
    double second = 0;            ///< second harmonic of the cogging, as a part of the first
    double one_way = 0;           ///< part of the viscous slope that changes its sign with the direction
    double lag = 0, second_lag = 0;  ///< s, of the actuator's two poles
    double late = 0;                 ///< s by which the command arrives late, of whole ticks
    double hung = 0;                 ///< kg of the inertia that hang on a spring behind the encoder
    double hung_stiffness = 1;       ///< N/m
    double hung_damping = 0;         ///< N·s/m
    double hung_stretch = 1e9;       ///< m, at which that spring is twice as stiff, with the square of the stretch
};

inline Joint nominal_joint()
{
    const Machine m;
    Joint j;
    j.mechanism.inertia = m.inertia;
    CoulombViscous law;
    law.coulomb = m.coulomb;
    law.viscous = m.viscous;
    j.friction.law = law;
    j.control.k_p = m.k_p;
    j.control.k_v = m.k_v;
    j.control.period = 1e-3;
    j.control.velocity_estimate.tau = m.tau;
    j.sensor.position_noise = m.noise;
    j.sensor.encoder_quantum = m.quantum;
    return j;
}

/// The same numbers of a joint that turns, where gravity is a sine of the position.
inline Joint nominal_arm()
{
    Joint j = nominal_joint();
    j.mechanism.motion = Motion::revolute;
    return j;
}

/// Where the machine is, and what hangs on it.
struct MachineState {
    double q = 0, v = 0;
    double hung_at = 0, hung_speed = 0, followed = 0;
    double lagged = 0, twice_lagged = 0;
};

/// A step of h under the command u, from time t on.
inline void step(const Machine& m, MachineState& s, double u, double t, double h)
{
    constexpr double band = 1e-6;
    auto& [q, v, hung_at, hung_speed, followed, lagged, twice_lagged] = s;
    lagged += h / (m.lag + h) * (u - lagged);
    twice_lagged += h / (m.second_lag + h) * (lagged - twice_lagged);
    if (m.lag > 0) u = twice_lagged;
    if (m.bellows_creeps)
        followed += h * std::abs(v) * (q - followed) / m.bellows_play;
    else
        followed = std::clamp(followed, q - m.bellows_play, q + m.bellows_play);
    const double stretch = hung_at - q, hardened = 1 + std::pow(stretch / m.hung_stretch, 2);
    const double spring = m.hung > 0 ? m.hung_stiffness * hardened * stretch + m.hung_damping * (hung_speed - v) : 0.0;
    hung_speed -= m.hung > 0 ? h / m.hung * spring : 0.0;
    hung_at += h * hung_speed;
    const double push = std::clamp(m.gain * u, -m.limit, m.limit) + spring + m.load -
                        m.gravity * std::sin(q + m.gravity_angle) - m.cubic * q * q * q - m.bellows * followed +
                        m.cogging * (std::sin(m.waves * q) + m.second * std::sin(2 * m.waves * q + 1)) +
                        m.swing * std::sin(2 * std::numbers::pi * t / m.swing_period);
    const double fast = v / m.peak_velocity;
    const double level = m.coulomb + m.ripple * std::cos(1.3 * m.waves * q) + m.peak / (1 + fast * fast);
    if (std::abs(v) < band && std::abs(push) <= level) {
        v = 0;
        return;
    }
    const double direction = std::abs(v) < band ? std::copysign(1.0, push) : std::copysign(1.0, v);
    const double carried = m.picked_up * std::clamp((t - m.picked_up_at) / 0.5, 0.0, 1.0);
    const double next =
        v + h / (m.inertia - m.hung + carried) *
                (push - direction * level - m.viscous * v - m.drag * v * std::abs(v) - m.one_way * std::abs(v));
    v = next * v < 0 ? 0 : next;
    q += h * v;
}

inline Record record_of(const Machine& m, unsigned seed, double seconds = 6)
{
    Record r;
    r.name = "run-" + std::to_string(seed);
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    constexpr double period = 1e-3, h = 1e-5;
    MachineState now;
    double estimate = 0, last = 0, share = 0;
    const double slow = 1.3 + 0.2 * seed, quick = 5.1 + seed;
    for (int k = 0; k < static_cast<int>(seconds / period); ++k) {
        const double t = k * period;
        const auto reference = [&](double s) {
            const double smooth = std::min(1.0, s) * (0.08 * std::sin(slow * s) + 0.02 * std::sin(quick * s));
            return m.amplitude * smooth + (t > m.step_time - 0.5 * period ? m.step : 0.0);
        };
        double y = now.q + m.noise * normal(random);
        y = m.quantum * std::round(y / m.quantum);
        if (k > 0) estimate += period / (m.tau + period) * ((y - last) / period - estimate);
        last = y;
        const double rate = (reference(t + 1e-5) - reference(std::max(0.0, t - 1e-5))) / (t > 0 ? 2e-5 : 1e-5);
        const double error = reference(t) - y;
        const double counted = std::copysign(std::max(0.0, std::abs(error) - m.dead_zone), error);
        share = std::clamp(share + m.k_i * period * counted, -m.integral_limit, m.integral_limit);
        double u = m.k_p * counted + m.k_v * (rate - estimate) + share;
        const double planned = 0.02 * std::floor(t / 0.02) + 0.01, apart = 1e-3;
        const double bend = reference(planned + apart) - 2 * reference(planned) + reference(planned - apart);
        u += m.fed * std::clamp(bend / (apart * apart), -2.0, 2.0);
        u += m.pushed * std::clamp(rate / m.pushed_from, -1.0, 1.0);
        if (m.command_step > 0) u = m.command_step * std::round(u / m.command_step);
        u = std::clamp(u, -m.command_limit, m.command_limit);
        r.time.push_back(t);
        r.reference_position.push_back(reference(t));
        r.reference_velocity.push_back(rate);
        r.position.push_back(y);
        r.velocity.push_back(estimate);
        r.effort_command.push_back(u);
        if (m.effort_noise > 0)
            r.effort_measured.push_back(std::clamp(m.gain * u, -m.limit, m.limit) + m.effort_noise * normal(random));
        const auto before = static_cast<std::size_t>(std::lround(m.late / period));
        const double arrives = before > r.rows() - 1 ? 0.0 : r.effort_command[r.rows() - 1 - before];
        for (int i = 0; i < 100; ++i) step(m, now, arrives, t + i * h, h);
    }
    return r;
}

}  // namespace stickslip::test
