#include "analysis/simulation/simulate.h"

#include "analysis/base/require_valid.h"
#include "analysis/simulation/flows/mode.h"
#include "analysis/simulation/mirrored.h"
#include "analysis/simulation/sampled/loop_trajectory.h"
#include "analysis/simulation/sampled/loop_verdict.h"
#include "analysis/simulation/solvers/trajectory_rows.h"
#include "analysis/stability/steady.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stickslip {
namespace {

constexpr int most_steps = 300'000;  ///< each is a row of the trajectory
constexpr int default_turns = 50;
constexpr int most_turns = 400;       ///< of a default duration: pages of longer motions are hard to read
constexpr double lead = 14;           ///< e-folds from the small disturbance to a cycle: ln(1/small_disturbance)
constexpr double watched_turns = 30;  ///< of that cycle
constexpr double shown_cycles = 9;    ///< three of them in the last third, which is shown as what the motion settled to

/// Fifty turns, or what a slow growth takes to become a cycle; a relaxation cycle lasts many turns of the mode that it
/// came from.
double default_duration(const SlowMode& mode, double cycle_period)
{
    const double turn = 2 * std::numbers::pi / std::abs(mode.s);
    double duration = default_turns * turn;
    if (mode.s.real() > 0)
        duration = std::clamp(lead / mode.s.real() + watched_turns * turn, duration, most_turns * turn);
    return is_set(cycle_period) ? std::max(duration, shown_cycles * cycle_period) : duration;
}

constexpr std::size_t most_cvode_pieces = 10;

/// What acts on the joint during one piece of time.
struct Piece {
    double end, force, normal_load;
};

/// Pieces of constant force and load up to `duration`, longest possible.
std::vector<Piece> pieces(const SimulateOptions& options, double normal_load, double duration)
{
    const auto& d = options.force;
    const auto& load = options.normal_load;
    std::vector<Piece> all;
    std::size_t i = 0, k = 0;  // samples of force and load
    for (double t = 0; t < duration;) {
        const double force_end = i < d.value.size() ? d.step * static_cast<double>(i + 1) : duration;
        const double load_end = k + 1 < load.value.size() ? load.step * static_cast<double>(k + 1) : duration;
        const double end = std::min({force_end, load_end, duration});
        const double force = i < d.value.size() ? d.value[i] : 0;
        const double sigma = load.value.empty() ? normal_load : load.value[k];
        const bool same = !all.empty() && all.back().force == force && all.back().normal_load == sigma;
        if (same)
            all.back().end = end;
        else
            all.push_back({end, force, sigma});
        if (force_end <= end && i < d.value.size()) ++i;
        if (load_end <= end && k + 1 < load.value.size()) ++k;
        t = end;
    }
    return all;
}

/// A size of zero where a force is all that disturbs.
double size_of(const SimulateOptions& options, double by_default)
{
    if (is_set(options.disturbance.size)) return options.disturbance.size;
    const bool forced = !options.force.value.empty() || !options.normal_load.value.empty();
    const bool start = options.disturbance.kind == DisturbanceKind::start;
    return forced && !start ? 0 : by_default;
}

int link_states(const SlidingFlow& flow)
{
    return flow.states;
}
int link_states(const ChainFlow& flow)
{
    return flow.body[flow.link()].states;
}
int link_states(const DelayedFlow& flow)
{
    return link_states(flow.chain());
}
double link_steady_friction(const SlidingFlow& flow)
{
    return flow.steady_friction;
}
double link_steady_friction(const ChainFlow& flow)
{
    return flow.body[flow.link()].steady_friction;
}
double link_steady_friction(const DelayedFlow& flow)
{
    return link_steady_friction(flow.chain());
}

const Friction& link_friction_of(const SlidingFlow& flow)
{
    return flow.friction;
}
const Friction& link_friction_of(const ChainFlow& flow)
{
    return flow.body[flow.link()].friction;
}
const Friction& link_friction_of(const DelayedFlow& flow)
{
    return link_friction_of(flow.chain());
}

/// A solver's errors are of the flow's scale and not of the disturbance's: a small one would soon drown in them, and
/// multistep methods let errors of a decaying mode grow. Never below what the rounding of forces leaves.
template <class AnyFlow>
double follows_to(const FlowVector& start, const AnyFlow& flow, double rtol)
{
    constexpr double least_tolerance = 1e-12;
    const double size = ((start - flow.steady()).array() / flow.scale().array()).abs().maxCoeff();
    return size > 0 ? std::max(std::min(least_tolerance, rtol), rtol * std::min(1.0, size)) : rtol;
}

template <class AnyFlow>
void follow(AnyFlow& flow, const SimulateOptions& options, Trajectory& path)
{
    path.commanded_velocity = flow.V0;
    path.steady_friction = link_steady_friction(flow);
    path.states.resize(static_cast<std::size_t>(link_states(flow)));
    const auto mode = slow_mode(flow);
    const auto kind = options.disturbance.kind;
    const double size = size_of(options, default_size(flow, mode, kind));
    const double duration = is_set(options.duration) ? options.duration : default_duration(mode, options.cycle_period);
    if (!mode.shows_itself() && !(is_set(options.disturbance.size) && is_set(options.duration)))
        path.reason = Reason::not_converged;  // nothing says how far or for how long
    if (!std::isfinite(mode.fastest) || !std::isfinite(size) || !std::isfinite(duration))
        path.reason = Reason::not_finite;
    if (path.reason != Reason::none) return;
    FlowVector start = disturbed(flow, mode, kind, size);
    if (options.force.impulse != 0) push(flow, start, options.force.impulse);
    if (!start.allFinite()) {
        path.reason = Reason::law_needs_motion;
        return;
    }
    const double rtol = follows_to(start, flow, options.rtol);
    const auto parts = pieces(options, link_friction_of(flow).normal_load, duration);
    // CVODE builds its order up anew after every jump of the force, one-step methods have nothing to lose
    const bool one_step = options.fallback_only || parts.size() > most_cvode_pieces;
    flow.surround(parts.front().force, parts.front().normal_load);
    SlidingMotion motion(flow, one_step ? Solver::rodas5p : Solver::cvode, rtol);
    bool jumps = false;  // to what holds from the next instant on: both sides of a jump have their row
    motion.observe([&](const Instant& now) {
        const double t = jumps ? std::nextafter(now.t, infinity) : now.t;
        keep_row(flow, {t, now.y, now.velocity, now.stuck, now.flow}, path);
    });
    motion.start(start);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        jumps = i > 0;
        if (jumps) motion.surround(parts[i].force, parts[i].normal_load);
        jumps = false;
        if (motion.advance(parts[i].end, most_steps)) continue;
        path.reason = Reason::solver_failed;
        break;
    }
    path.used_fallback = motion.used_fallback();
}

}  // namespace

Trajectory simulate(const Joint& asked, const SimulateOptions& options)
{
    require_valid(options);
    Trajectory path;
    Joint joint = asked;
    const bool driven =
        !options.force.value.empty() || options.force.impulse != 0 || !options.normal_load.value.empty();
    if (takes_ticks(joint)) {
        if (!driven)
            return loop_trajectory(
                joint, {options.disturbance, options.duration, options.cycle_period, options.rtol, options.seed});
        path.reason = Reason::unsupported, path.why = Detail::forces_in_loop;
        return path;
    }
    if (!options.normal_load.value.empty()) link_friction(joint).normal_load = options.normal_load.value.front();
    const double V0 = commanded_velocity(joint);
    const bool backwards = V0 < 0;
    const auto attempt = [&](auto found) {
        path.reason = found.reason;
        if (found.reason == Reason::unsupported) path.why = why_no_flow(joint);
        if (found.reason != Reason::none) return;
        const Friction& friction = link_friction_of(found.flow);
        follow(found.flow, backwards ? mirrored(options, friction, V0) : options, path);
        if (backwards) mirror(path, friction);
    };
    if (has_delayed_friction(joint))
        attempt(delayed_flow(joint));
    else if (joint.mechanism.model != Model::single_mass)
        attempt(chain_flow(joint));
    else
        attempt(sliding_flow(joint));
    return path;
}

}  // namespace stickslip
