#include "sweep/words/symbols.h"

#include <algorithm>
#include <vector>

namespace stickslip {
namespace {

struct Entry {
    std::string_view ending;  ///< whole last keys of the path; the first entry that fits wins
    std::string_view symbol, name;
};

constexpr Entry entries[] = {
    {"control.k_p", "k_{p}", "position gain"},
    {"control.k_v", "k_{v}", "velocity gain"},
    {"control.k_i", "k_{i}", "integral gain"},
    {"control.position_gain", "K_{pos}", "position gain of the cascade"},
    {"control.velocity_gain", "K_{v}", "velocity gain of the cascade"},
    {"control.velocity_integral_gain", "K_{i}", "integral gain of the velocity loop"},
    {"control.velocity_reset_time", "T_{n}", "reset time of the velocity loop"},
    {"control.integral_limit", "u_{i,max}", "limit of the integral"},
    {"control.tracking_time", "T_{t}", "tracking time"},
    {"control.integral_band", "e_{i}", "integral band"},
    {"control.dead_zone", "e_{0}", "dead zone"},
    {"normal.displacement", "n_{0}", "normal force per displacement"},
    {"normal.velocity", "n_{1}", "normal force per velocity"},
    {"normal.acceleration", "n_{2}", "normal force per acceleration"},
    {"normal.mu", "μ", "friction coefficient"},
    {"normal.alpha", "α", "Linker-Dieterich coefficient"},
    {"control.V0", "V_{0}", "commanded velocity"},
    {"control.force_rate", "Ḟ_{0}", "force rate"},
    {"control.period", "T", "sample time"},
    {"control.delay", "T_{d}", "dead time"},
    {"sensor.delay", "T_{s}", "dead time of the reading"},
    {"control.effort_limit", "u_{max}", "controller limit"},
    {"velocity_estimate.tau", "τ_{v}", "velocity filter time constant"},
    {"joint.inertia", "m", "inertia"},
    {"joint.motor_inertia", "m_{mot}", "motor inertia"},
    {"joint.transmission_inertia", "m_{tr}", "transmission inertia"},
    {"joint.link_inertia", "m_{link}", "link inertia"},
    {"joint.lever_arm", "d", "lever arm"},
    {"motor_transmission.stiffness", "k_{m-tr}", "motor-transmission stiffness"},
    {"motor_transmission.damping", "c_{m-tr}", "motor-transmission damping"},
    {"transmission_link.stiffness", "k_{tr-l}", "transmission-link stiffness"},
    {"transmission_link.damping", "c_{tr-l}", "transmission-link damping"},
    {"transmission.stiffness", "k_{tr}", "transmission stiffness"},
    {"transmission.damping", "c_{tr}", "transmission damping"},
    {"ratio", "N", "transmission ratio"},
    {"backlash", "β", "backlash"},
    {"load.constant", "F_{load}", "constant load"},
    {"load.gravity_amplitude", "m g l", "gravity amplitude"},
    {"f0", "f_{0}", "friction at the reference velocity"},
    {"A", "A", "direct effect"},
    {"B", "B", "evolution effect"},
    {"L", "L", "slip distance"},
    {"V_star", "V*", "reference velocity"},
    {"coulomb", "F_{c}", "Coulomb friction"},
    {"viscous", "F_{v}", "viscous friction"},
    {"kinetic", "F_{k}", "kinetic friction"},
    {"static", "F_{s}", "static friction"},
    {"c0", "c_{0}", "Coulomb friction"},
    {"c1", "c_{1}", "viscous slope"},
    {"c2", "c_{2}", "Stribeck peak"},
    {"c3", "c_{3}", "Stribeck velocity"},
    {"c4", "c_{4}", "Stribeck exponent"},
    {"sigma0", "σ_{0}", "bristle stiffness"},
    {"sigma1", "σ_{1}", "bristle damping"},
    {"sigma2", "σ_{2}", "viscous friction"},
    {"stribeck_velocity", "v_{s}", "Stribeck velocity"},
    {"lag", "τ", "time lag"},
    {"f_v", "f_{v}", "instantaneous velocity slope"},
    {"effort_gain", "k_{a}", "effort gain"},
    {"k_t", "k_{t}", "torque constant"},
    {"k_e", "k_{e}", "back-EMF constant"},
    {"resistance", "R", "winding resistance"},
    {"supply_voltage", "U_{0}", "supply voltage"},
    {"encoder_quantum", "Δ_{q}", "encoder quantum"},
};

struct Split {
    std::string path;    ///< without the index of a list
    std::string number;  ///< of the list element, counted from 1; empty for a single one
};

Split split_index(std::string_view path)
{
    const auto dot = path.rfind('.');
    const std::string_view last = path.substr(dot == std::string_view::npos ? 0 : dot + 1);
    const bool index = dot != std::string_view::npos && !last.empty() && last.size() < 4 &&
                       std::all_of(last.begin(), last.end(), [](char c) { return c >= '0' && c <= '9'; });
    if (!index) return {std::string(path), ""};
    return {std::string(path.substr(0, dot)), std::to_string(std::stoi(std::string(last)) + 1)};
}

const Entry* entry_of(std::string_view path)
{
    for (const auto& entry : entries) {
        if (!path.ends_with(entry.ending)) continue;
        const std::size_t before = path.size() - entry.ending.size();
        if (before == 0 || path[before - 1] == '.') return &entry;
    }
    return nullptr;
}

/// The last `count` keys of a path.
std::vector<std::string> last_keys(std::string_view path, std::size_t count)
{
    std::vector<std::string> keys;
    while (!path.empty() && keys.size() < count) {
        const auto dot = path.rfind('.');
        keys.insert(keys.begin(), std::string(path.substr(dot == std::string_view::npos ? 0 : dot + 1)));
        path = path.substr(0, dot == std::string_view::npos ? 0 : dot);
    }
    return keys;
}

}  // namespace

std::string symbol_of(std::string_view given, Motion motion)
{
    const Split split = split_index(given);
    std::string symbol;
    if (const Entry* entry = entry_of(split.path)) {
        symbol = entry->symbol;
        if (motion == Motion::revolute && split.path.ends_with("inertia")) symbol.front() = 'J';
    } else {
        const auto keys = last_keys(split.path, 1);
        const std::string key = keys.empty() ? "" : keys.back();
        const auto underscore = key.find('_');
        symbol = key.substr(0, underscore);
        if (underscore != std::string::npos) symbol += "_{" + key.substr(underscore + 1) + "}";
        std::replace(symbol.begin(), symbol.end(), '_', ' ');
        if (underscore != std::string::npos) symbol[underscore] = '_';
    }
    if (split.number.empty()) return symbol;
    if (symbol.ends_with('}')) return symbol.substr(0, symbol.size() - 1) + "," + split.number + "}";
    return symbol + "_{" + split.number + "}";
}

std::string name_of(std::string_view given)
{
    const Split split = split_index(given);
    std::string name;
    if (const Entry* entry = entry_of(split.path)) {
        name = entry->name;
    } else {
        for (const auto& key : last_keys(split.path, 2)) name += (name.empty() ? "" : " ") + key;
        std::replace(name.begin(), name.end(), '_', ' ');
    }
    return split.number.empty() ? name : name + " " + split.number;
}

}  // namespace stickslip
