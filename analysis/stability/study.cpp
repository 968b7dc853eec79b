#include "analysis/stability/study.h"

#include <cmath>

#include "analysis/stability/steady.h"

namespace stickslip {
namespace {

/// Several bodies ask for a set of gains at each velocity, one mass for a slope.
int range_scan(const Joint& joint)
{
    return joint.mechanism.model == Model::single_mass ? 600 : 120;
}

}  // namespace

bool known_at_one_velocity(const Joint& joint)
{
    const Chain chain = chain_of(joint);
    for (int i = 0; i < chain.bodies; ++i)
        if (info(chain.body[i].friction->law).linear_only) return true;
    return false;
}

LinearStudy linear_study(const Joint& joint)
{
    LinearStudy study;
    const auto steady = steady_sliding(joint);
    if (steady.reason != Reason::none) return study;
    const double V = std::abs(steady.velocity), reach = std::pow(10, study_decades);
    const auto linear = linear_joint(joint, steady.velocity);
    study.compliance = std::abs(disturbance_response(linear, 0));
    study.peak = response_peak(linear);
    study.margins = loop_margins(linear);
    if (!known_at_one_velocity(joint)) {
        study.velocities = {V / reach, V * reach};
        study.velocity_only = stable_velocities(joint, V / reach, V * reach, Theory::velocity_only);
        study.state_variable = stable_velocities(joint, V / reach, V * reach, Theory::state_variable);
        study.range_gain = velocity_gain_for_range(joint, study.velocities.high, range_scan(joint));
    }
    study.comparison = compare_theories(joint);
    if (is_set(joint.control.period)) {
        study.velocity_noise = std::sqrt(2.0) / joint.control.period;
        study.mix = optimal_mix(joint, study.velocity_noise);
    }
    const double stiffness = joint.control.k_p + joint.control.contact_stiffness;
    if (joint.control.kind == ControlKind::force && stiffness * V > 0 && joint.control.k_p > 0 &&
        !known_at_one_velocity(joint)) {
        ForceRamp ramp;
        ramp.rate = stiffness * V;
        const double k_p = joint.control.k_p;
        ramp.velocity_only = stable_springs(joint, ramp.rate, k_p / reach, k_p * reach, Theory::velocity_only);
        ramp.state_variable = stable_springs(joint, ramp.rate, k_p / reach, k_p * reach, Theory::state_variable);
        study.ramp = ramp;
    }
    study.reductions = reduction_studies(joint);
    return study;
}

}  // namespace stickslip
