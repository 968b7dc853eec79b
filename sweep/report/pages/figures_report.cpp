#include "sweep/report/pages/figures_report.h"

#include "analysis/results/text.h"
#include "sweep/report/figures/model_drawing.h"
#include "sweep/report/pages/reduction_section.h"
#include "sweep/words/interval_text.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

namespace stickslip {
namespace {

std::string model_title(std::string_view id)
{
    constexpr std::pair<std::string_view, const char*> titles[] = {
        {"fig-4", "lever and three inertias"},
        {"fig-5", "three masses"},
        {"fig-6-motor", "two masses, transmission at the motor"},
        {"fig-6-joint", "two masses, transmission at the joint"},
        {"fig-7a", "one mass, motor as a position source"},
        {"fig-7b", "one mass, motor as a force source"}};
    return std::ranges::find(titles, id, [](const auto& title) { return title.first; })->second;
}

Section models_section(const std::vector<PaperModel>& models)
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
    for (const auto& model : models) {
        section.figures.push_back(model_drawing_figure(model.joint, model.id));
        table.rows.push_back(
            {model.id, model_title(model.id),
             with_unit(model.joint.control.k_p, Quantity::stiffness, Units(Motion::prismatic)),
             intervals_text(model.verdict.state_variable.stable_intervals, Quantity::stiffness,
                            Units(Motion::prismatic)),
             with_unit(model.verdict.state_variable.spectral_abscissa, Quantity::rate, Units(Motion::prismatic), 4)});
    }
    section.tables.push_back(std::move(table));
    return section;
}

Table numbers_table(const std::vector<PaperNumber>& numbers)
{
    Table table;
    table.title = "The paper's formulas beside what the program computes another way";
    table.columns = {"equation", "statement", "paper", "computed", "relative difference"};
    for (const auto& n : numbers)
        table.rows.push_back({n.equation, n.statement, with_unit(n.printed, n.quantity, Units(Motion::prismatic), 9),
                              with_unit(n.computed, n.quantity, Units(Motion::prismatic), 9),
                              plain_number(std::abs(n.computed / n.printed - 1), 2)});
    return table;
}

}  // namespace

Report figures_report(const PaperAnswer& answer)
{
    Report report;
    report.title = "The paper, recomputed";
    report.subtitle = "P. E. Dupont, Avoiding Stick-Slip in Position and Force Control Through Feedback, ICRA 1991";
    const auto& numbers = answer.numbers;
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
    const auto& verdict = answer.verdict;
    report.headlines = {
        {report.tone, std::to_string(met) + " of " + std::to_string(numbers.size()),
         "statements of the paper that the program meets another way, to a relative difference below " +
             plain_number(figure_tolerance, 1) + "; largest: " + plain_number(worst, 1)},
        {Headline::Tone::neutral, with_unit(verdict.state_variable.k_cr, Quantity::stiffness, Units(Motion::prismatic)),
         "critical position gain (35) of the joint that the figures are about: above, it slides without any k_{v}"},
        {Headline::Tone::neutral, with_unit(verdict.velocity_only.k_v_min, Quantity::damping, Units(Motion::prismatic)),
         "velocity gain (21) that the velocity-only model requires of it, whatever its k_{p}"}};
    report.sections.push_back(friction_figures(answer.friction));
    report.sections.push_back(models_section(answer.models));
    report.sections.push_back(reduction_section(answer.models.front().joint, answer.reductions));
    report.sections.push_back(stability_figures(answer.stability));
    report.sections.push_back({"numbers", "Numbers", "", {}, {numbers_table(numbers)}});
    report.not_checked = {
        "The paper prints no parameters of its figures: their shapes are compared, not their scales."};
    return report;
}

}  // namespace stickslip
