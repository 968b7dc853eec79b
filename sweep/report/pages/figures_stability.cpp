// §4 and §5 of the paper as charts.
#include "analysis/results/text.h"
#include "sweep/report/figures/line_figure.h"
#include "sweep/report/figures/loop_figures.h"
#include "sweep/report/figures/map_figures.h"
#include "sweep/report/pages/figures_report.h"

namespace stickslip {
namespace {

constexpr Units prismatic(Motion::prismatic);

Figure regions(const PaperStability& s)
{
    auto map = stability_map(prismatic, s.regions, s.boundaries);
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

Figure crossing_condition(const PaperStability& s)
{
    LineChart chart;
    chart.title = "The frequency at the critical gain, (34)";
    chart.x_label = axis_label("frequency ω", Quantity::angular_frequency, prismatic);
    chart.y_label = axis_label("∫ g cos ωt dt", Quantity::damping, prismatic);
    chart.lines = {{"∫ g cos ωt dt", s.kernel.x, s.kernel.y}};
    for (const double k_v : {0.0, 250.0, 500.0})
        chart.lines.push_back({"k_{v} + f_{v}, k_{v} = " + with_unit(k_v, Quantity::damping, prismatic),
                               {0, 300},
                               {k_v + s.f_v, k_v + s.f_v},
                               true});
    const double at = s.crossing_omega;
    chart.x_marks = {{"ω = " + with_unit(at, Quantity::angular_frequency, prismatic, 4), at}};
    return line_figure("crossing", std::move(chart),
                       "At k_{v} = 0 the lines meet at " + with_unit(at, Quantity::angular_frequency, prismatic, 4) +
                           "; from k_{v} = 500 N·s/m on they meet nowhere: every k_{p} is stable.",
                       "Solutions of (34) for three velocity gains: the two sides of the equation over ω.");
}

Figure locus(const PaperStability& s)
{
    Figure figure = loop_figures(s.locus, prismatic).front();
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
Figure armstrong(const PaperStability& s)
{
    LineChart chart;
    chart.title = "Damping that each theory requires as velocity goes to zero (§5)";
    chart.fixed = "Stribeck: c_{2} = 2 N, c_{3} = 5 mm/s; memory: A = 1 N, B = 1.5 N, L = 10 µm";
    chart.x_label = axis_label("velocity V_{0}", Quantity::velocity, prismatic);
    chart.y_label = axis_label("least k_{v}", Quantity::damping, prismatic);
    chart.x_log = chart.y_log = true;
    chart.lines = {{"velocity-only model, (22)-(23)", s.gauss.x, s.gauss.y, true},
                   {"velocity-only model, slope of (6)", s.logarithm.x, s.logarithm.y, true},
                   {"with memory, k_{p} = 20 kN/m", s.soft.x, s.soft.y},
                   {"with memory, k_{p} = 52 kN/m", s.stiff.x, s.stiff.y}};
    return line_figure(
        "armstrong", std::move(chart),
        "By (22) the required damping falls with velocity, by (6) it grows as (B − A)/V_{0}; with memory a "
        "stiff spring needs less, and at the lowest velocities none.",
        "Armstrong found stick-slip in the falling range except at the very lowest velocities, reached with "
        "the stiffest springs, with far less damping there than (22) with his parameters requires.");
}

/// §5: ramps of force through springs.
Figure ramps(const PaperStability& s)
{
    LineChart chart;
    chart.title = "Stable springs under a ramp of force (§5)";
    chart.fixed = "k_{v} = 0, V_{0} = r/k_{p}";
    chart.x_label = axis_label("rate of force r", Quantity::effort_rate, prismatic);
    chart.y_label = axis_label("critical stiffness", Quantity::stiffness, prismatic);
    chart.x_log = chart.y_log = true;
    chart.lines = {{"critical stiffness: stable above", s.critical_spring.x, s.critical_spring.y}};
    for (const double V : {1e-5, 1e-3, 1e-1}) {
        LineChart::Line line{"V_{0} = " + with_unit(V, Quantity::velocity, prismatic), {}, {}, true};
        for (const double rate : s.critical_spring.x) {
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

Section stability_figures(const PaperStability& s)
{
    return {"stability",
            "Stability and its implications (§4, §5)",
            "Position control (9) and force control (10) have the same linear equation, so each chart is about both.",
            {regions(s), crossing_condition(s), locus(s), armstrong(s), ramps(s)},
            {}};
}

}  // namespace stickslip
