#include "analysis/simulation/solvers/trajectory_rows.h"

namespace stickslip {
namespace {

void add_row(double t, double x, double V, double friction, bool stuck, Trajectory& path)
{
    path.time.push_back(t);
    path.position.push_back(x);
    path.velocity.push_back(V);
    path.friction.push_back(friction);
    path.stuck.push_back(stuck);
}

}  // namespace

double time_of_row(double t, Trajectory& path)
{
    if (path.time.empty() || t > path.time.back()) return t;
    t = path.time.back();
    for (auto* values : {&path.time, &path.position, &path.velocity, &path.friction}) values->pop_back();
    for (auto& state : path.states) state.pop_back();
    path.stuck.pop_back();
    return t;
}

void keep_row(const SlidingFlow&, const Instant& now, Trajectory& path)
{
    const double t = time_of_row(now.t, path);
    const auto& flow = static_cast<const SlidingFlow&>(now.flow);
    States theta{};
    for (int i = 0; i < flow.states; ++i) {
        theta[i] = now.y[2 + i];
        path.states[i].push_back(theta[i]);
    }
    const double friction =
        now.stuck ? flow.holding_force(now.y[0]) : respond(flow.friction, now.velocity, theta).force;
    add_row(t, now.y[0], now.velocity, friction, now.stuck, path);
}

void keep_row(const ChainFlow& flow, const Instant& now, Trajectory& path)
{
    const double t = time_of_row(now.t, path);
    const auto& link = flow.body[flow.link()];
    for (int i = 0; i < link.states; ++i) path.states[i].push_back(now.y[link.first_state + i]);
    const auto& moving = static_cast<const ChainFlow&>(now.flow);
    add_row(t, flow.position(now.y), now.velocity, moving.link_friction(now.y), moving.link_stuck(), path);
}

void keep_row(const DelayedFlow& flow, const Instant& now, Trajectory& path)
{
    const double t = time_of_row(now.t, path);
    const auto& chain = flow.chain();
    const auto& link = chain.body[chain.link()];
    for (int i = 0; i < link.states; ++i) path.states[i].push_back(now.y[link.first_state + i]);
    const auto& moving = static_cast<const DelayedFlow&>(now.flow);
    add_row(t, flow.position(now.y), now.velocity, moving.link_friction(now.y), moving.link_stuck(), path);
}

}  // namespace stickslip
