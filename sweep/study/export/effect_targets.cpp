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

/// By the first form that this joint can have. Where the usual size is no change, half the way to the upper bounds is
/// one. Nothing changed: the joint has no such form.
EffectEdit edit_by(const gap::Effect& effect, const Joint& joint)
{
    gap::Scales scales;
    scales.coulomb = 1;
    for (const auto& form : effect.forms) {
        const gap::Candidate candidate{{&effect}, {&form}, 1};
        if (!candidate.applies(joint) || !form.apply) continue;
        const auto at = [&](const std::vector<double>& size) {
            return gap::edited(joint, candidate, gap::in_si(candidate, gap::to_fit(candidate, size), scales), 0);
        };
        std::vector<double> usual, half_way;
        std::size_t sized = 0;
        for (std::size_t i = 0; i < candidate.parameter_count(); ++i) {
            const auto& p = candidate.parameter(i);
            usual.push_back(p.prior);
            half_way.push_back(0.5 * (p.prior + p.high));
            if (p.size) sized = i;
        }
        for (auto size : {usual, half_way}) {
            EffectEdit edit;
            edit.edited = at(size);
            edit.changed = changed_keys(joint, edit.edited);
            if (edit.changed.empty()) continue;
            size[sized] = 0.5 * (size[sized] + candidate.parameter(sized).high);
            edit.larger = at(size);
            for (auto& key : changed_keys(edit.edited, edit.larger))
                if (std::ranges::find(edit.changed, key) != edit.changed.end()) edit.own.push_back(std::move(key));
            return edit;
        }
    }
    return {};
}

EffectTarget target_of(const EffectEdit& edit, Simulator to)
{
    EffectTarget target;
    std::size_t own_lost = 0;
    for (const auto& n : export_joint(edit.edited, to).not_expressible) {
        if (std::ranges::find(edit.changed, n.key) == edit.changed.end()) continue;
        target.lost.push_back(n);
        const bool held_in_part = n.why == Lost::delay_of_target && delays_target(to);
        if (!held_in_part && std::ranges::find(edit.own, n.key) != edit.own.end()) ++own_lost;
    }
    target.says = target.lost.empty() ? Says::all : own_lost == edit.own.size() ? Says::nothing : Says::part;
    return target;
}

}  // namespace

EffectEdit usual_edit(const gap::Effect& effect)
{
    for (const Joint& joint : kinds())
        if (EffectEdit edit = edit_by(effect, joint); !edit.own.empty()) return edit;
    throw std::logic_error("no kind of joint can have " + std::string(effect.name));
}

std::array<EffectTarget, std::size(simulators)> targets_of(const gap::Effect& effect)
{
    const EffectEdit edit = usual_edit(effect);
    std::array<EffectTarget, std::size(simulators)> targets;
    for (std::size_t i = 0; i < targets.size(); ++i) targets[i] = target_of(edit, simulators[i].value);
    return targets;
}

}  // namespace stickslip
