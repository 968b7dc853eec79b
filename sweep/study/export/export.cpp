#include "sweep/study/export/export.h"

#include "analysis/joint/keys.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace stickslip {
namespace {

/// Which simulators say a key; the letters stand in the order of the enumeration.
constexpr std::string_view everyone = "musir", nobody = "", with_mechanism = "mus", with_loop = "msir";

/// A rule holds for every key that begins with `prefix`; the longest one counts.
struct Rule {
    std::string_view prefix;
    std::string_view said_by;
    Lost why;
};

/// Keys of the friction on a body stand here as of "friction.", whatever the body.
constexpr Rule rules[] = {
    {"joint.motion", everyone, Lost::no_element},
    {"joint.model", everyone, Lost::no_element},
    {"joint.inertia", with_mechanism, Lost::from_the_robot},
    {"joint.link_inertia", with_mechanism, Lost::from_the_robot},
    {"joint.motor_inertia", "mi", Lost::joined_to_link},
    {"joint.transmission_inertia", nobody, Lost::three_bodies},
    {"joint.lever_arm", nobody, Lost::three_bodies},
    {"joint.transmission.", "m", Lost::rigid},
    {"joint.transmission.cubic_stiffness", nobody, Lost::hardening},
    {"joint.transmission.ratio", everyone, Lost::no_element},
    {"joint.transmission.backlash", "mus", Lost::backlash},
    {"joint.motor_transmission.", nobody, Lost::three_bodies},
    {"joint.motor_transmission.ratio", everyone, Lost::no_element},
    {"joint.transmission_link.", "m", Lost::rigid},
    {"joint.transmission_link.cubic_stiffness", nobody, Lost::hardening},
    {"joint.transmission_link.ratio", everyone, Lost::no_element},
    {"joint.transmission_link.backlash", "mus", Lost::backlash},
    {"pose.", everyone, Lost::no_element},  // where inertia and gravity come from
    {"load.constant", nobody, Lost::no_element},
    {"load.gravity_", with_mechanism, Lost::from_the_robot},
    {"load.cogging", nobody, Lost::position_dependent},
    {"load.disturbance", nobody, Lost::time_dependent},
    {"control.kind", nobody, Lost::not_position_control},
    {"control.structure", with_loop, Lost::gains_elsewhere},  // a cascade is a sum of gains, its integral apart
    {"control.feedback", nobody, Lost::feedback_side},
    {"control.k_p", with_loop, Lost::gains_elsewhere},
    {"control.k_v", with_loop, Lost::gains_elsewhere},
    {"control.k_i", "sr", Lost::integral},
    {"control.position_gain", with_loop, Lost::gains_elsewhere},
    {"control.velocity_gain", with_loop, Lost::gains_elsewhere},
    {"control.velocity_integral_gain", "sr", Lost::integral},
    {"control.velocity_reset_time", "sr", Lost::integral},
    {"control.integral_limit", "r", Lost::integral},
    {"control.anti_windup", nobody, Lost::integral},
    {"control.tracking_time", nobody, Lost::integral},
    {"control.integral_band", nobody, Lost::integral},
    {"control.dead_zone", nobody, Lost::no_element},
    {"control.feed_forward", nobody, Lost::feed_forward},
    {"control.dither", nobody, Lost::time_dependent},
    {"control.V0", everyone, Lost::no_element},  // a question of the maps, not of the joint
    {"control.force_rate", everyone, Lost::no_element},
    {"control.period", "r", Lost::sampling},
    {"control.reference_velocity", "mi", Lost::gains_elsewhere},
    {"control.effort_limit", "musi", Lost::mechanism_elsewhere},
    {"control.delay", nobody, Lost::delay_of_target},
    {"control.velocity_estimate", nobody, Lost::estimate},
    {"actuator.kind", with_loop, Lost::gains_elsewhere},
    {"actuator.effort_gain", with_loop, Lost::gains_elsewhere},
    {"actuator.k_t", with_loop, Lost::gains_elsewhere},
    {"actuator.resistance", with_loop, Lost::gains_elsewhere},
    {"actuator.signal", with_loop, Lost::gains_elsewhere},
    {"actuator.k_e", "musi", Lost::mechanism_elsewhere},
    {"actuator.supply_voltage", "musi", Lost::supply},
    {"actuator.supply_resistance", nobody, Lost::supply},
    {"actuator.sag_effort", nobody, Lost::supply},
    {"actuator.limit", "musi", Lost::mechanism_elsewhere},
    {"actuator.lag", nobody, Lost::lag},
    {"sensor.delay", nobody, Lost::delay_of_target},
    {"sensor.", nobody, Lost::sensor},
    {"normal.", nobody, Lost::load_dependent},
    {"friction.normal_load", "musi", Lost::mechanism_elsewhere},
    {"friction.asymmetry", nobody, Lost::direction},
    {"friction.load_coefficient", nobody, Lost::load_dependent},
    {"friction.gear", nobody, Lost::load_dependent},
    {"friction.ripple", nobody, Lost::position_dependent},
    {"friction.drift", nobody, Lost::time_dependent},
    {"friction.bristle", nobody, Lost::presliding},
    {"friction.memory", nobody, Lost::memory},
};

/// Of a law: the numbers that are a Coulomb level or a viscous slope, and what the rest of it is.
struct LawRule {
    std::string_view name;
    std::array<std::string_view, 2> said;
    std::string_view rise;  ///< the key that is the friction at rest
    Lost rest;
};
constexpr LawRule law_rules[] = {
    {"coulomb-viscous", {"coulomb", "viscous"}, "", Lost::no_element},
    {"kinetic-static", {"kinetic", ""}, "static", Lost::static_rise},
    {"stribeck", {"c0", "c1"}, "c2", Lost::static_rise},
    {"rate-and-state", {"f0", ""}, "", Lost::memory},
    {"ageing", {"f0", ""}, "", Lost::memory},
    {"rate-and-state-regularised", {"f0", ""}, "", Lost::memory},
    {"dahl", {"coulomb", ""}, "", Lost::presliding},
    {"lugre", {"coulomb", "sigma2"}, "static", Lost::presliding},
    {"maxwell-slip", {"viscous", ""}, "", Lost::presliding},
    {"time-lag", {"", ""}, "", Lost::memory},
    {"kernel", {"f0", ""}, "", Lost::memory},
};

constexpr char letter(Simulator to)
{
    return everyone[static_cast<std::size_t>(to)];
}

/// "friction.motor.ripple.phase" as "friction.ripple.phase".
std::string without_body(const std::string& path)
{
    for (const std::string_view body : {"friction.motor.", "friction.transmission.", "friction.link."})
        if (path.starts_with(body)) return "friction." + path.substr(body.size());
    return path;
}

const Rule* rule_of(const std::string& path)
{
    const Rule* best = nullptr;
    for (const auto& rule : rules)
        if (path.starts_with(rule.prefix) && (!best || rule.prefix.size() > best->prefix.size())) best = &rule;
    return best;
}

/// Whether a simulator with mechanism takes this key of a law, and if not, what is lost.
std::optional<Lost> law_key(Simulator to, const std::string& law, std::string_view key)
{
    const auto* rule =
        std::find_if(std::begin(law_rules), std::end(law_rules), [&](const LawRule& r) { return r.name == law; });
    if (rule == std::end(law_rules)) return Lost::no_element;
    if (to == Simulator::ros2_control) return Lost::mechanism_elsewhere;
    if (key == "law") return rule->rest == Lost::no_element ? std::nullopt : std::optional(rule->rest);
    if (key == rule->said[0] || key == rule->said[1]) return std::nullopt;
    if (key == rule->rise && to == Simulator::isaaclab) return std::nullopt;  // its static friction effort
    return key == rule->rise ? Lost::static_rise : rule->rest;
}

std::optional<Lost> lost(const Key& key, Simulator to, std::string& law)
{
    const std::string path = without_body(key.path);
    const Rule* rule = rule_of(path);
    if (!rule && path.starts_with("friction.")) {
        const auto name = std::string_view(path).substr(std::string_view("friction.").size());
        if (name == "law") law = key.value;
        return law_key(to, law, name);
    }
    if (!rule) return Lost::no_element;
    if (rule->said_by.find(letter(to)) != std::string_view::npos) return std::nullopt;
    const bool of_mechanism = path.starts_with("joint.") || path.starts_with("load.") || path.starts_with("friction.");
    const bool elsewhere = of_mechanism || rule->said_by == "musi";
    return to == Simulator::ros2_control && elsewhere ? Lost::mechanism_elsewhere : rule->why;
}

/// The simulator's usual step, or what the fastest motion of this joint needs: a twentieth of its period, and half the
/// time in which the loop's damping acts, both explicit in a simulator.
double timestep_for(const SimulatorJoint& s, Simulator to)
{
    constexpr double share = 0.3;  // of 1/ω: semi-implicit Euler's own damping is then below 5 %
    const double usual = to == Simulator::isaaclab                           ? 0.005
                         : to == Simulator::mjcf                             ? 0.002
                         : to == Simulator::ros2_control && is_set(s.period) ? s.period
                                                                             : 0.001;
    double fastest = std::sqrt(s.k_p / s.inertia());
    if (s.two_bodies() && std::isfinite(s.stiffness)) {
        fastest = std::max(fastest, std::sqrt(s.k_p / s.armature));
        fastest = std::max(fastest, std::sqrt(s.stiffness * (1 / s.armature + 1 / s.link_inertia)));
    }
    const bool two = s.two_bodies() && std::isfinite(s.stiffness);
    const double moved = two ? std::min(s.armature, s.link_inertia) : s.inertia();
    const double decay = (s.k_v + (two ? s.damping : 0)) / moved;
    double step = usual;
    if (to == Simulator::ros2_control) return step;
    if (fastest > 0) step = std::min(step, share / fastest);
    if (decay > 0) step = std::min(step, 0.5 / decay);
    if (step == usual) return step;
    const double decade = std::pow(10, std::floor(std::log10(step)));  // one digit is enough for a file
    return std::max(1.0, std::floor(step / decade)) * decade;
}

}  // namespace

ExportAnswer export_joint(const Joint& joint, Simulator to, const ExportOptions& options)
{
    ExportAnswer answer;
    answer.to = to;
    answer.joint = simulator_joint(joint, options.split);
    answer.timestep = is_set(options.timestep) ? options.timestep : timestep_for(answer.joint, to);
    answer.delay_steps = static_cast<int>(std::lround(answer.joint.delay / answer.timestep));
    // two hinges with the dead band between them: the rotor is a body of its own
    const bool rotor_apart = answer.joint.backlash > 0 && answer.joint.two_bodies();
    std::string law;
    for (const auto& key : keys(joint)) {
        const bool law_name = key.path.ends_with(".law");
        if (!law_name && (!key.in_force() || key.value.empty())) continue;
        const auto why = lost(key, to, law);
        if (why && !(why == Lost::joined_to_link && rotor_apart)) answer.not_expressible.push_back({key.path, *why});
        const bool damps = key.path.starts_with("joint.transmission") && key.path.ends_with(".damping");
        if (!why && damps && rotor_apart) answer.not_expressible.push_back({key.path, Lost::damped_gap});
    }
    return answer;
}

}  // namespace stickslip
