// Random joints with the loops that joints have, each from its number alone, and where two verbs say different things
// about one of them: evaluate, boundary, margins and simulate.
#pragma once
#include "analysis/boundary/kinds/boundary.h"
#include "analysis/boundary/kinds/nearest.h"
#include "analysis/joint/parameters.h"
#include "analysis/simulation/attractor/nonlinear.h"
#include "analysis/simulation/sampled/loop_trajectory.h"
#include "analysis/simulation/simulate.h"
#include "analysis/stability/effort_limits.h"
#include "analysis/stability/real_loop.h"
#include "analysis/stability/steady.h"
#include "analysis/stability/verdict.h"
#include "tests/analysis/boundary/axis.h"
#include "tests/analysis/joint/sample_joints.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>

namespace stickslip::samples {

/// One mass or two, under a loop that is sampled or late, filters, lags, integrates, is limited or has a dead zone, in
/// any combination; under a constant load, or gravity.
inline Joint random_loop(std::uint64_t number)
{
    std::mt19937_64 random(0x100b0000 + number);
    const auto one_in = [&](int n) { return random() % static_cast<unsigned>(n) == 0; };
    const auto one_of = [&](const auto& values) { return values[random() % std::size(values)]; };
    const auto decades = [&](double low, double high) {
        return std::pow(10, std::uniform_real_distribution<double>(low, high)(random));
    };
    const auto all = laws();
    Joint joint = one_in(3) ? two_mass() : single_mass(1);
    joint.friction.law = joint.frictions.link.law = one_of(all).law;
    if (one_in(3)) joint.frictions.motor.law = one_of(all).law;
    auto& c = joint.control;
    c.feedback = one_in(2) ? Feedback::motor : Feedback::link;
    c.k_v = one_of(std::vector<double>{0, 10, 100, 300});
    for (const Parameter& leaf : parameters(joint)) {
        if (!std::isfinite(*leaf.value) || *leaf.value == 0) continue;
        if (leaf.path == "sensor.effort_scale") continue;  // of the log alone: joints keep their numbers
        const double before = *leaf.value;
        *leaf.value *= decades(-0.7, 0.7);
        if (!check(joint).empty()) *leaf.value = before;
    }
    if (!one_in(4)) {
        c.period = one_of(std::vector<double>{5e-4, 1e-3, 2e-3, 1e-2});
        c.velocity_estimate.form = one_in(6) ? EstimateForm::exact : EstimateForm::backward_difference;
        c.velocity_estimate.average = one_of(std::vector<double>{1, 1, 1, 4});
    }
    const double tick = is_set(c.period) ? c.period : 1e-3;
    c.delay = tick * one_of(std::vector<double>{0, 0, 1, 2, 1.4});
    c.velocity_estimate.tau = tick * one_of(std::vector<double>{0, 0, 0.5, 3});
    joint.actuator.lag = one_of(std::vector<double>{0, 0, 5e-4, 3e-3});
    if (one_in(4)) c.k_i = c.k_p * decades(-1, 1.5);
    if (one_in(4)) c.V0 *= -1;
    const double effort = std::abs(steady_effort(joint, c.V0));
    if (one_in(4)) joint.load.constant = 0.3 * effort * (one_in(2) ? 1 : -1);
    if (one_in(3)) c.effort_limit = effort * decades(-0.1, 1);
    if (one_in(3)) c.dead_zone = effort / c.k_p * decades(-1, 1.5);
    if (one_in(12)) joint.load.gravity_amplitude = 0.1 * effort;
    return joint;
}

/// The stable gains that verdict, boundary and margins name, held against each other.
inline std::string contradiction_of_gains(const Joint& joint, const LinearVerdict& verdict)
{
    constexpr double wide = 20, same = 1e-6;
    const auto& memory = verdict.state_variable;
    const double k_p = joint.control.k_p, low = k_p / wide, high = k_p * wide;
    const auto searched = [&](double k) {
        return k > memory.searched_from * (1 + same) && k < memory.searched_to * (1 - same);
    };
    const auto doubted = [&] { return !memory.doubtful.empty(); };
    std::vector<double> ends;
    for (const auto& i : memory.stable_intervals)
        for (const double end : {i.low, i.high})
            if (end > 0 && end < infinity) ends.push_back(end);
    const auto is_end = [&](double k) {
        return std::ranges::any_of(ends, [&](double e) { return std::abs(k - e) < same * e; });
    };
    BoundaryRequest request;
    request.scan = 60;
    const auto ray = locate_boundaries(joint, axis("control.k_p", low, high), request);
    for (const auto& p : ray.points)
        if (searched(p.value) && !is_end(p.value) && !doubted()) return "a boundary that is no end of stable gains";
    const double step = std::pow(high / low, 1.0 / request.scan);
    for (const double end : ends) {
        if (!(end > low * step && end < high / step) || !searched(end) || ray.undecided > 0) continue;
        // two within one step may both be missed
        const bool lonely = std::ranges::none_of(
            ends, [&](double e) { return e != end && std::abs(std::log(e / end)) < 2 * std::log(step); });
        const bool found = std::ranges::any_of(
            ray.points, [&](const BoundaryPoint& p) { return std::abs(p.value - end) < same * end; });
        if (lonely && !found) return "an end of stable gains that is no boundary";
    }
    const auto alone = nearest_boundary(joint, {{"control.k_p", ""}}, affordable_search(joint));
    if (alone.decided && !memory.neutral && alone.stable != memory.stable) return "margins and verdict";
    if (!alone.found) return "";
    const double reached = alone.moves[0].to;
    if (searched(reached) && !is_end(reached) && !doubted()) return "a margin that is no end of stable gains";
    for (const double end : ends)
        if (searched(end) && std::abs(std::log(end / k_p)) < 0.8 * alone.distance && ends.size() < 3)
            return "an end of stable gains nearer than the margin";
    return "";
}

/// Largest distance from the velocity of steady sliding within shares of a motion's duration.
inline double largest_deviation(const Trajectory& path, double velocity, double from, double to)
{
    double most = 0;
    const double end = path.time.back();
    for (std::size_t i = 0; i < path.time.size(); ++i)
        if (path.time[i] >= from * end && path.time[i] <= to * end)
            most = std::max(most, std::abs(path.velocity[i] - velocity));
    return most;
}

/// A small disturbance, simulated for some e-folds of the root that the verdict names: it has to go the same way.
inline std::string contradiction_of_growth(const Joint& joint, const LinearVerdict& verdict)
{
    constexpr double small = 1e-3, folds = 4, most_turns = 300;
    const auto& memory = verdict.state_variable;
    if (memory.eigenvalues.empty() || memory.neutral) return "";
    const auto s = memory.eigenvalues.front();
    const double rate = std::abs(memory.spectral_abscissa);
    if (rate * most_turns * 2 * std::numbers::pi < folds * std::abs(s)) return "";
    SimulateOptions options;
    options.disturbance = {DisturbanceKind::offset, small * std::abs(verdict.steady.velocity / s)};
    options.duration = folds / rate;
    const auto path = simulate(joint, options);
    if (path.reason != Reason::none || path.time.size() < 10) return "";
    const double velocity = sliding_velocity(joint);
    const double before = largest_deviation(path, velocity, 0.3, 0.6),
                 after = largest_deviation(path, velocity, 0.7, 1);
    const double noise = 1e-7 * std::abs(velocity);
    if (memory.stable ? after > 1.5 * before + noise : after < before / 1.5 - noise)
        return memory.stable ? "a small disturbance of a stable joint grows" : "a small disturbance dies out";
    return "";
}

/// How evaluate says that a joint ends from rest, against the motion from there on.
inline std::string contradiction_of_end(const Joint& joint, const NonlinearVerdict& verdict)
{
    if (verdict.reason != Reason::none || verdict.outcome == Outcome::linear_only) return "";
    const double velocity = sliding_velocity(joint), V0 = std::abs(velocity);
    const double k_p = std::abs(joint.control.k_p);
    SimulateOptions options;
    options.disturbance = verdict.disturbance;
    // a spring that is pulled to either side of its dead zone, three times over, and what small motions take to fade
    const double wound = 2 * (std::abs(steady_effort(joint, velocity)) / k_p + joint.control.dead_zone);
    const double cycle = is_set(verdict.period) ? verdict.period : 0;
    options.duration = 6 * wound / V0 + 30 * cycle + 15 / std::abs(verdict.growth_rate);
    if (!std::isfinite(options.duration)) return "";
    const double tick = is_set(joint.control.period) ? joint.control.period : 1e-3;
    if (options.duration > 3e5 * tick) return "";
    const auto path = simulate(joint, options);
    if (path.reason != Reason::none || path.time.size() < 10) return "";
    const double end = path.time.back();
    bool rests = true, moves_on = false;
    for (std::size_t i = 0; i < path.time.size(); ++i) {
        if (path.time[i] < 0.6 * end) continue;
        rests = rests && path.stuck[i];
        moves_on = moves_on || std::abs(path.velocity[i] - velocity) > 0.3 * V0;
    }
    if (rests && verdict.outcome != Outcome::held) return "evaluate says that it moves, and it rests";
    if (!rests && verdict.outcome == Outcome::held) return "evaluate says that it rests, and it moves";
    if (verdict.outcome == Outcome::stable_sliding && moves_on) return "evaluate says that it slides, and it does not";
    return "";
}

/// What two verbs say differently about a joint; empty where all agree.
inline std::string contradiction_of_verbs(const Joint& joint)
{
    const auto verdict = linear_verdict(joint);
    if (verdict.steady.reason != Reason::none) return "";
    if (auto found = contradiction_of_gains(joint, verdict); !found.empty()) return found;
    if (auto found = contradiction_of_growth(joint, verdict); !found.empty()) return found;
    const auto& memory = verdict.state_variable;
    for (const auto& disturbance : {Disturbance{}, Disturbance{DisturbanceKind::start, 0}}) {
        NonlinearOptions options;
        options.disturbance = disturbance;
        const auto motion = nonlinear_verdict(joint, options);
        const bool grows = motion.region == NonlinearRegion::stick_slip;
        const bool decays = motion.region == NonlinearRegion::stable || motion.region == NonlinearRegion::bistable;
        const bool matters = std::ranges::any_of(verdict.loop.not_used, [](const auto& n) { return n.matters; });
        if (!memory.neutral && (memory.stable ? grows : decays) && !matters) return "region and linear verdict";
        if (auto found = contradiction_of_end(joint, motion); !found.empty()) return found;
    }
    return "";
}

}  // namespace stickslip::samples
