#include "sweep/files/json/export_json.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace stickslip {
namespace {

nlohmann::ordered_json number(double value)
{
    return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

nlohmann::ordered_json friction_json(const SimulatorFriction& f)
{
    return {{"coulomb", f.coulomb},
            {"viscous", f.viscous},
            {"static", f.breakaway},
            {"read_at", number(f.speed > 0 ? f.speed : not_set)}};
}

}  // namespace

nlohmann::ordered_json export_json(const ExportAnswer& answer, const std::string& text,
                                   const std::function<std::string(const NotExpressible&)>& why)
{
    const auto& j = answer.joint;
    nlohmann::ordered_json json = {{"format", "stickslip-export/1"},
                                   {"to", std::string(simulators[static_cast<std::size_t>(answer.to)].name)},
                                   {"text", text}};
    json["numbers"] = {{"link_inertia", j.link_inertia},
                       {"armature", j.armature},
                       {"gear", j.ratio},
                       {"stiffness", number(j.stiffness)},
                       {"damping", j.damping},
                       {"backlash", j.backlash},
                       {"friction", friction_json(j.friction())},
                       {"motor_friction", friction_json(j.motor)},
                       {"link_friction", friction_json(j.link)},
                       {"kp", j.k_p},
                       {"kv", j.k_v},
                       {"ki", j.k_i},
                       {"effort_limit", number(j.effort_limit)},
                       {"delay", j.delay},
                       {"timestep", answer.timestep},
                       {"delay_steps", answer.delay_steps}};
    auto& lost = json["not_expressible"] = nlohmann::ordered_json::array();
    for (const auto& n : answer.not_expressible)
        lost.push_back({{"key", n.key}, {"why", why(n)}, {"why_code", name_of(n.why)}});
    json["gap_left"] = nullptr;
    if (!answer.gap_left) return json;
    const GapLeft& left = *answer.gap_left;
    json["gap_left"] = left.text;
    auto& gap =
        json["gap"] = {{"joint", left.joint}, {"text", left.text}, {"signals", nlohmann::ordered_json::array()}};
    for (const auto& s : left.signals)
        gap["signals"].push_back(
            {{"name", s.signal}, {"unit", s.unit}, {"joint", s.joint}, {"text", s.text}, {"floor", s.floor}});
    return json;
}

nlohmann::ordered_json effect_targets_json(const std::array<EffectTarget, std::size(simulators)>& targets)
{
    nlohmann::ordered_json json;
    for (std::size_t i = 0; i < targets.size(); ++i) {
        auto& target = json[std::string(simulators[i].name)] = {{"says", name_of(targets[i].says)},
                                                                {"lost", nlohmann::ordered_json::array()}};
        for (const auto& n : targets[i].lost) target["lost"].push_back({{"key", n.key}, {"why_code", name_of(n.why)}});
    }
    return json;
}

}  // namespace stickslip
