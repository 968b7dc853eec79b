// Stability over a range of normal loads, against the critical gain of one state solved by hand.
#include <catch2/catch.hpp>

#include "analysis/stability/load_study.h"
#include "tests/analysis/simulation/joints.h"

using namespace stickslip;

TEST_CASE("the stable share of a load record ends where the load's critical gain passes the joint's", "[stability]")
{
    const auto k_cr = [](double n) { return (n * 0.5 - 20e-3) / 1e-5 * (1 + 1e-3 / (1e-5 * (20 + n * 1e3))); };
    double low = 0.1, high = 10;
    for (int i = 0; i < 60; ++i) (k_cr(0.5 * (low + high)) < 6e4 ? low : high) = 0.5 * (low + high);
    std::vector<double> loads;
    for (int i = 0; i <= 1000; ++i) loads.push_back(0.5 + 1.5 * i / 1000.0);
    const auto study = load_study(example_joint(6e4, 20, 1e-3), loads);
    CHECK(study.low == 0.5);
    CHECK(study.high == 2);
    CHECK(study.stable_state_variable == Approx((low - 0.5) / 1.5).margin(2e-3));
    CHECK(study.stable_velocity_only == 0);  // needs n (B − A)/V_0 ≥ 250 N·s/m at every load
    CHECK(study.hardest_load == 2);
    CHECK(study.hardest_k_cr == Approx(k_cr(2)).epsilon(1e-9));
    CHECK(study.at.front().k_v_min == Approx(250));
    CHECK(study.at.size() == 101);
}

TEST_CASE("a constant load needs one verdict", "[stability]")
{
    const std::vector<double> loads(10, 1.2);
    const auto study = load_study(example_joint(2e5, 20, 1e-3), loads);
    CHECK(study.at.size() == 1);
    CHECK(study.stable_state_variable == 1);
}
