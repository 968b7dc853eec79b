// What a report says against the linear chart of the bistable strip.
#include "sweep/report/figures/nonlinear_findings.h"

#include <catch2/catch.hpp>

#include "analysis/simulation/attractor/nonlinear.h"
#include "analysis/stability/verdict.h"
#include "tests/analysis/simulation/joints.h"

using namespace stickslip;

namespace {

Slice strip(double from, double to)
{
    Slice slice;
    slice.x.path = "control.k_p", slice.x.symbol = "k_{p}", slice.x.name = "position gain";
    slice.x.quantity = Quantity::stiffness;
    slice.y.path = "control.k_v", slice.y.symbol = "k_{v}", slice.y.name = "velocity gain";
    slice.y.quantity = Quantity::damping;
    for (int i = 0; i <= 10; ++i) slice.x.values.push_back(from + i * (to - from) / 10);
    slice.y.values = {47, 47.5, 48};
    for (const double k_v : slice.y.values)
        for (const double k_p : slice.x.values) {
            const auto joint = example_joint(k_p, k_v, 1e-2);
            auto row = linear_point(joint);
            write_nonlinear(nonlinear_verdict(joint, {}), row);
            slice.abscissa.push_back(row.spectral_abscissa);
            slice.region.push_back(row.region);
        }
    return slice;
}

}  // namespace

TEST_CASE("findings: share, place and reach of what the linear chart gets wrong", "[report][slow]")
{
    // at k_v = 47.5: k_cr = 19449, fold at 24849 N/m; for the three rows k_cr = (0.5 − c)·1e5·(1 + 10/(1 + c)), c =
    // k_v/100
    const auto slice = strip(15000, 35000);
    const auto found = large_disturbances(example_joint(22000, 47.5, 1e-2), slice);
    CHECK(found.bistable > 0.1);
    CHECK(found.bistable < found.of_linearly_stable);
    REQUIRE(found.folds.size() == 1);
    CHECK(found.reach.ratio > 24849 / 19449.15);  // the reach grows with k_v
    const double k_cr_48 = 0.02e5 * (1 + 10 / 1.48);
    CHECK(found.reach.ratio < 35000 / k_cr_48);
    const auto text = large_disturbances_text(slice, found, Units(Motion::prismatic));
    CHECK(text.find("k_{v} = 47 N·s/m … 48 N·s/m") != std::string::npos);
}

TEST_CASE("findings: nothing to say where both theories agree", "[report][slow]")
{
    const auto slice = strip(40000, 60000);
    const auto found = large_disturbances(example_joint(40000, 47.5, 1e-2), slice);
    CHECK(found.bistable == 0);
    CHECK(found.folds.empty());
    CHECK(large_disturbances_text(slice, found, Units(Motion::prismatic)).empty());
}

TEST_CASE("findings: pages say which share of the points is interpolated, and how far off", "[report]")
{
    using Catch::Matchers::Contains;
    std::vector<MapReading> readings{
        {"limit-cycle amplitude", Quantity::length, {1e-5, 2e-5, 3e-5, 4e-5}, "amplitude"}};
    CHECK_THAT(followed_text(readings), Catch::Matchers::StartsWith("Every point was started"));
    readings.push_back({"interpolation error", Quantity::number, {0, 0, 0, 0}, "interpolation_error"});
    CHECK_THAT(followed_text(readings), Catch::Matchers::StartsWith("Every point was started"));
    readings.back().values = {0, 1e-5, 2e-5, 1.5e-5};
    const auto text = followed_text(readings);
    CHECK_THAT(text, Contains("Of the points 25.0 %") && Contains("75.0 % are interpolated"));
    CHECK_THAT(text, Contains("off by at most 0.002 %"));
}
