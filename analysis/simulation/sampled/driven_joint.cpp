#include "analysis/simulation/sampled/driven_joint.h"

#include "analysis/numerics/root.h"

#include <cmath>

namespace stickslip {
namespace {

/// Share of its level by which a state may change by itself, as of bristles that carry a nearly flat curve.
constexpr double least_share = 0.01;

constexpr double slowest_clock = 1;  ///< rad/s, of the scale of positions where hardly a spring holds them

constexpr double aged_speed = 1e-3;  ///< of the motion's: the sliding that contacts at rest remember

/// Changes by which slopes are taken that no law states: of a level and of a drive signal, per itself.
constexpr double small_change = 1e-6;

/// The numbers of a law that place, time and load add to.
template <class Take>
bool with_levels(FrictionLaw& law, Take&& take)
{
    return std::visit(
        [&](auto& l) {
            if constexpr (requires { l.c0; })
                return take(l.c0), true;
            else if constexpr (requires { l.kinetic; })
                return take(l.kinetic), take(l.breakaway), true;
            else if constexpr (requires { l.breakaway; })
                return take(l.coulomb), take(l.breakaway), true;
            else if constexpr (requires { l.coulomb; })
                return take(l.coulomb), true;
            else if constexpr (requires { l.f0; })
                return take(l.f0), true;
            else
                return false;
        },
        law);
}

void raise(FrictionLaw& law, double by)
{
    with_levels(law, [by](double& level) { level = std::max(0.0, level + by); });
}

}  // namespace

std::string_view why_not_driven(const Joint& joint)
{
    if (joint.control.kind == ControlKind::force) return "a force loop is simulated without sampling and dead time only";
    if (joint.normal.moves()) return "a normal load that moves with the joint is not simulated in a real loop";
    if (joint.neighbour.size > 0) return "neighbours are not simulated in a real loop";
    const Chain chain = chain_of(joint);
    for (int i = 0; i < chain.bodies; ++i) {
        Friction f = *chain.body[i].friction;
        const auto& law = info(f.law);
        if (law.linear_only) return "the law is linear by definition";
        if (law.needs_history) return "friction that answers late is not simulated in a real loop";
        if (!has_response(f)) return "bristles under a level with a memory have no equations of motion";
        const bool bent = f.load_coefficient != 0 || f.ripple.amplitude != 0 || f.drift.change != 0;
        if (bent && !with_levels(f.law, [](double&) {}))
            return "this law has no level that place, time or load could change";
    }
    return {};
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
    bool timed = joint.load.gravity_amplitude != 0 || joint.load.cogging.amplitude != 0;
    timed = (timed && frame != 0) || joint.load.disturbance.amplitude != 0;
    bool rests = false;
    double inertia = 0;
    for (int i = 0; i < n; ++i) {
        auto& b = body_[i];
        b.friction = *chain_.body[i].friction;
        b.inertia = chain_.body[i].inertia;
        b.ratio = chain_.body[i].ratio;
        b.speed = std::abs(speed);
        b.logarithmic = info(b.friction.law).needs_motion;
        b.rests = stickslip::can_rest(b.friction);
        const auto& f = b.friction;
        b.bent = f.load_coefficient != 0 || f.ripple.amplitude != 0 || f.drift.change != 0;
        timed |= (f.ripple.amplitude != 0 && frame != 0) || f.drift.change != 0;
        b.states = stickslip::states(f);
        b.first_state = size_;
        size_ += b.states;
        rests |= b.rests;
        inertia += b.inertia;
    }
    bool play = false;
    for (int i = 0; i + 1 < n; ++i) play |= backlash_[i] > 0;
    switches_ = rests || play ? 2 * n - 1 : 0;
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
    if (half > 0 && stretch == 0) return 0;
    const double force = chain_.stiffness[i] * stretch + chain_.damping[i] * (velocity(y, i) - velocity(y, i + 1));
    if (half > 0 && force * stretch < 0) return 0;  // contact cannot pull
    *by_stretch = chain_.stiffness[i], *by_rate = chain_.damping[i];
    return force;
}

double DrivenJoint::load(const double* y, double* by_place, double* by_time) const
{
    const auto& l = joint_.load;
    const double t = now(y), x = y[link()], q = frame_ * t + x;
    const double contact = joint_.control.contact_stiffness;
    *by_place = -l.gravity_amplitude * std::cos(q + l.gravity_phase);
    if (l.cogging.amplitude != 0)
        *by_place += l.cogging.amplitude * l.cogging.periods * std::cos(l.cogging.periods * q + l.cogging.phase);
    *by_time = frame_ * *by_place;
    const auto& d = l.disturbance;
    if (d.amplitude != 0) *by_time += d.amplitude * d.frequency * std::cos(d.frequency * t + d.phase);
    *by_place -= contact;
    return load_force(l, q, t) - contact * x;
}

/// What place, time and load add to the level of body i, at its own side.
DrivenJoint::Extra DrivenJoint::extra(const double* y, int i) const
{
    const auto& b = body_[i];
    const auto& f = b.friction;
    Extra e{};
    const double t = now(y);
    if (f.ripple.amplitude != 0) {
        const double place = f.ripple.periods * b.ratio * (frame_ * t + y[i]) + f.ripple.phase;
        e.level += f.ripple.amplitude * std::sin(place);
        e.by_place += f.ripple.amplitude * f.ripple.periods * b.ratio * std::cos(place);
        e.by_time += frame_ * e.by_place;
    }
    if (f.drift.change != 0) {
        const double left = std::exp(-t / f.drift.time_constant);
        e.level += f.drift.change * (1 - left);
        e.by_time += f.drift.change * left / f.drift.time_constant;
    }
    if (f.load_coefficient != 0) {
        double a, c;
        const double through = bodies() == 1 ? drive(y).effort : spring(y, std::max(0, i - 1), &a, &c);
        e.level += f.load_coefficient * std::abs(through) / b.ratio / f.normal_load;
    }
    return e;
}

FrictionResponse DrivenJoint::respond_as(const BodyData& b, const Friction& friction, Mode mode, const double* y,
                                         int i) const
{
    States theta{};
    std::copy_n(y + b.first_state, b.states, theta.begin());
    if (b.logarithmic) return respond_logarithmic(friction, y[bodies() + i], b.ratio * b.speed, theta);
    const double V = b.ratio * y[bodies() + i];
    if (!b.rests) return respond(friction, V, theta);
    return respond_on(friction, mode == Mode::reverse ? Branch::reverse : Branch::forward, V, b.ratio * b.speed, theta);
}

DrivenJoint::Contact DrivenJoint::contact(const double* y, int i, bool derivatives) const
{
    const auto& b = body_[i];
    if (!b.bent) return {respond_as(b, b.friction, modes[i], y, i)};
    Friction raised = b.friction;
    raise(raised.law, extra(y, i).level);
    Contact c{respond_as(b, raised, modes[i], y, i)};
    if (!derivatives) return c;
    const double change = small_change * (std::abs(c.r.force) + std::abs(extra(y, i).level) + 1e-300);
    raise(raised.law, change);
    const auto more = respond_as(b, raised, modes[i], y, i);
    c.by_level = (more.force - c.r.force) / change;
    for (int j = 0; j < b.states; ++j) c.rate_by_level[j] = (more.rate[j] - c.r.rate[j]) / change;
    return c;
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

/// The most that body i resists at rest against motion on this branch, in joint coordinates.
double DrivenJoint::limit(const double* y, int i, Branch branch) const
{
    const auto& b = body_[i];
    DrivenState still;
    std::copy_n(y, size_, still.begin());
    const double edge = rest_speed * b.speed, V = branch == Branch::forward ? edge : -edge;
    still[bodies() + i] = V;
    Friction raised = b.friction;
    if (b.bent) raise(raised.law, extra(y, i).level);
    const Mode mode = branch == Branch::forward ? Mode::forward : Mode::reverse;
    const double sliding = std::abs(respond_as(b, raised, mode, still.data(), i).force);
    // what a law resists at rest beyond the end of its curve: of kinetic and static friction
    const double curve = raised.normal_load * std::abs(respond(raised.law, b.ratio * edge, {}).force);
    return b.ratio * (sliding + std::max(0.0, static_force(raised) - curve));
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
        out[i] = b.logarithmic && frame_ == b.speed ? b.speed * std::expm1(std::max(y[n + i], least_logarithm))
                                                    : v - frame_;
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

void DrivenJoint::switch_values(const double* y, double* values) const
{
    const int n = bodies();
    for (int i = 0; i < n; ++i) {
        if (!body_[i].rests)
            values[i] = 1;
        else if (modes[i] == Mode::stuck)
            values[i] = std::min(limit(y, i, Branch::forward) - needed(y, i), limit(y, i, Branch::reverse) + needed(y, i));
        else
            values[i] = (modes[i] == Mode::forward ? 1 : -1) * y[n + i];
    }
    for (int i = 0; i + 1 < n; ++i)
        values[n + i] = backlash_[i] > 0 ? std::abs(y[i] - y[i + 1]) - 0.5 * backlash_[i] : 1;
}

void DrivenJoint::settle(int i, double* y)
{
    y[bodies() + i] = 0;
    const double force = needed(y, i);
    modes[i] = force > limit(y, i, Branch::forward)    ? Mode::forward
               : force < -limit(y, i, Branch::reverse) ? Mode::reverse
                                                       : Mode::stuck;
}

void DrivenJoint::pass(int which, double* y)
{
    if (which >= bodies()) return;  // a play: the spring knows by itself
    if (modes[which] == Mode::stuck)
        modes[which] = needed(y, which) > 0 ? Mode::forward : Mode::reverse;
    else
        settle(which, y);
}

void DrivenJoint::enter(double* y)
{
    for (int i = 0; i < bodies(); ++i) {
        if (!body_[i].rests) continue;
        if (y[bodies() + i] == 0)
            settle(i, y);
        else
            modes[i] = y[bodies() + i] > 0 ? Mode::forward : Mode::reverse;
    }
}

double DrivenJoint::effort(const double* y) const
{
    return drive(y).effort / effort_ratio_;
}

double DrivenJoint::link_friction(const double* y) const
{
    if (modes[link()] == Mode::stuck) return needed(y, link());
    return contact(y, link(), false).r.force;
}

DrivenJoint::Steady DrivenJoint::steady(double velocity_asked) const
{
    Steady s{{}, missing};
    auto& y = s.y;
    const int n = bodies();
    double carried = 0, unused;  // by the springs, from the link down
    for (int i = n - 1; i >= 0; --i) {
        const auto& b = body_[i];
        if (i < n - 1) {
            const double stretch = carried / chain_.stiffness[i];
            y[i] = y[i + 1] + stretch + (stretch == 0 ? 0 : std::copysign(0.5 * backlash_[i], stretch));
        }
        set_velocity(y.data(), i, velocity_asked);
        const auto theta = steady_state(b.friction, b.ratio * velocity_asked);
        std::copy_n(theta.begin(), b.states, y.data() + b.first_state);
        carried += b.ratio * steady_force(b.friction, b.ratio * velocity_asked);
        if (i == n - 1) carried -= load(y.data(), &unused, &unused);
    }
    const double origin = y[measured_];
    for (int i = 0; i < n; ++i) y[i] -= origin;
    const auto& a = joint_.actuator;
    if (n == 1) carried /= 1 - joint_.friction.load_coefficient;
    const double effort = carried / effort_ratio_, v = effort_ratio_ * velocity_asked;
    const auto missed = [&](double command) { return push_of(a, command, a.supply_voltage, v).at(v) - effort; };
    const double sign = a.effort_gain < 0 ? -1 : 1;
    double reach = std::abs(effort / (a.effort_gain == 0 ? 1 : a.effort_gain)) + 1;
    for (int k = 0; k < 60 && !(sign * missed(reach) >= 0 && sign * missed(-reach) <= 0); ++k) reach *= 2;
    const double low = missed(-reach), high = missed(reach);
    if (sign * high >= 0 && sign * low <= 0 && std::isfinite(low) && std::isfinite(high))
        s.command = bracketed_root(missed, -reach, low, reach, high, 1e-16, 1e-300).value;
    if (has_lag()) y[lag_index_] = s.command;
    return s;
}

DrivenState DrivenJoint::at_rest(double x) const
{
    DrivenState y{};
    for (int i = 0; i < bodies(); ++i) {
        const auto& b = body_[i];
        y[i] = x;
        y[bodies() + i] = 0;
        // contacts that rest have aged as in very slow sliding; bristles stand upright
        const bool ages = b.friction.has_memory() ||
                          std::visit([](const auto& l) { return requires { l.f0; }; }, b.friction.law);
        if (!ages) continue;
        const auto theta = steady_state(b.friction, aged_speed * b.ratio * b.speed);
        std::copy_n(theta.begin(), b.states, y.data() + b.first_state);
    }
    return y;
}

}  // namespace stickslip
