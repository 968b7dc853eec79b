#include "analysis/simulation/sampled/plant/driven_joint.h"

#include "analysis/friction/level.h"
#include "analysis/friction/steep_contact.h"

#include <cmath>

namespace stickslip {
namespace {

/// Share of its level by which a state may change by itself, as of bristles that carry a nearly flat curve.
constexpr double least_share = 0.01;

constexpr double slowest_clock = 1;  ///< rad/s, of the scale of positions where hardly a spring holds them

/// The body of a steep contact comes to rest below a share of V_0, a larger one beside an encoder or noise, and breaks
/// away to ten times that speed: in between it would creep on, by so small a share of the way that the reference goes.
constexpr double creep_share = 1e-6, disturbed_creep_share = 1e-5, break_away = 10;

/// Change of a drive signal, per itself, by which the slope of the push is taken.
constexpr double small_change = 1e-6;

}  // namespace

Detail why_not_driven(const Joint& joint)
{
    if (joint.control.kind == ControlKind::force) return Detail::force_loop;
    if (joint.normal.moves()) return Detail::normal_load_in_loop;
    if (joint.neighbour.size > 0) return Detail::neighbours_in_loop;
    const Chain chain = chain_of(joint);
    for (int i = 0; i < chain.bodies; ++i) {
        Friction f = *chain.body[i].friction;
        const auto& law = info(f.law);
        if (law.linear_only) return Detail::linear_law;
        if (law.needs_history && states(f) > 0) return Detail::late_with_memory;
        if (!has_response(f)) return Detail::bristles_with_memory;
        const bool bent = f.level_moves();
        if (bent && !with_levels(f.law, [](double&) {})) return Detail::no_level;
    }
    return Detail::none;
}

DrivenJoint::DrivenJoint(const Joint& joint, double frame, double speed, LoopSide side)
    : chain_(chain_of(joint)), joint_(joint), frame_(frame)
{
    const auto& m = joint.mechanism;
    const int n = bodies();
    measured_ = joint.control.feedback == Feedback::link ? link() : 0;
    if (side == LoopSide::motor) effort_ratio_ = chain_.body[0].ratio, reading_ratio_ = chain_.body[measured_].ratio;
    if (m.model == Model::two_mass) backlash_[0] = m.transmission.backlash;
    if (n == 3) backlash_[0] = m.motor_transmission.backlash, backlash_[1] = m.transmission_link.backlash;

    size_ = 2 * n;
    bool timed = joint.load.gravity_amplitude != 0 || joint.load.cogging.acts();
    timed = (timed && frame != 0) || joint.load.disturbance.amplitude != 0;
    const bool disturbed = joint.sensor.encoder_quantum > 0 || joint.sensor.position_noise > 0;
    bool rests = false;
    double inertia = 0;
    for (int i = 0; i < n; ++i) {
        auto& b = body_[i];
        b.friction = *chain_.body[i].friction;
        b.inertia = chain_.body[i].inertia;
        b.ratio = chain_.body[i].ratio;
        b.speed = std::abs(speed);
        b.logarithmic = info(b.friction.law).needs_motion;
        const bool contact = is_steep_contact(b.friction);
        b.rests = contact || stickslip::can_rest(b.friction);
        b.edge = (!contact ? rest_speed : disturbed ? disturbed_creep_share : creep_share) * b.speed;
        b.release = (contact ? break_away : 1) * b.edge;
        const auto& f = b.friction;
        b.bent = f.level_moves();
        b.delayed = std::holds_alternative<TimeLag>(f.law);
        if (b.delayed) past_.set_lag(i, std::get<TimeLag>(f.law).lag);
        timed |= b.delayed;
        timed |= (f.ripple.acts() && frame != 0) || f.drift.change != 0;
        b.states = stickslip::states(f);
        b.first_state = size_;
        size_ += b.states;
        rests |= b.rests;
        inertia += b.inertia;
    }
    bool backlash = false;
    for (int i = 0; i + 1 < n; ++i) backlash |= backlash_[i] > 0;
    switches_ = rests || backlash ? 2 * n - 1 : 0;
    const double force_unit = std::abs(joint.control.k_p) * std::abs(speed);  // by 1/ω
    const double omega = std::max(std::sqrt(std::abs(joint.control.k_p) / inertia), slowest_clock);
    if (joint.actuator.lag > 0) lag_index_ = size_++;
    if (timed) clock_index_ = size_++;
    for (int i = 0; i < n; ++i) {
        const auto& b = body_[i];
        scale_[i] = b.speed / omega;
        scale_[n + i] = b.logarithmic ? 1 : b.speed;
        const double V = b.ratio * b.speed;
        const auto theta = steady_state(b.friction, V);
        const auto r = respond(b.friction, V, theta);
        for (int j = 0; j < b.states; ++j) {
            const double change = std::abs(r.rate_by_velocity[j] * V / r.rate_by_state[j]);
            const double level = std::max(least_share * std::abs(theta[j]), 1e-300);
            scale_[b.first_state + j] = std::isfinite(change) ? std::max(change, level) : level;
        }
    }
    if (has_lag()) scale_[lag_index_] = force_unit / omega;
    if (has_clock()) scale_[clock_index_] = 1;
}

void DrivenJoint::set_velocity(double* y, int i, double v) const
{
    y[bodies() + i] = body_[i].logarithmic ? std::log(v / body_[i].speed) : v;
}

bool DrivenJoint::anything_can_rest() const
{
    return std::any_of(body_.begin(), body_.begin() + bodies(), [](const BodyData& b) { return b.rests; });
}

DrivenJoint::Drive DrivenJoint::drive(const double* y) const
{
    const auto& a = joint_.actuator;
    const double v = effort_ratio_ * velocity(y, 0), command = has_lag() ? y[lag_index_] : arriving;
    const Push push = push_of(a, command, a.supply_voltage, v);
    Drive d{effort_ratio_ * push.at(v), -effort_ratio_ * effort_ratio_ * push.drag, 0};
    if (has_lag()) {
        const double change = small_change * (std::abs(command) + scale_[lag_index_]);
        const Push more = push_of(a, command + change, a.supply_voltage, v);
        d.by_lag = effort_ratio_ * (more.at(v) - push.at(v)) / change;
    }
    return d;
}

/// Of the spring between bodies i and i + 1, positive where body i leads.
double DrivenJoint::spring(const double* y, int i, double* by_stretch, double* by_rate) const
{
    const double half = 0.5 * backlash_[i], apart = y[i] - y[i + 1];
    const double stretch = apart - std::clamp(apart, -half, half);
    *by_stretch = *by_rate = 0;
    if (half > 0 && std::abs(apart) < half) return 0;
    const Spring s = chain_.spring(i);
    const double force = s.effort(stretch) + chain_.damping[i] * (velocity(y, i) - velocity(y, i + 1));
    if (half > 0 && force * apart < 0) return 0;  // contact cannot pull
    *by_stretch = s.slope(stretch), *by_rate = chain_.damping[i];
    return force;
}

double DrivenJoint::load(const double* y, double* by_place, double* by_time) const
{
    const auto& l = joint_.load;
    const double t = now(y), x = y[link()], q = frame_ * t + x;
    *by_place = -l.gravity_amplitude * std::cos(q + l.gravity_phase);
    if (l.cogging.acts()) *by_place += l.cogging.by_place(q);
    *by_time = frame_ * *by_place;
    const auto& d = l.disturbance;
    if (d.amplitude != 0) *by_time += d.amplitude * d.frequency * std::cos(d.frequency * t + d.phase);
    *by_place -= joint_.control.contact_stiffness;
    return load_force(l, q, t) - contact_force(y);
}

double DrivenJoint::contact_force(const double* y) const
{
    return joint_.control.contact_stiffness * (y[link()] - contact_origin);
}

/// What friction must carry, in joint coordinates, for body i to keep its velocity.
double DrivenJoint::needed(const double* y, int i) const
{
    double sum = 0, a, b;
    if (i == 0) sum += drive(y).effort;
    if (i > 0) sum += spring(y, i - 1, &a, &b);
    if (i < link()) sum -= spring(y, i, &a, &b);
    if (i == link()) sum += load(y, &a, &b);
    return sum;
}

void DrivenJoint::rate(const double* y, double* out) const
{
    const int n = bodies();
    for (int i = 0; i < n; ++i) {
        const auto& b = body_[i];
        const auto c = contact(y, i, false);
        for (int j = 0; j < b.states; ++j) out[b.first_state + j] = c.r.rate[j];
        if (modes[i] == Mode::stuck) {
            out[i] = -frame_, out[n + i] = 0;
            continue;
        }
        const double acceleration = (needed(y, i) - b.ratio * c.r.force) / b.inertia;
        const double v = velocity(y, i);
        out[i] =
            b.logarithmic && frame_ == b.speed ? b.speed * std::expm1(std::max(y[n + i], least_logarithm)) : v - frame_;
        out[n + i] = b.logarithmic ? acceleration / v : acceleration;
    }
    if (has_lag()) out[lag_index_] = (arriving - y[lag_index_]) / joint_.actuator.lag;
    if (has_clock()) out[clock_index_] = 1;
}

void DrivenJoint::jacobian(const double* y, double* J) const
{
    const int n = bodies(), size = size_;
    std::fill_n(J, size * size, 0.0);
    const auto slope = [&](int k) { return body_[k].logarithmic ? velocity(y, k) : 1.0; };  // dv_k / ds_k
    for (int i = 0; i < n; ++i) {
        const auto& b = body_[i];
        const auto c = contact(y, i, true);
        const auto e = b.bent ? extra(y, i) : Extra{};
        for (int j = 0; j < b.states; ++j) {
            double* row = J + (b.first_state + j) * size;
            row[n + i] = modes[i] == Mode::stuck ? 0 : c.r.rate_by_velocity[j] * b.ratio * slope(i);
            row[b.first_state + j] = c.r.rate_by_state[j];
            row[i] += c.rate_by_level[j] * e.by_place;
            if (has_clock()) row[clock_index_] += c.rate_by_level[j] * e.by_time;
        }
        if (modes[i] == Mode::stuck) continue;
        const double v = velocity(y, i), per = (b.logarithmic ? 1 / v : 1) / b.inertia;
        J[i * size + n + i] = slope(i);
        double* row = J + (n + i) * size;
        double by_stretch, by_rate, force = -b.ratio * c.r.force;
        row[n + i] -= b.ratio * b.ratio * c.r.by_velocity * slope(i) * per;
        row[i] -= b.ratio * c.by_level * e.by_place * per;
        if (has_clock()) row[clock_index_] -= b.ratio * c.by_level * e.by_time * per;
        if (b.delayed) row[clock_index_] -= b.ratio * delayed_change(y, i) * per;
        for (int j = 0; j < b.states; ++j) row[b.first_state + j] = -b.ratio * c.r.by_state[j] * per;
        if (i == 0) {
            const auto d = drive(y);
            force += d.effort;
            row[n] += d.by_velocity * slope(0) * per;
            if (has_lag()) row[lag_index_] += d.by_lag * per;
        }
        for (const int k : {i - 1, i}) {  // the springs before and behind
            if (k < 0 || k >= link()) continue;
            const double sign = k < i ? 1 : -1;
            force += sign * spring(y, k, &by_stretch, &by_rate);
            row[k] += sign * by_stretch * per, row[k + 1] -= sign * by_stretch * per;
            row[n + k] += sign * by_rate * slope(k) * per, row[n + k + 1] -= sign * by_rate * slope(k + 1) * per;
        }
        if (i == link()) {
            double by_place, by_time;
            force += load(y, &by_place, &by_time);
            row[i] += by_place * per;
            if (has_clock()) row[clock_index_] += by_time * per;
        }
        if (b.logarithmic && y[n + i] > least_logarithm) row[n + i] -= force * per;
    }
    if (has_lag()) J[lag_index_ * size + lag_index_] = -1 / joint_.actuator.lag;
}

double DrivenJoint::effort(const double* y) const
{
    return drive(y).effort / effort_ratio_;
}

}  // namespace stickslip
