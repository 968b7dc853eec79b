#include "sweep/study/export/effect_targets.h"

#include "analysis/diagnosis/fit/fit.h"
#include "analysis/joint/keys.h"
#include "sweep/study/start/starting_joint.h"

#include <algorithm>
#include <set>
#include <stdexcept>

namespace stickslip {
namespace {

using Says = EffectTarget::Says;

/// Joints of every kind that an effect may ask for: one mass, two masses, a loop with feed-forward, one that
/// integrates, a motor at a supply.
std::vector<Joint> kinds()
{
    Joint one = starting_joint(Model::single_mass, "coulomb-viscous", Motion::revolute);
    one.control.period = 1e-3, one.control.velocity_estimate.form = EstimateForm::backward_difference;
    if (one.control.k_v == 0) one.control.k_v = 1;
    Joint two = starting_joint(Model::two_mass, "coulomb-viscous", Motion::revolute);
    two.control.period = one.control.period, two.control.velocity_estimate = one.control.velocity_estimate;
    Joint fed_forward = one;
    fed_forward.control.feed_forward.acceleration = one.mechanism.inertia;
    Joint integrating = one;
    integrating.control.k_i = one.control.k_p;
    Joint motor = one;
    motor.actuator.kind = ActuatorKind::dc_motor;
    motor.actuator.k_t = 0.1, motor.actuator.k_e = 0.1, motor.actuator.resistance = 1;
    motor.actuator.supply_voltage = 24;
    return {one, two, fed_forward, integrating, motor};
}

/// Keys of the joint that differ from those of another and are in force.
std::vector<std::string> changed_keys(const Joint& from, const Joint& to)
{
    std::set<std::string> before;
    for (const auto& key : keys(from)) before.insert(key.path + " = " + key.value);
    std::vector<std::string> changed;
    for (const auto& key : keys(to))
        if (!before.count(key.path + " = " + key.value) && key.in_force()) changed.push_back(key.path);
    return changed;
}

/// The joint with the effect at its usual size, by its first form that this joint can have. Where the usual size is no
/// change, half the way to the upper bounds is one. Nothing where the joint has no such form.
std::vector<std::string> changed_by(const gap::Effect& effect, const Joint& joint, Joint& edited)
{
    gap::Scales scales;
    scales.coulomb = 1;
    for (const auto& form : effect.forms) {
        const gap::Candidate candidate{{&effect}, {&form}, 1};
        if (!candidate.applies(joint) || !form.apply) continue;
        for (const bool usual : {true, false}) {
            std::vector<double> size;
            for (std::size_t i = 0; i < candidate.parameter_count(); ++i) {
                const auto& p = candidate.parameter(i);
                size.push_back(usual ? p.prior : 0.5 * (p.prior + p.high));
            }
            edited = gap::edited(joint, candidate, gap::in_si(candidate, gap::to_fit(candidate, size), scales), 0);
            if (auto changed = changed_keys(joint, edited); !changed.empty()) return changed;
        }
    }
    return {};
}

EffectTarget target_of(const Joint& edited, const std::vector<std::string>& changed, Simulator to)
{
    EffectTarget target;
    for (const auto& n : export_joint(edited, to).not_expressible)
        if (std::ranges::find(changed, n.key) != changed.end()) target.lost.push_back(n);
    target.says = target.lost.empty() ? Says::all : target.lost.size() == changed.size() ? Says::nothing : Says::part;
    return target;
}

}  // namespace

std::array<EffectTarget, std::size(simulators)> targets_of(const gap::Effect& effect)
{
    for (const Joint& joint : kinds()) {
        Joint edited;
        const auto changed = changed_by(effect, joint, edited);
        if (changed.empty()) continue;
        std::array<EffectTarget, std::size(simulators)> targets;
        for (std::size_t i = 0; i < targets.size(); ++i) targets[i] = target_of(edited, changed, simulators[i].value);
        return targets;
    }
    throw std::logic_error("no kind of joint can have " + std::string(effect.name));
}

}  // namespace stickslip
