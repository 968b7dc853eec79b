#include "analysis/simulation/simulate.h"

#include "analysis/simulation/mode.h"
#include "analysis/simulation/motion.h"

#include <numbers>

namespace stickslip {
namespace {

void keep(const SlidingFlow& flow, const Instant& now, Trajectory& path)
{
    States theta{};
    for (int i = 0; i < flow.states; ++i) {
        theta[i] = now.y[2 + i];
        path.states[i].push_back(theta[i]);
    }
    path.time.push_back(now.t);
    path.position.push_back(flow.position(now.y));
    path.velocity.push_back(now.velocity);
    path.friction.push_back(now.stuck ? flow.holding_force(now.y[0])
                                      : respond(flow.friction, now.velocity, theta).force);
    path.stuck.push_back(now.stuck);
}

}  // namespace

Trajectory simulate(const Joint& joint, const SimulateOptions& options)
{
    Trajectory path;
    auto [flow, reason] = sliding_flow(joint);
    path.reason = reason;
    if (reason != Reason::none) return path;
    path.commanded_velocity = flow.V0;
    path.steady_friction = flow.steady_friction;
    path.states.resize(flow.states);
    const auto mode = slow_mode(flow);
    const double size = is_set(options.disturbance.size) ? options.disturbance.size
                                                         : default_size(flow, mode, options.disturbance.kind);
    const double duration = is_set(options.duration) ? options.duration : 50 * 2 * std::numbers::pi / std::abs(mode.s);
    const FlowVector start = disturbed(flow, options.disturbance.kind, size);
    flow.force = options.force;
    SlidingMotion motion(flow, options.fallback_only ? Solver::rodas5p : Solver::cvode, options.rtol);
    motion.observe([&](const Instant& now) { keep(flow, now, path); });
    motion.start(start);
    if (!motion.advance(duration)) path.reason = Reason::solver_failed;
    path.used_fallback = motion.used_fallback();
    return path;
}

}  // namespace stickslip
