// Figs. 1-3 of the paper.
#include "analysis/results/text.h"
#include "sweep/report/figures/line_figure.h"
#include "sweep/report/pages/figures_report.h"

namespace stickslip {
namespace {

const AxisName velocity_label{"velocity V", "m/s"}, force_label{"friction f", "N"};

/// A curve over −V … V and its set-valued point at rest.
LineChart curve_chart(const char* title, std::string parameters, const Samples& steady, double at_rest)
{
    LineChart chart;
    chart.title = title;
    chart.fixed = std::move(parameters);
    chart.x_label = velocity_label;
    chart.y_label = force_label;
    chart.lines = {{"steady sliding", steady.x, steady.y},
                   {"at rest: any force in between", {0, 0}, {-at_rest, at_rest}, true}};
    return chart;
}

Figure kinetic_static(const PaperFriction& f)
{
    return line_figure(
        "fig-1a",
        curve_chart("Fig. 1a: kinetic and static friction", "F_{k} = 10 N, F_{s} = 14 N", f.kinetic_static, 14),
        "Kinetic friction of 10 N in motion, anything up to 14 N at rest.",
        "Friction against velocity. At rest the force is whatever holds the body, up to the static level.");
}

Figure stribeck(const PaperFriction& f)
{
    auto chart = curve_chart("Fig. 1b: the friction-velocity curve of lubricated hard materials",
                             "c_{0} = 10 N, c_{1} = 30 N·s/m, c_{2} = 5 N, c_{3} = 10 mm/s, c_{4} = 2", f.stribeck, 15);
    chart.x_marks = {{"end of range A", f.end_of_range_A}};
    return line_figure(
        "fig-1b", std::move(chart),
        "Friction falls from 15 N at rest to its minimum and rises again with viscous friction.",
        "Equation (7). The falling piece next to rest is range A of the paper: sliding there is what both theories are "
        "about.");
}

Figure velocity_steps(const PaperFriction& f)
{
    LineChart chart;
    chart.title = "Fig. 2: response to step changes in velocity, one state variable";
    chart.fixed = "A = 1 N, B = 1.5 N, L = 10 µm; V = 1, 10, 1 mm/s";
    chart.x_label = {"slip", "m"};
    chart.y_label = force_label;
    chart.lines = {{"", f.velocity_steps.x, f.velocity_steps.y}};
    chart.x_marks = {{"× 10", f.faster}, {"÷ 10", f.slower}};
    return line_figure(
        "fig-2", std::move(chart),
        "Each step of velocity moves friction at once in its own direction, by A ln 10 = 2.30 N, and friction "
        "then decays over the slip distance L to the steady curve, B ln 10 = 3.45 N back.",
        "Equations (4)-(6) with the velocity imposed. The three properties of §2 in one picture: direct "
        "effect, steady-state dependence, characteristic slip distance.");
}

Figure oscillating_velocity(const PaperFriction& f)
{
    LineChart chart;
    chart.title = "Fig. 3: response to an oscillating velocity, V = V_{0} + V_{1} sin ωt";
    chart.fixed = "V_{0} = 1 mm/s, V_{1} = 0.8 mm/s, A = 1 N, B = 1.5 N, L = 2 µm";
    chart.x_label = velocity_label;
    chart.y_label = force_label;
    for (const auto& [omega, loop] : f.oscillations)
        chart.lines.push_back({"ω = " + plain_number(omega) + " rad/s", loop.x, loop.y});
    chart.lines.push_back({"steady curve (6)", f.steady.x, f.steady.y, true});
    return line_figure(
        "fig-3", std::move(chart),
        "At ω = 1 rad/s friction traces the steady curve; the faster the oscillation, the wider the loop.",
        "Third period. The loop around the steady curve is what Hess and Soom measured on lubricated "
        "contacts, and modelled by a time lag. At still higher ω the direct effect tilts the loop upwards.");
}

}  // namespace

Section friction_figures(const PaperFriction& f)
{
    return {"friction",
            "Friction (§2)",
            "",
            {kinetic_static(f), stribeck(f), velocity_steps(f), oscillating_velocity(f)},
            {}};
}

}  // namespace stickslip
