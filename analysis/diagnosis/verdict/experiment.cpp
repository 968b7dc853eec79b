#include "analysis/diagnosis/verdict/experiment.h"

#include "analysis/diagnosis/plan/safe_motion.h"
#include "analysis/diagnosis/policy/page_and_plan.h"
#include "analysis/joint/gains.h"

#include <algorithm>
#include <cmath>

namespace stickslip::gap {
namespace {

/// What the machine has done in this record.
Reach shown_by(const Case& c)
{
    std::vector<double> time, position;
    for (std::size_t k = 0; k < c.ticks.size(); ++k) {
        if (!c.ticks.logged[k]) continue;
        time.push_back(c.ticks.time[k]), position.push_back(c.ticks.position[k]);
    }
    return reach_of(time, position);
}

/// Whether the joint itself stays within what it has shown.
bool survives(const Trace& run, const std::vector<double>& time, const Reach& reach)
{
    const Reach done = reach_of(time, run.true_position);
    const auto margin = policy::beyond_stroke * (reach.high - reach.low);
    return done.low >= reach.low - margin && done.high <= reach.high + margin &&
           done.speed <= policy::beyond_speed * reach.speed &&
           done.acceleration <= policy::beyond_acceleration * reach.acceleration;
}

}  // namespace

std::vector<std::string> names_of(const Candidate& candidate)
{
    std::vector<std::string> names;
    for (const auto* e : candidate.effects) names.emplace_back(e->name);
    return names;
}

std::string joined(const std::vector<std::string>& names)
{
    std::string text;
    for (const auto& n : names) text += (text.empty() ? "" : " + ") + n;
    return text;
}

NextExperiment design_experiment(const Case& like, const Scales& scales, const Attribution& winner,
                                 const Attribution& rival)
{
    NextExperiment best;
    best.separates.emplace_back(joined(names_of(winner.candidate)), joined(names_of(rival.candidate)));
    if (!is_set(gains_of(like.joint.control).k_p)) return best;
    const double period = is_set(like.joint.control.period) ? like.joint.control.period : like.row_step;
    const double duration = std::min(20.0, std::max(8.0, like.ticks.duration()));
    const Reach reach = shown_by(like);
    for (const auto& motion : safe_motions(reach, duration, period)) {
        Record r;
        const std::size_t rows = motion.time.size();
        r.time = motion.time;
        r.reference_position = motion.position;
        r.position.assign(rows, reach.start);
        Case c = like;
        c.ticks = on_clock(r, like.joint);
        const auto run = [&](const Attribution& a) {
            return simulate_closed_loop(
                flatten(edited(like.joint, a.candidate, in_si(a.candidate, a.x[1], scales), like.number)), c.ticks, 0);
        };
        const Trace one = run(winner), two = run(rival);
        if (!survives(one, r.time, reach)) continue;
        double square = 0;
        const double effort_sigma = std::max(like.effort_sigma, 0.01 * scales.effort);
        for (std::size_t k = 0; k < rows; ++k) {
            const double q = (one.position[k] - two.position[k]) / like.sigma,
                         f = (one.effort[k] - two.effort[k]) / effort_sigma;
            square += q * q + f * f;
        }
        const double distance = std::sqrt(square / static_cast<double>(std::max<std::size_t>(rows, 1)));
        if (std::isfinite(distance) && distance > best.distance) {
            best.distance = distance;
            best.motion = motion.kind;
            best.time = r.time;
            best.reference = r.reference_position;
        }
    }
    return best;
}

}  // namespace stickslip::gap
