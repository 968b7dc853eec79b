#include "tests/render/example_report.h"

#include <cmath>

#include "analysis/results/text.h"

namespace stickslip::example {
namespace {

constexpr double m = 1, A = 1, B = 1.5, L = 1e-5, V0 = 1e-3;

std::vector<double> log_values(double from, double to, std::size_t points)
{
    std::vector<double> values;
    for (std::size_t i = 0; i < points; ++i)
        values.push_back(from * std::pow(to / from, static_cast<double>(i) / static_cast<double>(points - 1)));
    return values;
}

/// Largest real part of m s³ + (mV/L + C) s² + (CV/L − BV⁰/L + k_p) s + k_p V/L = 0 with C = k_v + A/V, by bisection on
/// the real root and the quadratic that is left: the linearised joint of Dupont (27) for the slip law.
double abscissa(double k_p, double k_v)
{
    const double C = k_v + A / V0, rate = V0 / L;
    const double b = rate + C / m, c = (C * rate - B / L + k_p) / m, d = k_p * rate / m;
    const auto p = [&](double s) { return ((s + b) * s + c) * s + d; };
    double low = -1e7, high = 0;  // p(low) < 0 < p(0) = d
    for (int i = 0; i < 200; ++i) (p((low + high) / 2) < 0 ? low : high) = (low + high) / 2;
    const double real = (low + high) / 2, sum = b + real, product = c + real * sum;
    const double discriminant = sum * sum / 4 - product;
    const double pair = discriminant < 0 ? -sum / 2 : -sum / 2 + std::sqrt(discriminant);
    return std::max(real, pair);
}

}  // namespace

double critical_gain(double k_v, double velocity)
{
    const double C = k_v + A / velocity;
    if (B <= C * velocity) return NAN;
    return (B - A - k_v * velocity) / L * (1 + m * velocity / (L * C));
}

StabilityMap map(std::size_t columns, std::size_t rows)
{
    StabilityMap map;
    map.title = "Stability of steady sliding over (k_{p}, k_{v})";
    map.fixed = "m = 1 kg, one-state friction A = 1 N, B = 1.5 N, L = 10 µm, V_{0} = 1 mm/s, position control";
    map.x = {"control.k_p", "k_{p}", "position gain", Quantity::stiffness, true, log_values(1e3, 1e6, columns)};
    map.y = {"control.k_v", "k_{v}", "velocity gain", Quantity::damping, true, log_values(1, 1e3, rows)};
    const double k_v_least = (B - A) / V0;
    std::size_t differing = 0;
    for (const double k_v : map.y.values)
        for (const double k_p : map.x.values) {
            const double s = abscissa(k_p, k_v);
            const bool memory = s<0, velocity_only = k_v> k_v_least;
            map.abscissa.push_back(s);
            map.region.push_back(memory          ? velocity_only ? Region::stable : Region::memory_only
                                 : velocity_only ? Region::velocity_only
                                                 : Region::unstable);
            differing += memory != velocity_only;
        }
    map.disagreement = static_cast<double>(differing) / static_cast<double>(map.abscissa.size());
    Curve limit{Curve::Kind::state_variable, {}, {}, 1e-12};
    for (const double k_v : log_values(1, 499.99, 300)) {
        limit.x.push_back(critical_gain(k_v, V0));
        limit.y.push_back(k_v);
    }
    map.curves = {{Curve::Kind::velocity_only, {1e3, 1e6}, {k_v_least, k_v_least}, 1e-12}, limit};
    map.design = {1e5, 20, true, Region::memory_only, abscissa(1e5, 20)};
    map.has_design = true;
    return map;
}

CriticalGainSurface surface()
{
    CriticalGainSurface s;
    s.title = "Critical position gain k_{cr} over velocity gain and sliding velocity";
    s.fixed = "m = 1 kg, one-state friction A = 1 N, B = 1.5 N, L = 10 µm";
    s.x = {"control.k_v", "k_{v}", "velocity gain", Quantity::damping, true, log_values(1, 1e3, 60)};
    s.y = {"control.V0", "V_{0}", "sliding velocity", Quantity::velocity, true, log_values(1e-5, 1e-2, 50)};
    s.z_name = "critical gain";
    s.z_symbol = "k_{cr}";
    for (const double velocity : s.y.values)
        for (const double k_v : s.x.values) s.z.push_back(critical_gain(k_v, velocity));
    return s;
}

LineChart lines()
{
    LineChart chart;
    chart.title = "Critical position gain against sliding velocity";
    chart.fixed = "m = 1 kg, one-state friction A = 1 N, B = 1.5 N, L = 10 µm";
    chart.x_label = {"sliding velocity V_{0}", "m/s"};
    chart.y_label = {"critical gain k_{cr}", "N/m"};
    chart.x_log = chart.y_log = true;
    for (const double k_v : {0.0, 50.0, 200.0}) {
        LineChart::Line line{
            "k_{v} = " + with_unit(k_v, Quantity::damping, Units(Motion::prismatic)), {}, {}, k_v > 100};
        for (const double v : log_values(1e-5, 1e-1, 400)) {
            line.x.push_back(v);
            line.y.push_back(critical_gain(k_v, v));
        }
        chart.lines.push_back(line);
    }
    chart.x_marks = {{"V_{0} of the map", V0}};
    return chart;
}

Report report()
{
    Report r;
    r.title = "Stick-slip report: reference joint over (k_{p}, k_{v})";
    r.subtitle = "single mass, one-state rate-and-state friction, position control, 120 × 80 points";
    r.verdict = "The design slides smoothly, although velocity-only theory forbids it.";
    r.tone = Headline::Tone::good;
    const double k_cr = critical_gain(20, V0);
    r.headlines = {
        {Headline::Tone::good, "× " + plain_number(1e5 / k_cr),
         "k_{p} above the critical gain k_{cr} = " + with_unit(k_cr, Quantity::stiffness, Units(Motion::prismatic))},
        {Headline::Tone::neutral, percent(map(60, 40).disagreement), "of the chart: the two theories disagree"},
        {Headline::Tone::warning, "500 N·s/m", "k_{v} that velocity-only theory would ask for"},
        {Headline::Tone::bad, "− 45 %", "k_{p} may fall before stick-slip begins"}};
    r.alerts = {
        {Headline::Tone::warning, "The chart is linear: a disturbance larger than the one watched may end elsewhere."}};
    Section maps{"map",
                 "Stability map",
                 "Blue decays, red grows; the hatched gold region is the paper's second regime.",
                 {},
                 {}};
    const std::string finding =
        "Stability map over position and velocity gain: a large region right of the critical gain is smooth only when "
        "friction has memory; velocity-only theory asks for a velocity gain above 500 N·s/m everywhere.";
    maps.figures.push_back({"stability-map", map(120, 80),
                            "Spectral abscissa of the linearised joint. Solid: boundary with "
                            "frictional memory, Dupont (35). Dashed: velocity-only boundary, Dupont (21).",
                            finding});
    StabilityMap second = map(120, 80);
    second.title = "The same with undecided, bistable and velocity-only regions";
    for (std::size_t j = 0; j < 80; ++j)
        for (std::size_t i = 0; i < 120; ++i) {
            const std::size_t k = j * 120 + i;
            if (i > 95 && j < 14) {
                second.region[k] = Region::undecided;
                second.abscissa[k] = NAN;
            }
            if (i > 70 && i < 80 && j < 60) second.region[k] = Region::bistable;
            if (i < 25 && j > 60 && j < 75) second.region[k] = Region::velocity_only;
        }
    second.undecided = 24.0 * 14 / 9600;
    second.curves.push_back({Curve::Kind::fold, {1.3e5, 1.4e5, 1.6e5}, {1, 30, 200}, 1e-6});
    second.design.inside = false;
    second.design.x = 3e6;
    maps.figures.push_back({"all-regions", second, "Every texture at once.", "All textures."});
    r.sections.push_back(maps);
    Section gains{"critical-gain", "Critical gain k_{cr}", "", {}, {}};
    gains.figures.push_back({"surface", surface(),
                             "Critical gain in space; no critical gain exists where k_{v} V_{0} > B − A.",
                             "The critical gain falls with velocity gain and rises with velocity."});
    gains.figures.push_back({"cuts", lines(), "Cuts through the surface.", "Three falling and rising curves."});
    gains.tables.push_back(
        {"Critical gains", {"V_{0}", "k_{v}", "k_{cr}"}, {{"1 mm/s", "0", "55 kN/m"}, {"10 mm/s", "0", "550 kN/m"}}});
    r.sections.push_back(gains);
    r.not_checked = {"backlash and actuator limits", "velocities other than V_{0} = 1 mm/s"};
    r.provenance = {
        {"version", "0.1.0"}, {"spec hash", "0123456789abcdef"}, {"command", "stickslip sweep spec.toml --seed 1"}};
    return r;
}

}  // namespace stickslip::example
