#include "analysis/simulation/sampled/loop_trajectory.h"

#include "analysis/joint/gains.h"
#include "analysis/simulation/sampled/closed_loop/loop_mode.h"
#include "analysis/simulation/sampled/closed_loop/loop_start.h"
#include "analysis/simulation/sampled/unsteady_terms.h"
#include "analysis/simulation/solvers/trajectory_rows.h"
#include "analysis/stability/real_loop.h"
#include "analysis/stability/steady.h"

#include <cmath>

namespace stickslip {
namespace {

constexpr double turns = 50, most_turns = 400, shown_cycles = 9;
constexpr double shown_waves = 3;            ///< of a force that changes with position or time
constexpr double lead = 14;                  ///< e-folds from a small disturbance to a cycle
constexpr std::size_t most_steps = 300'000;  ///< each is a row

/// |s| and Re s of the slow mode, or of the spring and all inertia where nothing slides steadily.
std::complex<double> rate_of(const Joint& joint, double frame)
{
    if (!has_unsteady_terms(joint)) {
        LoopOptions smooth;
        smooth.ideal_encoder = true;
        smooth.motion.fixed_step = tick_of(joint) / 4;
        SampledLoop loop(joint, frame, frame, LoopSide::joint, smooth);
        if (loop.begin_steadily()) {
            const bool delayed = loop.motion.joint.has_delayed_friction();
            const auto root = real_root(joint);
            const bool by_theory = delayed || leaves_within_tick(root, loop.period());
            const auto mode = by_theory ? mode_by_theory(root, loop.period()) : loop_mode(loop);
            if (mode.known() && std::abs(mode.rate()) > 0) return mode.rate();
        }
    }
    const Chain chain = chain_of(joint);
    double inertia = 0;
    for (int i = 0; i < chain.bodies; ++i) inertia += chain.body[i].inertia;
    return {0, std::sqrt(std::abs(gains_of(joint.control).k_p) / inertia)};
}

void keep_every_second(Trajectory& path)
{
    const auto halve = [](auto& values) {
        for (std::size_t i = 0; 2 * i < values.size(); ++i) values[i] = values[2 * i];
        values.resize((values.size() + 1) / 2);
    };
    for (auto* values : {&path.time, &path.position, &path.velocity, &path.friction}) halve(*values);
    for (auto& state : path.states) halve(state);
    halve(path.stuck);
}

}  // namespace

Trajectory loop_trajectory(const Joint& joint, const LoopMotionQuestion& question)
{
    Trajectory path;
    const auto refuse = [&path](Reason reason, Detail why = Detail::none) {
        return path.reason = reason, path.why = why, path;
    };
    const double V0 = commanded_velocity(joint);
    path.commanded_velocity = V0;
    if (!is_set(V0)) return refuse(Reason::no_velocity);
    if (const auto why = why_not_driven(joint); why != Detail::none) return refuse(Reason::unsupported, why);
    if (const auto why = why_not_disturbed(joint, question.disturbance.kind); why != Detail::none)
        return refuse(Reason::unsupported, why);
    const double frame = sliding_velocity(joint);
    const auto s = rate_of(joint, frame);
    LoopOptions options;
    options.motion.rtol = question.rtol;
    options.seed = joint.sensor.position_noise > 0 || joint.sensor.effort_noise > 0 ? question.seed : 0;
    SampledLoop loop(joint, frame, frame, LoopSide::joint, options);
    if (!loop.begin_steadily())
        return loop.within_limits() ? refuse(Reason::no_steady_state, Detail::chatters) : refuse(Reason::limit_too_low);
    const double origin = loop.motion.y[loop.motion.joint.link()];
    path.steady_friction = loop.motion.joint.link_friction(loop.motion.y.data());
    Disturbance disturbance = question.disturbance;
    if (!is_set(disturbance.size)) disturbance.size = small_size(disturbance.kind, V0, s);
    if (!disturb_loop(loop, with_gains(joint), disturbance)) return refuse(Reason::law_needs_motion);

    const double turn = 2 * std::numbers::pi / std::abs(s);
    double duration = question.duration;
    if (!is_set(duration)) {
        duration = turns * turn;
        if (s.real() > 0) duration = std::clamp(lead / s.real() + 30 * turn, duration, most_turns * turn);
        if (is_set(question.cycle_period)) duration = std::max(duration, shown_cycles * question.cycle_period);
        const double waves = shown_waves * longest_change(joint);
        if (waves < static_cast<double>(most_steps) * loop.period()) duration = std::max(duration, waves);
    }
    const auto keep = [&](double t, const double* y, const DrivenJoint& j) {
        const int link = j.link();
        path.time.push_back(time_of_row(t, path));
        path.position.push_back(y[link] - origin);
        path.velocity.push_back(j.velocity(y, link));
        path.friction.push_back(j.link_friction(y));
        path.stuck.push_back(j.modes[link] == DrivenJoint::Mode::stuck);
        const int states = j.states(link);
        path.states.resize(static_cast<std::size_t>(states));
        for (int i = 0; i < states; ++i) path.states[i].push_back(y[j.first_state(link) + i]);
    };
    keep(0, loop.motion.y.data(), loop.motion.joint);
    const long ticks = std::lround(std::ceil(duration / loop.period()));
    // a long motion in short ticks keeps the steps of some ticks, of ever fewer the more there are in each
    long each = std::max(1L, 2 * ticks / static_cast<long>(most_steps));
    for (long k = 0; k < ticks; ++k) {
        if (path.time.size() > most_steps) keep_every_second(path), each *= 2;
        const bool kept = k % each == 0;
        const bool moved = loop.tick(0, loop.reference_velocity(), 0, [&](const DrivenStep& step) {
            if (kept) keep(step.t + step.step.h, step.step.y1.data(), step.joint);
        });
        if (!moved) return refuse(Reason::solver_failed, Detail::stopped);
    }
    return path;
}

}  // namespace stickslip
