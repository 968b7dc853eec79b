#include "sweep/study/paper/paper_figures.h"

#include "sweep/study/paper/paper_parts.h"

namespace stickslip {
namespace {

Joint chain_joint(Model model)
{
    Joint joint = paper_joint();
    auto& m = joint.mechanism;
    m.model = model;
    m.inertia = not_set;
    m.motor_inertia = 1e-3;
    m.transmission_inertia = model == Model::lever ? 1e-3 : 0.1;
    m.lever_arm = model == Model::lever ? 0.1 : not_set;
    m.link_inertia = 1;
    // seen from the joint, both springs of the lever and of three masses are the same
    m.motor_transmission = {.stiffness = model == Model::lever ? 1e4 : 1e6, .ratio = 10};
    m.transmission_link = {.stiffness = 2e6};
    m.transmission = {.stiffness = 1e6, .ratio = 10};
    joint.frictions.motor.law = CoulombViscous{0.1, 0.02};
    joint.frictions.transmission.law = CoulombViscous{0.5, 0};
    joint.frictions.link = joint.friction;
    joint.control.k_p = 1e5;
    joint.control.k_v = 50;
    return joint;
}

}  // namespace

std::vector<PaperModel> paper_models()
{
    const Joint lever = chain_joint(Model::lever), three = chain_joint(Model::three_mass);
    Joint force = three_mass_to_two_mass(three, Placement::at_motor).joint;
    force.control.kind = ControlKind::force;
    const Joint at_motor = three_mass_to_two_mass(three, Placement::at_motor).joint,
                at_joint = three_mass_to_two_mass(three, Placement::at_joint).joint;
    std::vector<PaperModel> drawn = {{"fig-4", lever, {}},
                                     {"fig-5", lever_to_three_mass(lever).joint, {}},
                                     {"fig-6-motor", at_motor, {}},
                                     {"fig-6-joint", at_joint, {}},
                                     {"fig-7a", two_mass_to_single_mass(at_motor).joint, {}},
                                     {"fig-7b", two_mass_to_single_mass(force).joint, {}}};
    for (auto& model : drawn) model.verdict = linear_verdict(model.joint);
    return drawn;
}

PaperAnswer paper_answer()
{
    PaperAnswer answer;
    answer.verdict = linear_verdict(paper_joint());
    answer.friction = paper_friction();
    answer.stability = paper_stability();
    answer.models = paper_models();
    answer.reductions = reduction_studies(answer.models.front().joint);
    answer.numbers = paper_numbers();
    return answer;
}

}  // namespace stickslip
