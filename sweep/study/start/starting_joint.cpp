#include "sweep/study/start/starting_joint.h"

#include "analysis/joint/keys.h"
#include "analysis/joint/parameters.h"
#include "sweep/study/start/row_filler.h"

#include <algorithm>
#include <stdexcept>

namespace stickslip {
namespace {

/// Numbers of a light machine axis (N, m, kg) and of a robot's joint (N·m, rad, kg·m²), by the last part of their path.
struct Example {
    std::string_view key;
    double prismatic, revolute;
};
constexpr Example examples[] = {
    {"inertia", 1, 0.05},
    {"motor_inertia", 0.3, 0.02},
    {"link_inertia", 1, 0.05},
    {"lever_arm", 0.1, 0.1},
    {"transmission_inertia", 0.1, 0.005},
    {"stiffness", 1e6, 1e4},
    {"damping", 20, 0.2},
    {"k_p", 6e4, 600},
    {"k_v", 10, 0.5},
    {"V0", 1e-3, 0.05},
    // friction
    {"f0", 60, 0.6},
    {"A", 1, 0.01},
    {"B", 1.5, 0.015},
    {"L", 1e-5, 5e-4},
    {"V_star", 1e-3, 0.05},
    {"coulomb", 60, 0.6},
    {"viscous", 5, 0.02},
    {"kinetic", 60, 0.6},
    {"static", 66, 0.66},
    {"c0", 60, 0.6},
    {"c1", 10, 0.02},
    {"c2", 6, 0.06},
    {"c3", 2e-3, 0.1},
    {"sigma0", 1e7, 5e3},
    {"sigma1", 300, 1},
    {"sigma2", 10, 0.02},
    {"stribeck_velocity", 2e-3, 0.1},
    {"yield", 60, 0.6},
    {"lag", 1e-3, 1e-3},
    {"f_v", 500, 0.2},
    {"weight", 2e5, 50},
    {"rate", 500, 500},
};

const Example* example_of(std::string_view path, Model model)
{
    // a lever's middle body has an inertia about its pivot, the other models' moves as the joint does
    const bool lever_pivot = path == "joint.transmission_inertia" && model == Model::lever;
    static constexpr Example pivot{"transmission_inertia", 1e-3, 1e-3};
    if (lever_pivot) return &pivot;
    // "friction.B.1" is an element of B; the digit of "friction.c0" is part of its name
    const auto element = path.substr(path.rfind('.') + 1);
    if (element.find_first_not_of("0123456789") == std::string_view::npos) path.remove_suffix(element.size() + 1);
    const auto name = path.substr(path.rfind('.') + 1);
    const auto found =
        std::find_if(std::begin(examples), std::end(examples), [&](const Example& e) { return e.key == name; });
    return found == std::end(examples) ? nullptr : found;
}

/// Of a spring between two bodies.
bool is_damping_of(const Mechanism& m, const double* value)
{
    return value == &m.transmission.damping || value == &m.motor_transmission.damping ||
           value == &m.transmission_link.damping;
}

/// Of a friction law.
bool is_reference_velocity(const Parameter& parameter)
{
    return parameter.role == Role::label && parameter.quantity == Quantity::velocity;
}

}  // namespace

Joint starting_joint(Model model, const std::string& law, Motion motion)
{
    Joint joint;
    joint.mechanism.motion = motion;
    joint.mechanism.model = model;
    for (const auto& key : keys(joint)) {
        if (!key.path.ends_with(".law")) continue;
        if (!choose(joint, key.path, law)) throw std::invalid_argument("there is no friction law " + law);
    }
    RowFiller filler{RowFiller::Lists::needed};
    Joint::fields(joint, filler);
    for (auto& parameter : parameters(joint)) {
        const bool wanted = parameter.need == Need::required || parameter.path == "control.V0" ||
                            parameter.path == "control.k_v" || is_damping_of(joint.mechanism, parameter.value) ||
                            is_reference_velocity(parameter);
        const bool absent = !is_set(*parameter.value) || *parameter.value == 0;
        if (!wanted) continue;
        if (const auto* example = example_of(parameter.path, model); example && absent)
            *parameter.value = motion == Motion::prismatic ? example->prismatic : example->revolute;
    }
    return joint;
}

}  // namespace stickslip
