#include "sweep/study/joint_answer.h"

#include "analysis/boundary/kinds/nearest.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

constexpr double locus_span = 100;  // k_p to either side of its own value

std::optional<VelocitySearch> search_velocities(const Joint& joint)
{
    const double V = joint.control.V0;
    if (V == 0 || !is_set(V)) return std::nullopt;
    const double reach = std::pow(10, study_decades);
    const auto [low, high] = std::minmax({V / reach, V * reach});
    VelocitySearch search{V, low, high, {}};
    search.found = stable_velocities(joint, search.low, search.high, Theory::state_variable);
    return search;
}

}  // namespace

JointAnswer answer_joint(const Joint& joint, const LinearVerdict& linear, const NonlinearVerdict& nonlinear,
                         LinearStudy study, const JointQuestion& question)
{
    JointAnswer answer{linear, nonlinear};
    PointResult row = linear_point(joint);
    if (nonlinear.outcome != Outcome::not_asked) write_nonlinear(nonlinear, row);
    answer.region = row.region;
    answer.slides = linear.steady.reason == Reason::none;
    answer.details = linear_details(joint, std::move(study));
    if (!answer.slides) return answer;
    answer.nearest = nearest_boundary(joint, natural_coordinates(joint), affordable_search(joint));
    answer.velocities = search_velocities(joint);
    if (!left_out_by_ideal(joint).used.empty())
        answer.ideal_gains = linear_verdict(with_ideal_loop(joint)).state_variable.stable_intervals;
    if (question.locus)
        answer.locus = sampled_root_locus(
            joint, std::isnan(question.lowest_gain) ? joint.control.k_p / locus_span : question.lowest_gain,
            std::isnan(question.highest_gain) ? joint.control.k_p * locus_span : question.highest_gain);
    return answer;
}

}  // namespace stickslip
