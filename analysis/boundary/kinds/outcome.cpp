#include "analysis/boundary/kinds/outcome.h"

#include "analysis/boundary/kinds/coexistence.h"
#include "analysis/simulation/attractor/large_disturbance.h"
#include "analysis/simulation/attractor/nonlinear.h"
#include "analysis/simulation/flows/flow.h"
#include "analysis/simulation/lanes/batch.h"
#include "analysis/simulation/points.h"
#include "analysis/simulation/sampled/loop_verdict.h"
#include "analysis/stability/verdict.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

constexpr std::size_t batch = 32;  ///< joints that lanes follow side by side
constexpr int patience = 10;       ///< times the usual limit of turns, for an outcome that is undecided within it

/// Whether the disturbance is the start that every search for coexisting cycles makes: lanes answer that some hundred
/// times faster than one motion at a time.
bool is_start_from_near_rest(const Disturbance& d)
{
    return d.kind == DisturbanceKind::start && d.size == near_rest_start;
}

/// What the spectrum alone decides: where sliding is unstable nothing can end in it. 0: that has to be simulated.
double side_without_motion(const Joint& joint)
{
    if (sliding_flow(joint).reason == Reason::linear_only) return missing;
    return linear_point(joint).spectral_abscissa > 0 ? 1 : 0;
}

double side_of_outcome(Outcome outcome)
{
    switch (outcome) {
        case Outcome::stable_sliding:
            return -1;
        case Outcome::stick_slip:
        case Outcome::limit_cycle:
        case Outcome::reversal:
        case Outcome::period_n:
        case Outcome::irregular:
        case Outcome::held:
            return 1;
        default:
            return missing;
    }
}

/// Whether a motion that was watched for more turns could end otherwise: not where none could be followed, not where
/// the work ran out before the turns, and not where an encoder or noise leaves no turns to count.
bool more_turns_may_decide(const Joint& joint, const NonlinearVerdict& v)
{
    if (joint.sensor.encoder_quantum > 0 || joint.sensor.position_noise > 0) return false;
    return v.outcome == Outcome::undecided && v.reason == Reason::not_converged && v.detail != Detail::limit_of_work;
}

/// Real loops; an undecided one was followed to the end of its turns or of its work.
std::vector<double> sides_of_real_loops(std::span<const Joint* const> joints, NonlinearOptions options)
{
    auto verdicts = real_loop_verdicts(joints, options);
    options.turn_limit *= patience;
    std::vector<double> sides;
    for (std::size_t i = 0; i < joints.size(); ++i) {
        if (more_turns_may_decide(*joints[i], verdicts[i])) verdicts[i] = nonlinear_verdict(*joints[i], options);
        sides.push_back(side_of_outcome(verdicts[i].outcome));
    }
    return sides;
}

/// Many at once where lanes follow them, and only until the side is sure; close to the linear boundary motions creep,
/// and one that is undecided is watched for longer.
std::vector<double> simulated_sides(std::span<const Joint> joints, const Disturbance& disturbance)
{
    NonlinearOptions options;
    options.disturbance = disturbance;
    options.region = false;
    std::vector<double> sides(joints.size());
    lanes::sides(joints, options, sides);
    std::vector<std::size_t> open, real;
    std::vector<Joint> undecided_joints;
    std::vector<const Joint*> loops;
    for (std::size_t i = 0; i < joints.size(); ++i) {
        if (!std::isnan(sides[i])) continue;
        if (takes_ticks(joints[i]))
            real.push_back(i), loops.push_back(&joints[i]);
        else
            open.push_back(i), undecided_joints.push_back(joints[i]);
    }
    const auto of_loops = sides_of_real_loops(loops, options);
    for (std::size_t k = 0; k < real.size(); ++k) sides[real[k]] = of_loops[k];
    std::vector<PointResult> points(open.size());
    nonlinear_points(undecided_joints, options, points);
    options.turn_limit *= patience;
    for (std::size_t k = 0; k < open.size(); ++k) {
        const auto outcome = points[k].outcome;
        const bool undecided = outcome == Outcome::undecided;
        sides[open[k]] = side_of_outcome(undecided ? nonlinear_verdict(undecided_joints[k], options).outcome : outcome);
    }
    return sides;
}

}  // namespace

std::vector<double> outcome_sides(const std::vector<Joint>& joints, const Disturbance& disturbance,
                                  const ParallelFor& parallel)
{
    std::vector<double> sides(joints.size());
    parallel(joints.size(), [&](std::size_t i) { sides[i] = side_without_motion(joints[i]); });
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < joints.size(); ++i)
        if (sides[i] == 0) open.push_back(i);
    if (is_start_from_near_rest(disturbance)) {
        // the search for coexisting cycles pulls a real loop as well, which is another disturbance and another motion
        std::vector<Joint> ideal;
        std::vector<std::size_t> place, left;
        for (const auto i : open)
            if (takes_ticks(joints[i]))
                left.push_back(i);
            else
                place.push_back(i), ideal.push_back(joints[i]);
        const auto found = coexistence(ideal, parallel);
        for (std::size_t k = 0; k < place.size(); ++k) {
            sides[place[k]] = found[k] == 0 ? 1 : found[k];
            if (std::isnan(found[k])) left.push_back(place[k]);
        }
        open = std::move(left);
    }
    parallel((open.size() + batch - 1) / batch, [&](std::size_t b) {
        std::vector<Joint> undecided_joints;
        const std::size_t end = std::min(open.size(), (b + 1) * batch);
        for (std::size_t k = b * batch; k < end; ++k) undecided_joints.push_back(joints[open[k]]);
        const auto found = simulated_sides(undecided_joints, disturbance);
        for (std::size_t k = b * batch; k < end; ++k) sides[open[k]] = found[k - b * batch];
    });
    return sides;
}

double outcome_side(const Joint& joint, const Disturbance& disturbance)
{
    const auto in_order = [](std::size_t n, const std::function<void(std::size_t)>& task) {
        for (std::size_t i = 0; i < n; ++i) task(i);
    };
    return outcome_sides({joint}, disturbance, in_order).front();
}

}  // namespace stickslip
