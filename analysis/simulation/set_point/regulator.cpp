#include "analysis/simulation/set_point/regulator.h"

#include "analysis/joint/gains.h"

namespace stickslip {

Regulator regulator_of(const Joint& joint)
{
    const auto& c = joint.control;
    const auto& a = joint.actuator;
    const Gains gains = gains_of(c);
    double per_signal = a.effort_gain, most_signal = c.effort_limit;
    Regulator r;
    if (a.kind == ActuatorKind::dc_motor) {
        const double per_volt = a.effort_gain * a.k_t / a.resistance;
        const double volts_per_signal = a.signal == DriveSignal::duty ? a.supply_voltage : 1;
        per_signal = per_volt * volts_per_signal;
        r.drag = per_volt * a.k_e;
        if (is_set(a.supply_voltage)) most_signal = std::min(most_signal, a.supply_voltage / volts_per_signal);
    }
    // the controller counts errors and velocities in what the encoder says, the motion in what the joint does
    const double scale = joint.sensor.position_scale;
    r.inertia = joint.mechanism.inertia;
    r.per_signal = per_signal;
    r.k_p = per_signal * scale * gains.k_p;
    r.k_v = per_signal * scale * gains.k_v;
    r.k_i = per_signal * scale * gains.k_i;
    r.dead_zone = c.dead_zone / scale;
    r.integral_limit = std::abs(per_signal) * c.integral_limit;
    r.integral_band = c.integral_band / scale;
    r.effort_limit = std::min(std::abs(per_signal) * most_signal, a.limit);
    r.anti_windup = c.anti_windup;
    r.tracking_time = c.tracking_time;
    r.push = c.feed_forward;
    r.push.coulomb *= per_signal;
    r.push.coulomb_speed /= scale;
    r.push.coulomb_width /= scale;
    r.dither = std::abs(per_signal) * c.dither.amplitude;
    return r;
}

RegulatorFlow::RegulatorFlow(const Regulator& regulator, const Friction& friction, double position, double speed)
    : regulator_(regulator),
      friction_(friction),
      position_(position),
      speed_(speed),
      states_(stickslip::states(friction))
{
}

FlowVector RegulatorFlow::scale() const
{
    FlowVector s(size());
    s[0] = position_, s[1] = speed_;
    s[2] = regulator_.k_p * position_;
    const auto theta = steady_state(friction_, speed_);
    for (int i = 0; i < states_; ++i) s[3 + i] = std::max(std::abs(theta[i]), 1e-300);
    return s;
}

RegulatorFlow::Linearised RegulatorFlow::output(const FlowVector& y, double* command) const
{
    const auto& r = regulator_;
    const bool dead = std::abs(y[0]) <= r.dead_zone;
    const auto added = pushed(y);
    const double u = r.k_p * r.error(y[0]) - r.k_v * y[1] + y[2] + added.value;
    if (command) *command = u;
    if (along_limit || std::abs(u) > r.effort_limit) return {std::copysign(r.effort_limit, u), 0, 0, 0};
    return {u, (dead ? 0 : -r.k_p) + added.by_x, -r.k_v + added.by_v, 1};
}

RegulatorFlow::Linearised RegulatorFlow::pushed(const FlowVector& y) const
{
    const auto& push = regulator_.push;
    const double level = push.coulomb, width = push.coulomb_width;
    if (!push.fed_back()) return {};
    if (push.by_velocity()) {
        const auto share = push.direction(y[1]);
        return {level * share.value, 0, level * share.slope, 0};
    }
    const double e = regulator_.error(y[0]);
    const double where = push.jumps() ? side : push.side(e);
    const auto left = push.fade(y[1], branch == Branch::forward ? 1 : -1);
    return {level * where * left.value, std::abs(e) < width && e != 0 ? -level / width * left.value : 0,
            level * where * left.slope, 0};
}

/// ẇ. With `clamp` the integral waits while the output is at its limit, with `conditional` only while the error would
/// drive it further, with back-calculation it follows the output back.
RegulatorFlow::Linearised RegulatorFlow::winding(const FlowVector& y) const
{
    const auto& r = regulator_;
    const double e = r.error(y[0]);
    Linearised rate{r.k_i * e, e == 0 ? 0 : -r.k_i, 0, 0};
    if (std::abs(y[0]) > r.integral_band) rate = {};
    double command = 0;
    const auto given = output(y, &command);
    if (along_limit) return along(y, given.value);
    const double excess = command - given.value;
    const bool waits =
        r.anti_windup == AntiWindup::clamp || (r.anti_windup == AntiWindup::conditional && e * command > 0);
    if (excess != 0 && waits) rate = {};
    if (excess != 0 && r.anti_windup == AntiWindup::back_calculation) {
        rate.value -= excess / r.tracking_time;
        const auto added = pushed(y);
        rate.by_x += ((e == 0 ? 0 : r.k_p) - added.by_x) / r.tracking_time;
        rate.by_v += (r.k_v - added.by_v) / r.tracking_time;
        rate.by_w -= 1 / r.tracking_time;
    }
    if (std::abs(y[2]) >= r.integral_limit && rate.value * y[2] > 0) return {};
    return rate;
}

/// The ẇ that leaves k_p e − k_v v + w as it is, the effort being at its limit.
RegulatorFlow::Linearised RegulatorFlow::along(const FlowVector& y, double limit) const
{
    const auto& r = regulator_;
    const auto f = response(y);
    const double k_p = std::abs(y[0]) <= r.dead_zone ? 0 : r.k_p;
    const double acceleration = (limit + force_ - r.drag * y[1] - f.force) / r.inertia;
    return {k_p * y[1] + r.k_v * acceleration, 0, k_p - r.k_v * (r.drag + f.by_velocity) / r.inertia, 0};
}

double RegulatorFlow::share_along_limit(const FlowVector& y) const
{
    const auto& r = regulator_;
    double command = 0;
    output(y, &command);
    const double limit = std::copysign(r.effort_limit, command), e = r.error(y[0]);
    const bool waits = r.anti_windup == AntiWindup::clamp || r.anti_windup == AntiWindup::conditional;
    if (!waits || r.push.fed_back() || states_ > 0 || !(e * limit > 0) || std::abs(y[0]) > r.integral_band)
        return missing;
    return along(y, limit).value / (r.k_i * e);
}

FrictionResponse RegulatorFlow::response(const FlowVector& y) const
{
    States theta{};
    for (int i = 0; i < states_; ++i) theta[i] = y[3 + i];
    return can_rest(friction_) ? respond_on(friction_, branch, y[1], speed_, theta) : respond(friction_, y[1], theta);
}

void RegulatorFlow::rate(const FlowVector& y, FlowVector& out) const
{
    const auto f = response(y);
    out.resize(size());
    out[0] = y[1];
    out[1] = (output(y).value + force_ - regulator_.drag * y[1] - f.force) / regulator_.inertia;
    out[2] = winding(y).value;
    for (int i = 0; i < states_; ++i) out[3 + i] = f.rate[i];
}

void RegulatorFlow::jacobian(const FlowVector& y, FlowMatrix& J) const
{
    const auto f = response(y);
    const auto u = output(y), w = winding(y);
    const double m = regulator_.inertia;
    J.setZero(size(), size());
    J(0, 1) = 1;
    J(1, 0) = u.by_x / m;
    J(1, 1) = (u.by_v - regulator_.drag - f.by_velocity) / m;
    J(1, 2) = u.by_w / m;
    J(2, 0) = w.by_x, J(2, 1) = w.by_v, J(2, 2) = w.by_w;
    for (int i = 0; i < states_; ++i) {
        J(1, 3 + i) = -f.by_state[i] / m;
        J(3 + i, 1) = f.rate_by_velocity[i];
        J(3 + i, 3 + i) = f.rate_by_state[i];
    }
}

FlowVector RegulatorFlow::speed_gradient(const FlowVector&) const
{
    FlowVector g = FlowVector::Zero(size());
    g[1] = 1 / speed_;
    return g;
}

void RegulatorFlow::surround(double force, double normal_load)
{
    force_ = force;
    friction_.normal_load = normal_load;
}

std::unique_ptr<Flow> RegulatorFlow::with_gain(double k_p) const
{
    auto copy = std::make_unique<RegulatorFlow>(*this);
    copy->regulator_.k_p = k_p;
    return copy;
}

}  // namespace stickslip
