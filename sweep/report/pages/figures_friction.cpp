// Figs. 1-3 of the paper.
#include "analysis/friction/imposed_velocity.h"
#include "analysis/results/text.h"
#include "sweep/report/pages/figures_report.h"
#include "sweep/words/line_figure.h"

#include <cmath>
#include <numbers>

namespace stickslip {
namespace {

const AxisName velocity_label{"velocity V", "m/s"}, force_label{"friction f", "N"};

/// A curve over −V … V and its set-valued point at rest.
LineChart curve_chart(const char* title, std::string parameters, const Friction& friction, double highest,
                      double at_rest)
{
    LineChart chart;
    chart.title = title;
    chart.fixed = std::move(parameters);
    chart.x_label = velocity_label;
    chart.y_label = force_label;
    LineChart::Line line{"steady sliding", {}, {}};
    constexpr int steps = 400;
    for (const int side : {-1, 1}) {
        if (side > 0) line.x.push_back(missing), line.y.push_back(missing);
        for (int i = 0; i <= steps; ++i) {
            const double share = side > 0 ? double(i) / steps : 1 - double(i) / steps;
            const double V = side * std::max(highest * share, 1e-9 * highest);
            line.x.push_back(V);
            line.y.push_back(steady_force(friction, V));
        }
    }
    chart.lines = {std::move(line), {"at rest: any force in between", {0, 0}, {-at_rest, at_rest}, true}};
    return chart;
}

Figure kinetic_static()
{
    Friction friction;
    friction.law = KineticStatic{10, 14};
    return line_figure(
        "fig-1a", curve_chart("Fig. 1a: kinetic and static friction", "F_{k} = 10 N, F_{s} = 14 N", friction, 0.1, 14),
        "Kinetic friction of 10 N in motion, anything up to 14 N at rest.",
        "Friction against velocity. At rest the force is whatever holds the body, up to the static level.");
}

Figure stribeck()
{
    Friction friction;
    friction.law = Stribeck{10, 30, 5, 0.01, 2};
    auto chart =
        curve_chart("Fig. 1b: the friction-velocity curve of lubricated hard materials",
                    "c_{0} = 10 N, c_{1} = 30 N·s/m, c_{2} = 5 N, c_{3} = 10 mm/s, c_{4} = 2", friction, 0.1, 15);
    // where f_{ss}' vanishes: c_{1} = (2 c_{2} V/c_{3}²) e^{−(V/c_{3})²}
    const double end_of_A = end_of_falling_friction(friction, 0.01, 0.05);
    chart.x_marks = {{"end of range A", end_of_A}};
    return line_figure(
        "fig-1b", std::move(chart),
        "Friction falls from 15 N at rest to its minimum and rises again with viscous friction.",
        "Equation (7). The falling piece next to rest is range A of the paper: sliding there is what both theories are "
        "about.");
}

Figure velocity_steps()
{
    const Friction friction = paper_joint().friction;
    const double slow = 1e-3, fast = 1e-2, distance = 8e-5;
    const auto at = [](double V, double slip) { return VelocityPiece{slip / V, [V](double) { return V; }}; };
    const auto motion =
        impose_velocity(friction, {at(slow, distance / 2), at(fast, distance), at(slow, distance)}, 400);
    LineChart chart;
    chart.title = "Fig. 2: response to step changes in velocity, one state variable";
    chart.fixed = "A = 1 N, B = 1.5 N, L = 10 µm; V = 1, 10, 1 mm/s";
    chart.x_label = {"slip", "m"};
    chart.y_label = force_label;
    chart.lines = {{"", motion.slip, motion.force}};
    chart.x_marks = {{"× 10", motion.slip[400]}, {"÷ 10", motion.slip[800]}};
    return line_figure(
        "fig-2", std::move(chart),
        "Each step of velocity moves friction at once in its own direction, by A ln 10 = 2.30 N, and friction "
        "then decays over the slip distance L to the steady curve, B ln 10 = 3.45 N back.",
        "Equations (4)-(6) with the velocity imposed. The three properties of §2 in one picture: direct "
        "effect, steady-state dependence, characteristic slip distance.");
}

Figure oscillating_velocity()
{
    Friction friction = paper_joint().friction;
    std::get<RateAndState>(friction.law).L[0] = 2e-6;
    const double V0 = 1e-3, V1 = 0.8e-3;  // V_0 > V_1: the velocity keeps its sign
    LineChart chart;
    chart.title = "Fig. 3: response to an oscillating velocity, V = V_{0} + V_{1} sin ωt";
    chart.fixed = "V_{0} = 1 mm/s, V_{1} = 0.8 mm/s, A = 1 N, B = 1.5 N, L = 2 µm";
    chart.x_label = velocity_label;
    chart.y_label = force_label;
    for (const double omega : {1.0, 100.0, 400.0}) {
        const double period = 2 * std::numbers::pi / omega;
        const VelocityPiece turn{period, [=](double t) { return V0 + V1 * std::sin(omega * t); }};
        const auto motion = impose_velocity(friction, {turn, turn, turn}, 300);
        LineChart::Line line{"ω = " + plain_number(omega) + " rad/s", {}, {}};
        line.x.assign(motion.velocity.end() - 300, motion.velocity.end());
        line.y.assign(motion.force.end() - 300, motion.force.end());
        chart.lines.push_back(std::move(line));
    }
    LineChart::Line steady{"steady curve (6)", {}, {}, true};
    for (int i = 0; i <= 100; ++i) {
        const double V = V0 - V1 + 2 * V1 * i / 100;
        steady.x.push_back(V);
        steady.y.push_back(steady_force(friction, V));
    }
    chart.lines.push_back(std::move(steady));
    return line_figure(
        "fig-3", std::move(chart),
        "At ω = 1 rad/s friction traces the steady curve; the faster the oscillation, the wider the loop.",
        "Third period. The loop around the steady curve is what Hess and Soom measured on lubricated "
        "contacts, and modelled by a time lag. At still higher ω the direct effect tilts the loop upwards.");
}

}  // namespace

Section friction_figures()
{
    return {
        "friction", "Friction (§2)", "", {kinetic_static(), stribeck(), velocity_steps(), oscillating_velocity()}, {}};
}

}  // namespace stickslip
