#include "analysis/diagnosis/verdict/unresolved_memory.h"

#include "analysis/diagnosis/policy/ladder_verdict.h"

#include <algorithm>

namespace stickslip::gap {
namespace {

constexpr const char *memory = "frictional-memory", *curve = "stribeck";

/// The coarsest step or noise of a reading in any of the records, as a motion of the body that carries the friction.
double coarsest_reading(std::span<const Case> cases, const Scales& scales)
{
    double coarsest = 0;
    for (const auto& c : cases)
        coarsest = std::max({coarsest, c.joint.sensor.encoder_quantum, c.joint.sensor.position_noise});
    return coarsest * scales.friction.motion;
}

std::vector<std::string> with_curve(std::vector<std::string> names)
{
    const bool has_curve = std::ranges::count(names, curve) > 0;
    if (has_curve)
        std::erase(names, memory);
    else
        std::ranges::replace(names, std::string(memory), std::string(curve));
    return names;
}

}  // namespace

void doubt_unresolved_memory(std::span<const Case> cases, const Scales& scales, Diagnosis& d)
{
    if (d.verdict != Verdict::gap || d.effects.empty()) return;
    const auto& parameters = d.effects[0].parameters;
    const auto slip = std::ranges::find(parameters, "frictional-memory.L", &FittedParameter::name);
    if (slip == parameters.end() || !(slip->value < policy::resolved_slip * coarsest_reading(cases, scales))) return;
    const bool has_curve = std::ranges::count(d.effects[0].names, curve) > 0;  // a rung of its own
    Cause other = d.effects[0];  // what it leaves is what the curve leaves
    other.names = with_curve(d.effects[0].names);
    other.form.clear(), other.parameters.clear(), other.values.clear();
    if (std::ranges::count(d.ambiguous_with, other.names) > 0) return;
    const auto listed = std::ranges::find(d.effects, other.names, &Cause::names);
    if (listed != d.effects.end()) d.effects.erase(listed);
    d.effects[0].probability /= 2;
    other.probability = d.effects[0].probability;
    d.ambiguous_with.push_back(other.names);
    d.effects.insert(d.effects.begin() + 1, std::move(other));
    for (auto& rung : d.ladder) {
        if (std::ranges::count(rung.names, memory) == 0) continue;
        rung.probability /= 2;
        if (!has_curve) rung.ambiguous_with.push_back(with_curve(rung.names));
    }
}

}  // namespace stickslip::gap
