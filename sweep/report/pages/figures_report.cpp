#include "sweep/report/pages/figures_report.h"

#include "analysis/results/text.h"
#include "analysis/stability/reduction_study.h"
#include "analysis/stability/verdict.h"
#include "sweep/report/figures/model_drawing.h"
#include "sweep/report/pages/reduction_section.h"

#include <algorithm>
#include <cmath>

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

Section models_section()
{
    Section section{
        "models",
        "Lumped models (Figs. 4 to 7)",
        "One joint with its parameters, from the lever to one mass; also in the files models/*.svg beside this page.",
        {},
        {}};
    Table table;
    table.title = "One joint, lumped more and more coarsely";
    table.columns = {"figure", "model", "slides at k_{p} =", "stable k_{p}", "max Re s"};
    for (const auto& model : paper_models()) {
        section.figures.push_back(model_drawing_figure(model.joint, model.id));
        const auto verdict = linear_verdict(model.joint);
        std::string gains;
        for (const auto& i : verdict.state_variable.stable_intervals)
            gains += (gains.empty() ? "" : ", ") +
                     range_text(i.low, i.high, Quantity::stiffness, Units(Motion::prismatic), low_to_high, 4);
        table.rows.push_back(
            {model.id, model.title, with_unit(model.joint.control.k_p, Quantity::stiffness, Units(Motion::prismatic)),
             gains.empty() ? "none" : gains,
             with_unit(verdict.state_variable.spectral_abscissa, Quantity::rate, Units(Motion::prismatic), 4)});
    }
    section.tables.push_back(std::move(table));
    return section;
}

Table numbers_table()
{
    Table table;
    table.title = "The paper's formulas beside what the program computes another way";
    table.columns = {"equation", "statement", "paper", "computed", "relative difference"};
    for (const auto& n : paper_numbers())
        table.rows.push_back({n.equation, n.statement, with_unit(n.printed, n.quantity, Units(Motion::prismatic), 9),
                              with_unit(n.computed, n.quantity, Units(Motion::prismatic), 9),
                              plain_number(std::abs(n.computed / n.printed - 1), 2)});
    return table;
}

}  // namespace

std::vector<PaperModel> paper_models()
{
    const Joint lever = chain_joint(Model::lever), three = chain_joint(Model::three_mass);
    Joint force = three_mass_to_two_mass(three, Placement::at_motor).joint;
    force.control.kind = ControlKind::force;
    const Joint at_motor = three_mass_to_two_mass(three, Placement::at_motor).joint,
                at_joint = three_mass_to_two_mass(three, Placement::at_joint).joint;
    return {{"fig-4", "lever and three inertias", lever},
            {"fig-5", "three masses", lever_to_three_mass(lever).joint},
            {"fig-6-motor", "two masses, transmission at the motor", at_motor},
            {"fig-6-joint", "two masses, transmission at the joint", at_joint},
            {"fig-7a", "one mass, motor as a position source", two_mass_to_single_mass(at_motor).joint},
            {"fig-7b", "one mass, motor as a force source", two_mass_to_single_mass(force).joint}};
}

Report figures_report()
{
    Report report;
    report.title = "The paper, recomputed";
    report.subtitle = "P. E. Dupont, Avoiding Stick-Slip in Position and Force Control Through Feedback, ICRA 1991";
    const auto numbers = paper_numbers();
    double worst = 0;
    int met = 0;
    for (const auto& n : numbers) {
        const double difference = std::abs(n.computed / n.printed - 1);
        worst = std::max(worst, difference);
        met += difference < figure_tolerance;
    }
    report.verdict = worst < figure_tolerance ? "Every formula of the paper is met by another method to within " +
                                                    plain_number(worst, 1) + "."
                                              : "A formula of the paper is missed by " + plain_number(worst, 1) + ".";
    report.tone = worst < figure_tolerance ? Headline::Tone::good : Headline::Tone::bad;
    const auto verdict = linear_verdict(paper_joint());
    report.headlines = {
        {report.tone, std::to_string(met) + " of " + std::to_string(numbers.size()),
         "statements of the paper that the program meets another way, to a relative difference below " +
             plain_number(figure_tolerance, 1) + "; largest: " + plain_number(worst, 1)},
        {Headline::Tone::neutral, with_unit(verdict.state_variable.k_cr, Quantity::stiffness, Units(Motion::prismatic)),
         "critical position gain (35) of the joint that the figures are about: above, it slides without any k_{v}"},
        {Headline::Tone::neutral, with_unit(verdict.velocity_only.k_v_min, Quantity::damping, Units(Motion::prismatic)),
         "velocity gain (21) that the velocity-only model requires of it, whatever its k_{p}"}};
    report.sections.push_back(friction_figures());
    report.sections.push_back(models_section());
    const Joint lever = paper_models().front().joint;
    report.sections.push_back(reduction_section(lever, reduction_studies(lever)));
    report.sections.push_back(stability_figures());
    report.sections.push_back({"numbers", "Numbers", "", {}, {numbers_table()}});
    report.not_checked = {
        "The paper prints no parameters of its figures: their shapes are compared, not their scales."};
    return report;
}

}  // namespace stickslip
