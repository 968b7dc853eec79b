// In one file: one slip, with every way in which it may end.
#include "analysis/simulation/set_point/stops.h"

#include "analysis/base/work_limits.h"
#include "analysis/numerics/polynomial.h"
#include "analysis/simulation/solvers/stepper.h"

#include <Eigen/Eigenvalues>

#include <complex>
#include <optional>
#include <utility>

namespace stickslip {
namespace {

constexpr double rtol = 1e-10;
constexpr double far = 1e4;                  ///< times the start: no loop that settles goes there
constexpr double nothing = 1e-10;            ///< share of the start and of the speed that counts as none
constexpr double rounding_of_force = 1e-14;  ///< per static friction
constexpr int steps_between = 16;            ///< looks at whether a slip only creeps on
constexpr double long_time = 1e3;            ///< times the slowest time constant: whatever creeps has arrived by then

double slowest_time(const Regulator& r, double viscous)
{
    const double c = r.k_v + r.drag + viscous;
    double slowest = 0;
    if (r.k_i > 0)
        for (const auto& s : cubic_roots(c / r.inertia, r.k_p / r.inertia, r.k_i / r.inertia))
            slowest = std::max(slowest, 1 / std::abs(s));
    else
        for (const auto& s : quadratic_roots(c / r.inertia, r.k_p / r.inertia))
            slowest = std::max(slowest, 1 / std::abs(s));
    return slowest;
}

/// To what share a slip from so near is followed: static friction and the integral nearly cancel there, and below what
/// their rounding leaves of the spring's force no step of the solver is small enough.
double followed_to(const Regulator& r, double static_force, double a)
{
    constexpr double rounding = 2e-14, roughest = 1e-4;
    const double left = rounding * static_force / (std::abs(r.k_p) * a);
    return left > rtol ? std::min(left, roughest) : rtol;
}

/// The velocity over which the friction falls; infinite where it does not.
double falling_speed(const Friction& friction)
{
    const auto* curve = std::get_if<Stribeck>(&friction.law);
    return curve && curve->c2 > 0 ? curve->c3 : infinity;
}

enum SlipEvent { rests = 0, dead_zone_left, dead_zone_right, push_whole, at_limit, slip_events };
static_assert(slip_events <= max_events);

Events events_of(const RegulatorFlow& flow)
{
    const double zone = flow.regulator().dead_zone, limit = flow.regulator().effort_limit;
    Events events;
    events.count = slip_events;
    events.values = [&flow, zone, limit](const FlowVector& y, double* values) {
        const auto& r = flow.regulator();
        double asked = 0;
        flow.effort(y, &asked);
        const auto& push = r.push;
        const bool left = zone > 0 || push.jumps(), whole = push.by_error() && push.coulomb_width > 0;
        values[rests] = flow.speed_measure(y);
        values[dead_zone_left] = left ? y[0] + zone : 1;
        values[dead_zone_right] = zone > 0 ? y[0] - zone : 1;
        values[push_whole] = whole ? std::abs(y[0]) - zone - push.coulomb_width : 1;
        const double share = flow.along_limit ? flow.share_along_limit(y) : 0;
        values[at_limit] = limit == infinity ? 1 : flow.along_limit ? share * (1 - share) : std::abs(asked) - limit;
    };
    return events;
}

/// The side of the error at a place, 0 in the dead zone.
double side_at(const Regulator& r, double x)
{
    const double e = r.error(x);
    return e == 0 ? 0 : std::copysign(1.0, e);
}

/// The side towards which the mass moves on from an edge of the dead zone.
double side_beyond(const Regulator& r, const FlowVector& y)
{
    if (r.dead_zone == 0) return y[1] > 0 ? -1 : 1;
    return y[0] * y[1] < 0 ? 0 : y[0] > 0 ? -1 : 1;
}

/// Goes on from where the command reached its limit, or left it: along it, or on the side to which it moves. It is put
/// there by a hair: what rounding leaves of it on the other side would be reached again and again.
void pass_limit(RegulatorFlow& flow, FlowVector& y, int direction)
{
    constexpr double hair = 1e-10;  // of the limit
    const double share = flow.share_along_limit(y), limit = flow.regulator().effort_limit;
    double asked = 0;
    flow.effort(y, &asked);
    flow.along_limit = !flow.along_limit && share > 0 && share < 1;
    const bool beyond = is_set(share) ? share <= 0 : direction > 0;
    const double place = flow.along_limit ? 1 : beyond ? 1 + hair : 1 - hair;
    y[2] += std::copysign(place * limit, asked) - asked;
}

double acceleration(const RegulatorFlow& flow, const FlowVector& y)
{
    FlowVector rate(y.size());
    flow.rate(y, rate);
    return rate[1];
}

/// A slip that swings nearly back to rest crosses zero speed twice within one step, which no change of sign shows: the
/// state where the speed first vanished, or nothing. `before` is the time at which the step began.
std::optional<std::pair<FlowVector, double>> touched_rest(const RegulatorFlow& flow, const Stepper& solver,
                                                          double before, double direction)
{
    const double after = solver.time();
    const auto pull = [&](double t) { return direction * acceleration(flow, solver.at(t)); };
    if (!(pull(before) < 0 && pull(after) > 0)) return {};
    const auto between = [](const auto& f, double low, double high) {  // where f turns from negative to positive
        for (int i = 0; i < 60; ++i) (f(0.5 * (low + high)) < 0 ? low : high) = 0.5 * (low + high);
        return 0.5 * (low + high);
    };
    const double slowest = between(pull, before, after);
    if (!(direction * solver.at(slowest)[1] < 0)) return {};
    const double first = between([&](double t) { return -direction * solver.at(t)[1]; }, before, slowest);
    return std::pair(solver.at(first), first);
}

/// Whether the loop's limits stay out of reach of a motion that ends at rest in the set point under `end`, and of which
/// `parts` are left, a column a mode.
bool within_limits(const RegulatorFlow& flow, const FlowVector& y, const Eigen::Matrix3cd& parts, double end)
{
    const auto& r = flow.regulator();
    double asked = 0;
    flow.effort(y, &asked);
    const Eigen::RowVector3cd gains(-r.k_p, -r.k_v, 1);
    const double effort = std::abs(end) + (gains * parts).cwiseAbs().sum();
    const Eigen::Vector3d reach = parts.cwiseAbs().rowwise().sum();
    return std::max(std::abs(asked), effort) < r.effort_limit && std::abs(end) + reach[2] < r.integral_limit &&
           std::abs(y[2]) < r.integral_limit && reach[0] < r.integral_band;
}

/// Whether nothing but a slow real mode is left of a slip, along `direction`: its speed never vanishes again, and the
/// mass creeps into the set point. Near it rounding of the forces would cost ever more steps to see that.
bool creeps_home(const RegulatorFlow& flow, const FlowVector& y, double direction)
{
    constexpr double over = 3;    // of the slow mode's speed to that of the others
    constexpr double bent = 0.3;  // of the damping, what the friction's curve may add or take
    const auto& r = flow.regulator();
    if (!(r.k_i > 0) || r.dead_zone > 0 || r.push.fed_back() || flow.along_limit || y.size() != 3) return false;
    FlowVector rate;
    FlowMatrix J;
    flow.rate(y, rate);
    flow.jacobian(y, J);
    const Eigen::EigenSolver<Eigen::MatrixXd> modes{Eigen::MatrixXd(J)};
    const auto& s = modes.eigenvalues();
    Eigen::Index slow = 0;
    for (Eigen::Index i = 1; i < 3; ++i)
        if (s[i].real() > s[slow].real()) slow = i;
    if (s[slow].imag() != 0 || !(s[slow].real() < 0)) return false;
    // ẏ = Σ s_i c_i v_i, so that mode i has the part c_i v_i in y
    const Eigen::Vector3cd share = modes.eigenvectors().partialPivLu().solve(rate.cast<std::complex<double>>());
    const Eigen::Matrix3cd parts = modes.eigenvectors() * share.cwiseQuotient(s).asDiagonal();
    const double creep = direction * parts(1, slow).real();
    const double others = parts.row(1).cwiseAbs().sum() - std::abs(parts(1, slow));
    const double held = static_force(flow.friction());
    if (!(creep > over * others) || !within_limits(flow, y, parts, direction * held)) return false;
    const double most = creep + others, damping = -J(1, 1) * r.inertia;
    const auto resisted = [&](double V) { return direction * respond(flow.friction(), direction * V, {}).force; };
    const double slope = damping - r.k_v - r.drag;
    const double curve = std::abs(resisted(most) - held - slope * most);
    return curve < bent * damping * most + rounding_of_force * held;
}

}  // namespace

StopToStop::StopToStop(const Regulator& regulator, const Friction& friction)
    : regulator_(regulator), friction_(friction), static_(stickslip::static_force(friction))
{
    const double fast = 1e6 * std::min(falling_speed(friction), 1.0);
    slowest_ = slowest_time(regulator, respond(friction, fast, {}).by_velocity);
    const auto& push = regulator.push;
    speed_limit_ = std::min(falling_speed(friction), push.fed_back() ? push.coulomb_speed : infinity);
}

double StopToStop::breakaway_integral(double x) const
{
    return std::copysign(static_, regulator_.error(x)) - regulator_.push_at_rest(x);
}

double StopToStop::stick_time(double x, double w) const
{
    const double e = regulator_.error(x), wanted = breakaway_integral(x);
    const bool winds = e != 0 && std::abs(x) <= regulator_.integral_band;
    if (!winds || std::abs(wanted) > regulator_.integral_limit || static_ > regulator_.effort_limit) return infinity;
    return std::max(0.0, (wanted - w) / (regulator_.k_i * e));
}

double StopToStop::least_start() const
{
    if (static_ > regulator_.effort_limit) return infinity;
    // further out the proportional part helps; far out w changes sign, and the limit binds again
    return regulator_.dead_zone + regulator_.error_holding(static_ - regulator_.integral_limit);
}

Stop StopToStop::slip_from(double a) const
{
    Stop stop;
    const double w = breakaway_integral(-a);
    if (regulator_.error(-a) == 0 || std::abs(w) > regulator_.integral_limit || static_ > regulator_.effort_limit ||
        a > regulator_.integral_band) {
        stop.end = Stop::End::held;
        return stop;
    }
    return follow(a, w, false);
}

Stop StopToStop::release_from(double a) const
{
    Stop stop;
    if (regulator_.push_at_rest(-a) <= static_ || static_ > regulator_.effort_limit) {
        stop.end = Stop::End::held;
        return stop;
    }
    return follow(a, 0, true);
}

Stop StopToStop::follow(double a, double w, bool to_first_rest) const
{
    Stop stop;
    const double speed = std::min(a / slowest_, 1e-3 * speed_limit_);
    RegulatorFlow flow(regulator_, friction_, a, speed);
    const Events events = events_of(flow);
    const double tolerance = followed_to(regulator_, static_, a), none = std::max(nothing, tolerance);
    const auto solver = rodas5p_stepper(tolerance);
    FlowVector y(3);
    y << -a, 0, w;
    solver->start(flow, 0, y, events);
    for (int i = 0; i < work::steps_to_stop; ++i) {
        const double before = solver->time();
        auto report = solver->step(long_time * slowest_);
        y = solver->state();
        if (report.end == StepEnd::failure || !y.allFinite()) return stop;
        double now = solver->time();
        if (report.end == StepEnd::step && i > 0)
            if (const auto touched = touched_rest(flow, *solver, before, flow.branch == Branch::forward ? 1 : -1)) {
                now = touched->second;
                y = touched->first;
                report = {StepEnd::event, rests, -1};
            }
        if (std::abs(y[0]) > far * a) return stop.end = Stop::End::runaway, stop;
        stop.x = y[0], stop.slip_time = now;
        const bool still = std::abs(y[0]) < none * a && std::abs(y[1]) < none * speed;
        const bool creeps = i % steps_between == steps_between - 1 && report.end == StepEnd::step && !to_first_rest &&
                            creeps_home(flow, y, flow.branch == Branch::forward ? 1 : -1);
        if (still || creeps || report.end == StepEnd::time) return stop.end = Stop::End::settled, stop;
        if (report.end != StepEnd::event) continue;
        if (report.event == at_limit) {
            pass_limit(flow, y, report.direction);
            solver->start(flow, now, y, events);
            continue;
        }
        if (report.event != rests) {
            if (!regulator_.push.jumps() || report.event > dead_zone_right) continue;
            flow.side = side_beyond(regulator_, y);
            y[0] = report.event == dead_zone_left ? -regulator_.dead_zone : regulator_.dead_zone;
            solver->start(flow, now, y, events);
            continue;
        }
        y[1] = 0;
        flow.side = side_at(regulator_, y[0]);
        const double push = flow.effort(y);
        if (std::abs(push) <= static_ || to_first_rest) {
            stop.end = Stop::End::stop;
            stop.stick_time = to_first_rest ? 0 : stick_time(y[0], y[2]);
            return stop;
        }
        if (++stop.turns > work::slips_to_stop) return stop.end = Stop::End::runaway, stop;
        flow.branch = push > 0 ? Branch::forward : Branch::reverse;
        if (flow.along_limit) {
            flow.along_limit = false;
            pass_limit(flow, y, -1);
        }
        solver->start(flow, now, y, events);
    }
    return stop;
}

}  // namespace stickslip
