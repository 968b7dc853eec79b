#include "tests/blind/generate/plant.h"

#include "tests/blind/generate/runge_kutta.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace blind {
namespace {

constexpr double relative_tolerance = 1e-6;
constexpr double event_resolution = 1e-9;  // s
constexpr double longest_step = 2e-3;      // s
constexpr double direct_cutoff = 1e-4;     // of V*: below it the direct effect of rate-and-state friction is flat

/// How stiff the elements of Maxwell slip are beside each other; all slip at the same force.
constexpr std::array<double, slip_elements> element_stiffness = {2.2, 1, 0.5, 0.3};

double left_of_rise(const DryFriction& f, double speed)
{
    const double s = speed / f.stribeck_velocity;
    switch (f.shape) {
        case DryFriction::Shape::tanh:
            return 1 - std::tanh(s);
        case DryFriction::Shape::rational:
            return 1 / (1 + s * s);
        default:
            return std::exp(-std::pow(s, f.stribeck_exponent));
    }
}

double wave(const Sine& s, double x)
{
    if (s.amplitude == 0) return 0;
    const double angle = s.rate * x + s.phase;
    return s.amplitude * (std::sin(angle) + s.second * std::sin(2 * angle + 1));
}

}  // namespace

double DriveSignal::at(double t) const
{
    return lag > 0 ? level + (lagged - level) * std::exp(-(t - begin) / lag) : level;
}

DriveState drive_effort(const Drive& d, double signal, double velocity)
{
    DriveState s;
    if (d.kind == Drive::Kind::effort) {
        const double full = d.gain * signal;
        // effort = full (1 − |effort| / sag_effort): the supply sags with the current that really flows.
        s.effort = std::clamp(full / (1 + std::abs(full) / d.sag_effort), -d.limit, d.limit);
        return s;
    }
    const double emf = d.back_emf * velocity;
    // R i = duty (V_0 − R_b |i|) − k_e ω, solved for i; duty ±1 is the rail.
    const auto switched = [&](double duty) {
        const double drop = duty * d.supply - emf;
        return drop / (d.resistance + duty * d.supply_resistance * (drop > 0 ? 1 : -1));
    };
    if (d.kind == Drive::Kind::dc_duty) {
        s.current = switched(std::clamp(signal, -1.0, 1.0));
    } else {
        s.current = (signal - emf) / d.resistance;
        if (std::abs(signal) > d.supply - d.supply_resistance * std::abs(s.current))
            s.current = switched(std::copysign(1.0, signal));
    }
    s.supply = d.supply - d.supply_resistance * std::abs(s.current);
    s.effort = std::clamp(d.gain * d.torque_constant * s.current, -d.limit, d.limit);
    return s;
}

Plant::Plant(const Machine& machine) : m_(machine.mechanism), drive_(machine.drive), outside_(machine.mechanism.outside)
{
    const double fine = machine.sensors.position_noise > 0 ? machine.sensors.position_noise : 1e-5;
    for (std::size_t i = 8; i < tolerance_.size(); ++i) tolerance_[i] = 1e-3 * fine;
    for (int b = 0; b < 2; ++b) {
        tolerance_[2 * b] = 1e-4 * fine;
        tolerance_[2 * b + 1] = 1e-2 * fine;
        tolerance_[4 + b] = bristles(b) ? 1e-5 * m_.friction[b].coulomb / m_.friction[b].bristle_stiffness : 1;
        tolerance_[6 + b] = m_.friction[b].evolution > 0 ? 1e-5 * m_.friction[b].evolution : 1;
    }
}

void Plant::rest_at(double position)
{
    t_ = 0;
    step_ = 1e-4;
    y_ = {position, 0, position, 0};
    bodies_[0] = bodies_[1] = {};
    history_.clear();
    outside_.start(position);
}

double Plant::speed_felt(int body, double t, double speed) const
{
    const double past = t - m_.friction[body].lag;
    if (m_.friction[body].lag == 0 || past >= t_) return speed;
    if (past <= 0 || history_.size() < 2) return 0;
    auto after = std::lower_bound(history_.begin(), history_.end(), past,
                                  [](const std::array<double, 3>& at, double time) { return at[0] < time; });
    if (after == history_.begin()) return (*after)[1 + body];
    if (after == history_.end()) return history_.back()[1 + body];
    const auto& a = *std::prev(after);
    const double x = (past - a[0]) / ((*after)[0] - a[0]);
    return std::lerp(a[1 + body], (*after)[1 + body], x);
}

double Plant::dry_level(int body, double direction, double speed, double t, const State& y, double transmitted) const
{
    const auto& f = m_.friction[body];
    double level = f.coulomb + direction * f.uneven_coulomb + wave(f.ripple, y[2 * body]);
    if (f.load_share != 0)
        level += f.load_share * std::abs(transmitted) * (transmitted * direction < 0 ? f.back_driving : 1);
    if (f.static_rise != 0) level += f.static_rise * left_of_rise(f, speed_felt(body, t, speed));
    if (f.drift != 0)
        level += f.drift * (f.to_document ? std::exp(-t / f.drift_time) : 1 - std::exp(-t / f.drift_time));
    if (f.evolution != 0) level += f.direct * std::log(speed / f.slip_velocity + direct_cutoff) + y[6 + body];
    return std::max(level, 0.0);
}

Plant::Forces Plant::forces(double t, const State& y) const
{
    const int link = m_.bodies - 1;
    const double q = y[2 * link], v = y[2 * link + 1];
    const double effort = drive_effort(drive_, signal_.at(t), y[1]).effort;
    const double load = m_.constant_load - m_.gravity * std::sin(q + m_.gravity_phase) + wave(m_.cogging, q) +
                        wave(m_.disturbance, t) + outside_.force(t, q, v);
    if (m_.bodies == 1) return {{effort + load, 0}, {effort, 0}};
    const double twist = y[0] - y[2], play = m_.backlash / 2;
    const double stretch = twist - std::clamp(twist, -play, play);
    const double far = stretch / m_.hardening_stretch;
    double spring = m_.stiffness * stretch * (1 + m_.hardening * far * far);
    if (stretch != 0 || play == 0) {
        spring += m_.damping * (y[1] - y[3]);
        // Faces that touch can push but not pull.
        if (play > 0) spring = stretch > 0 ? std::max(spring, 0.0) : std::min(spring, 0.0);
    }
    return {{effort - spring, spring + load}, {spring, spring}};
}

Plant::State Plant::rate(double t, const State& y) const
{
    State d{};
    const Forces f = forces(t, y);
    for (int b = 0; b < m_.bodies; ++b) {
        const auto& fr = m_.friction[b];
        const double v = y[2 * b + 1], inertia = m_.inertia[b] * (b == m_.bodies - 1 ? outside_.inertia_factor(t) : 1);
        if (fr.evolution != 0) {
            const double speed = std::abs(v);
            d[6 + b] = -speed / fr.slip_length *
                       (y[6 + b] + fr.evolution * std::log(speed / fr.slip_velocity + direct_cutoff));
        }
        if (!bristles(b) && bodies_[b].stuck) continue;
        const double direction = bristles(b) ? (v < 0 ? -1 : 1) : bodies_[b].direction;
        const double speed = std::max(direction * v, 0.0);
        const double level = dry_level(b, direction, speed, t, y, f.transmitted[b]);
        double friction = (fr.viscous + direction * fr.uneven_viscous) * v;
        if (fr.elements > 0) {
            friction += slip(level, v, y, d);
        } else if (bristles(b)) {
            d[4 + b] = v - (level > 0 ? fr.bristle_stiffness * std::abs(v) / level * y[4 + b] : 0);
            friction += fr.bristle_stiffness * y[4 + b] + fr.bristle_damping * d[4 + b];
        } else {
            friction += direction * level;
        }
        d[2 * b] = v;
        d[2 * b + 1] = (f.applied[b] - friction) / inertia;
    }
    return d;
}

/// Force of the elements of Maxwell slip (Iwan 1966): each a spring that slips where it reaches its part of the level.
double Plant::slip(double level, double v, const State& y, State& d) const
{
    double force = 0;
    for (std::size_t i = 0; i < slip_elements; ++i) {
        const double stiffness = element_stiffness[i] * m_.friction[0].bristle_stiffness / slip_elements;
        const double own = level / slip_elements, at = stiffness * y[8 + i];
        d[8 + i] = std::abs(at) >= own && at * v > 0 ? 0 : v;
        force += std::clamp(at, -own, own);
    }
    return force;
}

/// By how much the force on a body at rest exceeds what its friction can hold, with the sign of the motion it wants;
/// 0 where the body stays.
double Plant::excess(int b, double t, const State& y) const
{
    const Forces f = forces(t, y);
    const double direction = f.applied[b] < 0 ? -1 : 1;
    const double spare = std::abs(f.applied[b]) - dry_level(b, direction, 0, t, y, f.transmitted[b]);
    return spare > 0 ? direction * spare : 0;
}

bool Plant::crosses(int b, double t, const State& y) const
{
    if (bristles(b)) return false;
    return bodies_[b].stuck ? excess(b, t, y) != 0 : bodies_[b].direction * y[2 * b + 1] < 0;
}

/// Decides between stick and slip of a body whose velocity is zero.
void Plant::settle(int b)
{
    y_[2 * b + 1] = 0;
    const double out = excess(b, t_, y_);
    bodies_[b].stuck = out == 0;
    if (out != 0) bodies_[b].direction = out < 0 ? -1 : 1;
}

double Plant::error_norm(const State& y, const State& error) const
{
    double worst = 0;
    for (std::size_t i = 0; i < y.size(); ++i)
        worst = std::max(worst, std::abs(error[i]) / (tolerance_[i] + relative_tolerance * std::abs(y[i])));
    return worst;
}

void Plant::advance(double end, const DriveSignal& signal)
{
    signal_ = signal;
    const auto step_from = [this](double h) {
        return dormand_prince([this](double t, const State& y) { return rate(t, y); }, t_, y_, h);
    };
    // The drive has just jumped: bodies at rest may have to go.
    for (int b = 0; b < m_.bodies; ++b)
        if (!bristles(b) && y_[2 * b + 1] == 0) settle(b);
    for (long steps = 0; end - t_ > event_resolution; ++steps) {
        if (steps > 1000000) throw std::runtime_error("the integration of a case does not advance");
        const double h = std::min({step_, longest_step, end - t_});
        auto step = step_from(h);
        const double error = error_norm(step.end, step.error);
        if (error > 1 && h > event_resolution) {
            step_ = h * std::max(0.2, 0.9 * std::pow(error, -0.2));
            continue;
        }
        const auto any_crosses = [&](const Step<dimension>& s, double by) {
            for (int b = 0; b < m_.bodies; ++b)
                if (crosses(b, t_ + by, s.end)) return true;
            return false;
        };
        double taken = h;
        if (any_crosses(step, h)) {
            double before = 0;
            while (taken - before > event_resolution) {
                const double middle = 0.5 * (before + taken);
                const auto half = step_from(middle);
                if (any_crosses(half, middle)) {
                    taken = middle;
                    step = half;
                } else {
                    before = middle;
                }
            }
        }
        bool crossed[2] = {};
        for (int b = 0; b < m_.bodies; ++b) crossed[b] = crosses(b, t_ + taken, step.end);
        y_ = step.end;
        t_ += taken;
        outside_.arrive(y_[2 * (m_.bodies - 1)]);
        for (int b = 0; b < m_.bodies; ++b)
            if (crossed[b]) settle(b);
        if (taken == h)
            step_ = std::min(h * std::clamp(0.9 * std::pow(std::max(error, 1e-8), -0.2), 0.3, 5.0), longest_step);
        if (m_.friction[0].lag > 0 || m_.friction[1].lag > 0)
            history_.push_back({t_, std::abs(y_[1]), std::abs(y_[3])});
    }
    t_ = end;
    const double keep = std::max(m_.friction[0].lag, m_.friction[1].lag);
    while (history_.size() > 2 && history_[1][0] < t_ - keep) history_.pop_front();
}

double Plant::energy() const
{
    const int link = m_.bodies - 1;
    double e = 0;
    for (int b = 0; b < m_.bodies; ++b) e += 0.5 * m_.inertia[b] * y_[2 * b + 1] * y_[2 * b + 1];
    e -= m_.constant_load * y_[2 * link] + m_.gravity * std::cos(y_[2 * link] + m_.gravity_phase);
    if (m_.bodies == 2) {
        const double twist = y_[0] - y_[2], stretch = twist - std::clamp(twist, -m_.backlash / 2, m_.backlash / 2);
        e += 0.5 * m_.stiffness * stretch * stretch;
    }
    return e;
}

}  // namespace blind
