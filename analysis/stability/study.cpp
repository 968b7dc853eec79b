#include "analysis/stability/study.h"

#include <algorithm>
#include <cmath>

#include "analysis/joint/sum_of_gains.h"
#include "analysis/stability/frequency_search.h"
#include "analysis/stability/real_loop.h"
#include "analysis/stability/real_response.h"
#include "analysis/stability/stable_gains.h"
#include "analysis/stability/steady.h"

namespace stickslip {
namespace {

/// Velocities that are looked at: fewer where each costs a count of roots, still fewer with many dead ticks.
constexpr int many_velocities = 200, counted_velocities = 60, few_velocities = 40, fewest_velocities = 10;

/// Of a real loop, where each costs a search, as many as less than the usual effort leaves.
int affordable(int velocities, const Joint& joint)
{
    if (search_effort() >= 1 || loop_kind(joint) == LoopKind::ideal) return velocities;
    return std::clamp(static_cast<int>(velocities * search_effort()), fewest_velocities, velocities);
}

/// Several bodies and real loops ask for a set of gains at each velocity, one mass of the ideal loop for a slope.
int range_scan(const Joint& joint, bool costly)
{
    if (costly) return 12;
    switch (loop_kind(joint)) {
        case LoopKind::ideal:
            return joint.mechanism.model == Model::single_mass ? 600 : 120;
        case LoopKind::sampled:
            return 120;
        case LoopKind::continuous:
            return 24;
    }
    return 0;
}

/// What costs many searches is computed for joints with delays only where more than the usual effort is allowed, for
/// real loops not with less.
constexpr double effort_of_delayed_studies = 10;

std::vector<ReductionStudy> named_only(const Joint& joint)
{
    std::vector<ReductionStudy> studies;
    for (const auto& reduction : reductions_of(joint)) {
        ReductionStudy study;
        study.name = reduction.steps;
        study.assumption = reduction.assumption;
        study.unsearched = true;
        studies.push_back(std::move(study));
    }
    return studies;
}

}  // namespace

bool many_dead_ticks(const Joint& joint)
{
    if (loop_kind(joint) != LoopKind::sampled) return false;
    const double V = sliding_velocity(joint);
    const auto loop = real_loop(joint, linear_joint(joint, V), V, TurnedGain::all);
    return loop && std::holds_alternative<DelayedLoop>(loop->loop);
}

bool known_at_one_velocity(const Joint& joint)
{
    const Chain chain = chain_of(joint);
    for (int i = 0; i < chain.bodies; ++i)
        if (info(chain.body[i].friction->law).linear_only) return true;
    return false;
}

namespace {

/// Factors of k_p alone, in the place of those of all gains together.
void take_gain_alone(double k_p, const StableGains& gains, LoopMargins& margins)
{
    if (!gains.known || !(k_p > 0)) return;
    for (const auto& window : gains.stable)
        if (window.low < k_p && k_p < window.high)
            margins.gain_below = std::max(0.0, window.low / k_p), margins.gain_above = window.high / k_p;
}

}  // namespace

LinearStudy linear_study(const Joint& given)
{
    // a cascade that is no sum of gains has no k_v of its own to turn: what does so is missing
    const bool turns_gains = is_sum_of_gains(given.control);
    const Joint joint = turns_gains ? with_gains(given) : given;
    LinearStudy study;
    const auto steady = steady_sliding(joint);
    if (steady.reason != Reason::none) return study;
    const double V = std::abs(steady.velocity), reach = std::pow(10, study_decades);
    const auto linear = linear_joint(joint, steady.slides_at);
    const bool effort = search_effort() >= effort_of_delayed_studies;
    const bool costly = !effort && many_dead_ticks(joint);
    const bool hasty = search_effort() < 1 && loop_kind(joint) != LoopKind::ideal;
    const bool thorough = (linear.rational() && !costly && !hasty) || effort;
    // of a cascade in a real loop the verdict turns the position gain, and with it the integral's share of the sum
    const Joint& turned = loop_kind(joint) == LoopKind::ideal ? joint : given;
    const auto gains = stable_gains(turned);
    if (const auto response = LoopResponse::of(joint, Theory::state_variable)) {
        study.compliance = std::abs(response->at(0));
        study.peak = response->peak();
    }
    if (loop_kind(joint) == LoopKind::ideal) {
        study.margins = loop_margins(linear, gains.crossings);
    } else if (const auto margins = real_margins(joint); growth_rate(joint) < 0) {
        study.margins = {margins.gain_below, margins.gain_above, margins.lag, margins.crossover};
        if (turns_gains) take_gain_alone(joint.control.k_p, gains, study.margins);
    }
    if (!known_at_one_velocity(joint)) {
        const bool back = steady.velocity < 0;
        const auto [low, high] = study.velocities =
            back ? Interval{-V * reach, -V / reach} : Interval{V / reach, V * reach};
        const bool counted = !linear.rational() || loop_kind(joint) == LoopKind::continuous;
        const int usual = costly ? few_velocities : counted ? counted_velocities : many_velocities;
        const int scan = study.velocities_looked_at = effort ? many_velocities : affordable(usual, joint);
        study.velocity_only = stable_velocities(joint, low, high, Theory::velocity_only, scan);
        study.state_variable = stable_velocities(joint, low, high, Theory::state_variable, scan);
        if (turns_gains)
            study.range_gain =
                velocity_gain_for_range(joint, back ? low : high, affordable(range_scan(joint, costly), joint));
    }
    study.comparison = compare_theories(joint, turned, gains);
    if (is_set(joint.control.period)) {
        study.velocity_noise = std::sqrt(2.0) / joint.control.period;
        study.mix_searched = thorough && turns_gains;
        if (study.mix_searched) study.mix = optimal_mix(joint, study.velocity_noise);
    }
    const double stiffness = joint.control.k_p + joint.control.contact_stiffness;
    if (joint.control.kind == ControlKind::force && stiffness * V > 0 && joint.control.k_p > 0 &&
        !known_at_one_velocity(joint)) {
        ForceRamp ramp;
        ramp.rate = stiffness * steady.velocity;
        const double k_p = joint.control.k_p;
        ramp.velocity_only = stable_springs(joint, ramp.rate, k_p / reach, k_p * reach, Theory::velocity_only);
        ramp.state_variable = stable_springs(joint, ramp.rate, k_p / reach, k_p * reach, Theory::state_variable);
        study.ramp = ramp;
    }
    study.reductions = thorough && turns_gains ? reduction_studies(joint) : named_only(joint);
    return study;
}

}  // namespace stickslip
