#include "analysis/simulation/delay.h"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>

#include "analysis/simulation/dormand_prince.h"
#include "analysis/stability/linear_joint.h"
#include "analysis/stability/steady.h"

namespace stickslip {

using namespace dormand_prince;

double DelayedJoint::friction(double delayed) const
{
    return normal_load * steady_force(curve, std::max(delayed, 1e-12 * V0));
}

std::optional<DelayedJoint> delayed_joint(const Joint& joint)
{
    const auto* law = std::get_if<TimeLag>(&joint.friction.law);
    const bool single = joint.mechanism.model == Model::single_mass;
    if (!law || !single || has_unsteady_terms(joint.friction, joint.load) || !is_set(commanded_velocity(joint)))
        return {};
    DelayedJoint d;
    d.inertia = joint.mechanism.inertia;
    const auto loop = linear_joint(joint, commanded_velocity(joint));
    d.k_v = loop.k_v * loop.actuated[0], d.k_p = loop.k_p * loop.actuated[0] + loop.contact[0];
    d.V0 = std::abs(commanded_velocity(joint));
    d.lag = law->lag;
    d.curve = law->curve.law;
    d.normal_load = joint.friction.normal_load;
    d.steady_friction = d.friction(d.V0);
    return d;
}

double DelayMotion::Segment::operator()(double at) const
{
    return dense(c, (at - t) / h);
}

double DelayMotion::delayed_speed(double t) const
{
    const double then = t - joint_.lag;
    if (history_.empty() || then < history_.front().t) return joint_.V0;
    auto after =
        std::upper_bound(history_.begin(), history_.end(), then, [](double v, const Segment& s) { return v < s.t; });
    return (*(after - 1))(then);
}

DelayMotion::Rate DelayMotion::rate(double t, double x, double V) const
{
    const double f = joint_.friction(delayed_speed(t));
    return {V - joint_.V0, (joint_.steady_friction + joint_.force - f - joint_.k_v * (V - joint_.V0) - joint_.k_p * x) /
                               joint_.inertia};
}

/// V, smooth on either side of t only, returns as friction a lag later and, one order smoother each, after further
/// lags.
void DelayMotion::note_kink(double t)
{
    constexpr int lags = 4;  // then the fifth derivative of x, the order of the method, has none left
    for (int i = 1; i <= lags; ++i) kinks_.insert(t + i * joint_.lag);
}

void DelayMotion::start(double x, double V)
{
    t_ = 0, x_ = x, V_ = V;
    stuck_ = false;
    steps_left_ = most_steps;
    history_.clear();
    kinks_.clear();
    note_kink(0);
    h_ = std::min(joint_.lag, 0.01 * std::sqrt(joint_.inertia / std::abs(joint_.k_p)));
}

void DelayMotion::surround(double force, double normal_load)
{
    joint_.force = force;
    joint_.normal_load = normal_load;
    tell();
}

std::complex<double> DelayMotion::memory(std::complex<double> s) const
{
    using Rule = boost::math::quadrature::gauss<double, 7>;  // segments have degree 4, and s changes little over one
    std::complex<double> sum = 0;
    for (std::size_t i = 0; i < history_.size(); ++i) {
        const double from = std::max(history_[i].t, t_ - joint_.lag);
        const double to = i + 1 < history_.size() ? history_[i + 1].t : t_;
        if (!(to > from)) continue;
        const auto part = [&](double at) {
            return std::exp(-s * (at + joint_.lag - t_)) * (history_[i](at) - joint_.V0);
        };
        sum += Rule::integrate([&](double at) { return part(at).real(); }, from, to) +
               std::complex<double>(0, Rule::integrate([&](double at) { return part(at).imag(); }, from, to));
    }
    return sum;
}

void DelayMotion::tell() const
{
    if (observer_)
        observer_(t_, x_, V_, stuck_ ? joint_.holding_force(x_) : joint_.friction(delayed_speed(t_)), stuck_);
}

void DelayMotion::remember(Segment segment)
{
    history_.push_back(segment);
    while (history_.size() > 2 && history_[1].t + history_[1].h < t_ - 2 * joint_.lag) history_.pop_front();
}

/// One accepted step, no longer than the lag, since V is known no further; false where no step is small enough or too
/// many have been taken.
bool DelayMotion::step(double t_end)
{
    const double passed = t_ + std::max(1e-12 * joint_.lag, 1e-14 * t_);  // what rounding leaves of a step is none
    const double x_scale = joint_.V0 * std::sqrt(joint_.inertia / std::abs(joint_.k_p));
    while (!kinks_.empty() && *kinks_.begin() <= passed) kinks_.erase(kinks_.begin());
    const double kink = kinks_.empty() ? infinity : *kinks_.begin();
    for (;;) {
        const double h = std::min({h_, joint_.lag, t_end - t_, kink - t_});
        if (--steps_left_ < 0 || !(h > 1e-15 * std::max(t_, 1e-3 * joint_.lag))) return false;
        double kx[stages], kV[stages], x = x_, V = V_;
        for (int i = 0; i < stages; ++i) {
            x = x_, V = V_;
            for (int j = 0; j < i; ++j) x += h * weight[i][j] * kx[j], V += h * weight[i][j] * kV[j];
            const auto r = rate(t_ + node[i] * h, x, V);
            kx[i] = r.x, kV[i] = r.V;
        }
        double ex = 0, eV = 0;
        for (int i = 0; i < stages; ++i) ex += h * error_weight[0][i] * kx[i], eV += h * error_weight[0][i] * kV[i];
        const double error = std::max(std::abs(ex) / (rtol_ * (x_scale + std::abs(x_))),
                                      std::abs(eV) / (rtol_ * (joint_.V0 + std::abs(V_))));
        const double factor = error < 1e30 ? std::clamp(0.9 * std::pow(std::max(error, 1e-10), -0.2), 0.2, 5.0) : 0.1;
        h_ = h * factor;
        if (!(error <= 1)) continue;
        Segment segment{t_, h, {}};
        fill_dense(V_, V, kV, h, segment.c);
        fill_dense(x_, x, kx, h, x_dense_);
        t_before_ = t_, x_before_ = x_, V_before_ = V_;
        t_ += h, x_ = x, V_ = V;
        remember(segment);
        return true;
    }
}

/// Ends the last step where V has the given level.
void DelayMotion::land_on(double level)
{
    Segment& last = history_.back();
    double low = 0, high = 1;  // V − level changes sign between
    const bool falls = V_before_ > level;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        ((dense(last.c, middle) > level) == falls ? low : high) = middle;
    }
    x_ = dense(x_dense_, high);
    V_ = level;
    t_ = last.t + high * last.h;
}

/// At rest: x falls at V_0 until the force needed reaches the static friction; V is remembered as zero.
void DelayMotion::stick(double t_end, Turn& turn)
{
    const double rise = joint_.k_p * joint_.V0;
    const double wait = rise > 0 ? std::max(0.0, (joint_.static_force() - joint_.holding_force(x_)) / rise) : infinity;
    const double until = std::min(t_ + wait, t_end);
    note_kink(t_);
    note_kink(until);
    if (until > t_) remember({t_, until - t_, {}});
    x_ -= joint_.V0 * (until - t_);
    turn.rest_time += until - t_;
    turn.position_min = std::min(turn.position_min, x_);
    turn.velocity_min = 0;
    ++turn.sticks;
    t_ = until;
    stuck_ = t_ >= t_end;
    h_ = std::min(joint_.lag, 1e-3 * std::sqrt(joint_.inertia / std::abs(joint_.k_p)));
}

Turn DelayMotion::turn(double t_end, double settled_size)
{
    Turn turn;
    turn.t0 = t_;
    turn.velocity_min = turn.velocity_max = V_;
    turn.position_min = turn.position_max = x_;
    double quiet_since = t_;
    tell();
    const auto finish = [&](Turn::End end) {
        turn.end = end;
        turn.t1 = t_;
        turn.state.resize(2);
        turn.state << x_, V_;
        return turn;
    };
    while (t_ < t_end) {
        if (stuck_ && joint_.holding_force(x_) < -joint_.static_force()) {  // the force or the load has changed
            turn.reversed = true;
            return finish(Turn::End::failure);
        }
        if (stuck_) {
            stick(t_end, turn);
            tell();
            if (stuck_) return finish(std::isfinite(t_end) ? Turn::End::time : Turn::End::held);
            continue;
        }
        if (!step(t_end)) return finish(t_ < t_end * (1 - 1e-12) ? Turn::End::failure : Turn::End::time);
        const bool falls = V_before_ > joint_.V0 && V_ <= joint_.V0;
        if (falls) {
            land_on(joint_.V0);  // even if the same step would come to rest
        } else if (V_ <= 0) {
            if (V_before_ > 0) land_on(0);
            V_ = 0;  // from breakaway the mass leaves V = 0 with no acceleration: roundoff may hold it there for a step
            if (std::abs(joint_.holding_force(x_)) > joint_.static_force()) {
                turn.reversed = true;  // beyond the validity of the law
                return finish(Turn::End::failure);
            }
            stuck_ = true;
        }
        tell();
        turn.velocity_min = std::min(turn.velocity_min, V_);
        turn.velocity_max = std::max(turn.velocity_max, V_);
        turn.position_min = std::min(turn.position_min, x_);
        turn.position_max = std::max(turn.position_max, x_);
        if (std::max(V_, V_before_) <= near_rest * joint_.V0) turn.rest_time += t_ - t_before_;
        if (falls) return finish(Turn::End::crossing);
        if (std::abs(V_ - joint_.V0) > settled_size * joint_.V0) quiet_since = t_;
        const double turn_time = 2 * std::numbers::pi * std::sqrt(joint_.inertia / std::abs(joint_.k_p));
        if (t_ - quiet_since > joint_.lag + turn_time) return finish(Turn::End::settled);
    }
    return finish(Turn::End::time);
}

}  // namespace stickslip
