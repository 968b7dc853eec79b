// §4 and §5 of the paper as charts.
#include "analysis/results/text.h"
#include "analysis/stability/comparison.h"
#include "analysis/stability/joint_spectrum.h"
#include "analysis/stability/resolution.h"
#include "analysis/stability/steady.h"
#include "sweep/report/figures/loop_figures.h"
#include "sweep/report/figures/map_figures.h"
#include "sweep/report/pages/figures_report.h"
#include "sweep/study/map_answer.h"
#include "sweep/study/maps.h"
#include "sweep/words/line_figure.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

constexpr Units prismatic(Motion::prismatic);

Figure regions()
{
    Joint joint = paper_joint();
    Slice slice;
    slice.x = {"control.k_p", "k_{p}", "position gain", Quantity::stiffness, true, log_steps(1e3, 1e6, 121)};
    slice.y = {"control.k_v", "k_{v}", "velocity gain", Quantity::damping, false, {}};
    for (int i = 0; i <= 120; ++i) slice.y.values.push_back(7.5 * i);
    for (const double k_v : slice.y.values)
        for (const double k_p : slice.x.values) {
            joint.control.k_p = k_p;
            joint.control.k_v = k_v;
            const auto point = linear_point(joint);
            slice.abscissa.push_back(point.spectral_abscissa);
            slice.region.push_back(point.region);
        }
    MapAnswer answer;
    constexpr int mesh = 96;
    answer.curves = chart_boundaries(paper_joint(), slice.x, slice.y, mesh);
    auto map = stability_map(prismatic, slice, answer);
    map.title = "Regions of stability (§4)";
    map.has_design = false;
    map.command.clear();  // no joint file lies beside this page
    Figure figure;
    figure.id = "regions";
    figure.finding =
        "The velocity-only model requires k_{v} > 500 N·s/m at every k_{p}; with memory a k_{p} above k_{cr}, 55 kN/m "
        "at k_{v} = 0, is enough, and k_{cr} falls as k_{v} grows.";
    figure.caption = figure.finding +
                     " Dashed: (21). Solid: (34)-(35). Hatched: stable only with memory, the second regime of stable "
                     "low-velocity motion. Blue decays, red grows.";
    figure.picture = std::move(map);
    return figure;
}

Figure crossing_condition()
{
    const Joint joint = paper_joint();
    const auto linear = linear_joint(joint, commanded_velocity(joint));
    LineChart chart;
    chart.title = "The frequency at the critical gain, (34)";
    chart.x_label = axis_label("frequency ω", Quantity::angular_frequency, prismatic);
    chart.y_label = axis_label("∫ g cos ωt dt", Quantity::damping, prismatic);
    LineChart::Line integral{"∫ g cos ωt dt", {}, {}};
    for (int i = 0; i <= 300; ++i) {
        integral.x.push_back(i);
        integral.y.push_back(transfer(linear.friction[0], {0, double(i)}).real());
    }
    chart.lines = {std::move(integral)};
    for (const double k_v : {0.0, 250.0, 500.0})
        chart.lines.push_back({"k_{v} + f_{v}, k_{v} = " + with_unit(k_v, Quantity::damping, prismatic),
                               {0, 300},
                               {k_v + linear.friction[0].f_v, k_v + linear.friction[0].f_v},
                               true});
    const auto at = linear_verdict(joint).state_variable.crossings.at(0).omega;
    chart.x_marks = {{"ω = " + with_unit(at, Quantity::angular_frequency, prismatic, 4), at}};
    return line_figure("crossing", std::move(chart),
                       "At k_{v} = 0 the lines meet at " + with_unit(at, Quantity::angular_frequency, prismatic, 4) +
                           "; from k_{v} = 500 N·s/m on they meet nowhere: every k_{p} is stable.",
                       "Solutions of (34) for three velocity gains: the two sides of the equation over ω.");
}

Figure locus()
{
    Figure figure = loop_figures(sampled_root_locus(paper_joint(), 1e3, 1e7), prismatic).front();
    std::get<DetailedChart>(figure.picture).title = "Root locus over k_{p} at k_{v} = 0 (§4)";
    figure.finding =
        "As k_{p} grows, two real growing roots meet, turn into a pair and cross the imaginary axis at "
        "± 70.7 i rad/s, where k_{p} = k_{cr} = 55 kN/m.";
    figure.caption = figure.finding +
                     " Roots of (27) for k_{p} from 1 kN/m to 10 MN/m, split by whether the joint is stable at their "
                     "k_{p}; those that decay too fast to matter lie outside the picture.";
    return figure;
}

/// §5: the damping that each theory asks of Armstrong's joint as velocity goes to zero.
Figure armstrong()
{
    Joint joint = paper_joint();
    Friction curve;
    curve.law = Stribeck{58, 0, 2, 5e-3, 2};
    LineChart chart;
    chart.title = "Damping that each theory requires as velocity goes to zero (§5)";
    chart.fixed = "Stribeck: c_{2} = 2 N, c_{3} = 5 mm/s; memory: A = 1 N, B = 1.5 N, L = 10 µm";
    chart.x_label = axis_label("velocity V_{0}", Quantity::velocity, prismatic);
    chart.y_label = axis_label("least k_{v}", Quantity::damping, prismatic);
    chart.x_log = chart.y_log = true;
    LineChart::Line gauss{"velocity-only model, (22)-(23)", {}, {}, true},
        logarithm{"velocity-only model, slope of (6)", {}, {}, true}, soft{"with memory, k_{p} = 20 kN/m", {}, {}},
        stiff{"with memory, k_{p} = 52 kN/m", {}, {}};
    constexpr double least_shown = 0.1;  // N·s/m
    for (const double V : log_steps(1e-5, 1e-1, 161)) {
        joint.control.V0 = V;
        const auto add = [&](LineChart::Line& line, double k_v) {
            line.x.push_back(V);
            line.y.push_back(k_v > least_shown ? k_v : missing);
        };
        add(gauss, -steady_slope(linearise(curve, V)));
        add(logarithm, -steady_slope(linearise(joint.friction, V)));
        for (auto* line : {&soft, &stiff}) {
            joint.control.k_p = line == &soft ? 2e4 : 5.2e4;
            add(*line, compare_theories(joint).k_v_demanded_memory());
        }
    }
    const auto shown = [](double k_v) { return k_v > least_shown ? k_v : missing; };
    smooth(gauss, [&](double V) { return shown(-steady_slope(linearise(curve, V))); });
    joint.control.k_p = 5.2e4;
    smooth(stiff, [&](double V) {
        joint.control.V0 = V;
        return shown(compare_theories(joint).k_v_demanded_memory());
    });
    chart.lines = {std::move(gauss), std::move(logarithm), std::move(soft), std::move(stiff)};
    return line_figure(
        "armstrong", std::move(chart),
        "By (22) the required damping falls with velocity, by (6) it grows as (B − A)/V_{0}; with memory a "
        "stiff spring needs less, and at the lowest velocities none.",
        "Armstrong found stick-slip in the falling range except at the very lowest velocities, reached with "
        "the stiffest springs, with far less damping there than (22) with his parameters requires.");
}

/// §5: ramps of force through springs.
Figure ramps()
{
    Joint joint = paper_joint();
    joint.control.kind = ControlKind::force;
    LineChart chart;
    chart.title = "Stable springs under a ramp of force (§5)";
    chart.fixed = "k_{v} = 0, V_{0} = r/k_{p}";
    chart.x_label = axis_label("rate of force r", Quantity::effort_rate, prismatic);
    chart.y_label = axis_label("critical stiffness", Quantity::stiffness, prismatic);
    chart.x_log = chart.y_log = true;
    LineChart::Line critical{"critical stiffness: stable above", {}, {}};
    for (const double rate : log_steps(0.1, 1e4, 101)) {
        const auto stable = stable_springs(joint, rate, 1e3, 1e7, Theory::state_variable);
        critical.x.push_back(rate);
        critical.y.push_back(stable.empty() ? missing : stable.front().low);
    }
    chart.lines.push_back(std::move(critical));
    for (const double V : {1e-5, 1e-3, 1e-1}) {
        LineChart::Line line{"V_{0} = " + with_unit(V, Quantity::velocity, prismatic), {}, {}, true};
        for (const double rate : log_steps(0.1, 1e4, 101)) {
            const double k = rate / V;
            line.x.push_back(rate);
            line.y.push_back(k >= 2e4 && k <= 1e6 ? k : missing);
        }
        chart.lines.push_back(std::move(line));
    }
    return line_figure(
        "ramps-of-force", std::move(chart),
        "Along one ramp, a stiffer spring slides slower and, above the critical stiffness, smoothly.",
        "Force control (10): the force ramps at r through the spring k_{p}. The velocity-only model finds no stable "
        "spring for this friction at k_{v} = 0.");
}

}  // namespace

Section stability_figures()
{
    return {"stability",
            "Stability and its implications (§4, §5)",
            "Position control (9) and force control (10) have the same linear equation, so each chart is about both.",
            {regions(), crossing_condition(), locus(), armstrong(), ramps()},
            {}};
}

}  // namespace stickslip
