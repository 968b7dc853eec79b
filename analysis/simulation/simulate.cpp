#include "analysis/simulation/simulate.h"

#include "analysis/simulation/delay.h"
#include "analysis/simulation/mode.h"
#include "analysis/simulation/motion.h"
#include "analysis/stability/steady.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stickslip {
namespace {

constexpr int default_turns = 50;
constexpr int most_turns = 400;       ///< of a default duration: pages of longer motions are hard to read
constexpr double lead = 14;           ///< e-folds from the small disturbance to a cycle: ln(1/small_disturbance)
constexpr double watched_turns = 30;  ///< of that cycle

/// Fifty turns, or what a slow growth takes to become a cycle.
double default_duration(const SlowMode& mode)
{
    const double turn = 2 * std::numbers::pi / std::abs(mode.s);
    if (!(mode.s.real() > 0)) return default_turns * turn;
    return std::clamp(lead / mode.s.real() + watched_turns * turn, default_turns * turn, most_turns * turn);
}

void keep(double t, double x, double V, double friction, bool stuck, Trajectory& path)
{
    path.time.push_back(t);
    path.position.push_back(x);
    path.velocity.push_back(V);
    path.friction.push_back(friction);
    path.stuck.push_back(stuck);
}

void keep(const SlidingFlow& flow, const Instant& now, Trajectory& path)
{
    States theta{};
    for (int i = 0; i < flow.states; ++i) {
        theta[i] = now.y[2 + i];
        path.states[i].push_back(theta[i]);
    }
    const double friction =
        now.stuck ? flow.holding_force(now.y[0]) : respond(flow.friction, now.velocity, theta).force;
    keep(now.t, now.y[0], now.velocity, friction, now.stuck, path);
}

void keep(const ChainFlow& flow, const Instant& now, Trajectory& path)
{
    const auto& link = flow.body[flow.link()];
    for (int i = 0; i < link.states; ++i) path.states[i].push_back(now.y[link.first_state + i]);
    const auto& moving = static_cast<const ChainFlow&>(now.flow);
    keep(now.t, flow.position(now.y), now.velocity, moving.link_friction(now.y), moving.link_stuck(), path);
}

int link_states(const SlidingFlow& flow)
{
    return flow.states;
}
int link_states(const ChainFlow& flow)
{
    return flow.body[flow.link()].states;
}
double link_steady_friction(const SlidingFlow& flow)
{
    return flow.steady_friction;
}
double link_steady_friction(const ChainFlow& flow)
{
    return flow.body[flow.link()].steady_friction;
}

template <class AnyFlow>
void follow(AnyFlow& flow, const SimulateOptions& options, Trajectory& path)
{
    path.commanded_velocity = flow.V0;
    path.steady_friction = link_steady_friction(flow);
    path.states.resize(static_cast<std::size_t>(link_states(flow)));
    const auto mode = slow_mode(flow);
    const auto kind = options.disturbance.kind;
    const double size = is_set(options.disturbance.size) ? options.disturbance.size : default_size(flow, mode, kind);
    const double duration = is_set(options.duration) ? options.duration : default_duration(mode);
    const FlowVector start = disturbed(flow, mode, kind, size);
    flow.force = options.force;
    SlidingMotion motion(flow, options.fallback_only ? Solver::rodas5p : Solver::cvode, options.rtol);
    motion.observe([&](const Instant& now) { keep(flow, now, path); });
    motion.start(start);
    if (!motion.advance(duration)) path.reason = Reason::solver_failed;
    path.used_fallback = motion.used_fallback();
}

void follow_delayed(DelayedJoint joint, const SimulateOptions& options, Trajectory& path)
{
    path.commanded_velocity = joint.V0;
    path.steady_friction = joint.steady_friction;
    const auto kind = options.disturbance.kind;
    const double size = is_set(options.disturbance.size) ? options.disturbance.size : default_size(joint, kind);
    const auto start = disturbed(joint, kind, size);
    const double duration =
        is_set(options.duration) ? options.duration : default_turns * 2 * std::numbers::pi * natural_time(joint);
    joint.force = options.force;
    DelayMotion motion(joint, options.rtol);
    motion.observe([&](double t, double x, double V, double f, bool stuck) { keep(t, x, V, f, stuck, path); });
    motion.start(start.x, start.V);
    while (motion.time() < duration) {
        const auto end = motion.turn(duration, 0).end;
        if (end == Turn::End::failure || end == Turn::End::held) {
            path.reason = Reason::solver_failed;
            return;
        }
    }
}

}  // namespace

Trajectory simulate(const Joint& joint, const SimulateOptions& options)
{
    Trajectory path;
    const auto attempt = [&](auto found) {
        path.reason = found.reason;
        if (found.reason == Reason::none) follow(found.flow, options, path);
    };
    if (joint.mechanism.model != Model::single_mass) {
        attempt(chain_flow(joint));
    } else if (const auto delayed = delayed_joint(joint)) {
        path.reason = steady_sliding(joint).reason;
        if (path.reason == Reason::none && options.disturbance.kind == DisturbanceKind::state)
            path.reason = Reason::unsupported;
        if (path.reason == Reason::none) follow_delayed(*delayed, options, path);
    } else {
        attempt(sliding_flow(joint));
    }
    return path;
}

}  // namespace stickslip
