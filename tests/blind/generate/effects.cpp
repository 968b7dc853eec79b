#include "tests/blind/generate/effects.h"

#include "tests/blind/generate/effects_parts.h"

#include <algorithm>
#include <iterator>
#include <stdexcept>

namespace blind {
namespace {

const std::vector<EffectEntry>& entries()
{
    static const std::vector<EffectEntry> all = [] {
        std::vector<EffectEntry> list = friction_effects();
        for (auto part : {mechanism_effects(), loop_effects()})
            list.insert(list.end(), std::make_move_iterator(part.begin()), std::make_move_iterator(part.end()));
        return list;
    }();
    return all;
}

const EffectEntry& entry(const std::string& name)
{
    const auto found = std::find_if(entries().begin(), entries().end(), [&](const auto& e) { return e.name == name; });
    if (found == entries().end()) throw std::invalid_argument("no effect is called " + name);
    return *found;
}

/// Effects of one group look so alike that a pair of them would not be a fair question.
const std::vector<std::vector<std::string>> look_alikes = {
    {"delay", "actuator-lag", "velocity-filter", "compliance", "backlash"},
    {"cogging", "position-dependent-friction", "gravity"},
    {"gravity", "sensor-offset", "constant-load", "asymmetric-friction"},
    {"presliding", "backlash", "frictional-memory"},
    {"stribeck", "frictional-memory"},
    {"coulomb-level", "friction-drift", "load-dependent-friction", "stribeck"},
    {"inertia", "effort-gain", "gain-k_p", "compliance"},
    {"viscous", "gain-k_v"},
    {"saturation", "supply-sag"},
    {"quantisation", "backlash", "presliding"},
};

}  // namespace

const std::vector<std::string>& effect_names()
{
    static const std::vector<std::string> names = [] {
        std::vector<std::string> list;
        for (const auto& e : entries()) list.push_back(e.name);
        return list;
    }();
    return names;
}

bool controller_has(const std::string& structure, const std::string& effect)
{
    const bool of_integral = effect == "gain-k_i" || effect == "feed-forward" || effect == "dead-zone";
    if (structure == "pd") return !of_integral;
    return structure == "pid" || (effect != "gain-k_p" && effect != "gain-k_v");
}

std::vector<std::string> families_for(const std::string& effect)
{
    return entry(effect).families;
}

Edit draw_effect(const std::string& name, const Nominal& nominal, double peak_command, Draw& draw)
{
    Edit edit = entry(name).draw(nominal, peak_command, draw);
    edit.name = name;
    return edit;
}

bool may_pair(const std::string& one, const std::string& other)
{
    if (one == other) return false;
    for (const auto& group : look_alikes)
        if (std::count(group.begin(), group.end(), one) && std::count(group.begin(), group.end(), other)) return false;
    return true;
}

}  // namespace blind
