// The chart of full and reduced boundaries against the closed form of one mass with one state.
#include "sweep/report/figures/reduction_map.h"

#include <catch2/catch.hpp>

#include <cmath>

#include "tests/analysis/joint/sample_joints.h"

using namespace stickslip;

namespace {

/// k_cr = ((B − A − k_v V_0)/L)(1 + m V_0/(L C)), C = k_v + A/V_0, of one state with A = 1, B = 1.5 N, L = 10 µm.
double critical_gain(double m, double k_v, double V0)
{
    return (0.5 - k_v * V0) / 1e-5 * (1 + m * V0 / (1e-5 * (k_v + 1 / V0)));
}

Axis axis(const char* path, double low, double high)
{
    Axis a;
    a.path = path;
    a.quantity = Quantity::stiffness;
    a.log = true;
    for (int i = 0; i <= 30; ++i) a.values.push_back(low * std::pow(high / low, i / 30.0));
    return a;
}

}  // namespace

TEST_CASE("reductions stand beside the full joint in one chart, each with its share of wrong verdicts", "[report]")
{
    Joint joint = samples::two_mass();  // 0.5 and 1 kg, 10 N·s/m between them
    joint.frictions.motor.law = CoulombViscous{1, 0};
    joint.frictions.link.law = RateAndState{};
    auto& law = std::get<RateAndState>(joint.frictions.link.law);
    law.f0 = 60, law.A = 1, law.V_star = 1e-3;
    law.B.push_back(1.5), law.L.push_back(1e-5);
    joint.control.k_v = 100;
    Slice slice;
    slice.x = axis("control.k_p", 1e3, 1e6);
    slice.y = axis("joint.transmission.stiffness", 1e3, 1e8);
    const auto reduced = compare_reductions(joint, slice);
    REQUIRE(reduced);
    const auto figure = reduction_map(slice, *reduced, Units(Motion::prismatic));
    const auto& lines = std::get<LineChart>(figure.picture).lines;
    REQUIRE(lines.size() == 3);
    const double as_source = critical_gain(1, 10, 1e-3), rigid = critical_gain(1.5, 100, 1e-3);
    for (const double y : lines[1].y)
        if (!std::isnan(y)) CHECK(y == Approx(as_source).epsilon(1e-6));
    for (const double x : lines[2].x)
        if (!std::isnan(x)) CHECK(x == Approx(rigid).epsilon(1e-6));
    // the full joint runs from one of them to the other
    double least_x = INFINITY, least_y = INFINITY;
    for (std::size_t i = 0; i < lines[0].x.size(); ++i) {
        if (std::isnan(lines[0].x[i])) continue;
        least_x = std::min(least_x, lines[0].x[i]), least_y = std::min(least_y, lines[0].y[i]);
    }
    CHECK(least_x == Approx(rigid).epsilon(2e-2));
    CHECK(least_y == Approx(as_source).epsilon(0.1));
    CHECK(figure.finding.find("one mass, all rigid") != std::string::npos);
    CHECK_FALSE(compare_reductions(samples::single_mass(1), slice));
}
