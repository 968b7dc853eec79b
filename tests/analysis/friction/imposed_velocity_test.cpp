// Fig. 2 in closed form: at constant velocity the slip law's states decay exponentially with slip.
#include <catch2/catch.hpp>

#include "analysis/friction/imposed_velocity.h"
#include "tests/analysis/friction/sample_laws.h"

using namespace stickslip;

TEST_CASE("a velocity step jumps by A ln(V_1/V_0) and decays over L to the steady curve", "[friction]")
{
    Friction friction;
    friction.law = samples::rate_and_state<RateAndState>({1.0, 0.84}, {1e-5, 2e-4});  // A = 1, V* = 1 mm/s, f0 = 60 N
    const double slow = 1e-4, fast = 3e-3;
    const auto motion =
        impose_velocity(friction, {{1.0, [&](double) { return slow; }}, {0.05, [&](double) { return fast; }}}, 200);
    REQUIRE(motion.force.size() == 400);
    CHECK(motion.force[199] == Approx(60 + (1 - 1.84) * std::log(slow / 1e-3)).epsilon(1e-12));  // (6)
    CHECK(motion.force[200] - motion.force[199] == Approx(std::log(fast / slow)).epsilon(1e-12));
    CHECK(motion.slip[200] == motion.slip[199]);
    for (std::size_t i = 200; i < 400; ++i) {
        const double slip = motion.slip[i] - motion.slip[200], x = std::log(fast / slow);
        const double expected = 60 + (1 - 1.84) * std::log(fast / 1e-3) + 1.0 * x * std::exp(-slip / 1e-5) +
                                0.84 * x * std::exp(-slip / 2e-4);
        CHECK(motion.force[i] == Approx(expected).epsilon(1e-8));
    }
    CHECK(motion.slip.back() == Approx(1.0 * slow + 0.05 * fast).epsilon(1e-12));
}

TEST_CASE("slow oscillations trace the steady curve of every law with states", "[friction][slow]")
{
    for (const auto& sample : samples::laws()) {
        Friction friction;
        friction.law = sample.law;
        if (info(sample.law).needs_history) {
            if (sample.name == "kernel of exponentials") continue;
            CHECK_THROWS_AS(impose_velocity(friction, {{1, [](double) { return 1e-3; }}}, 10), std::invalid_argument);
            continue;
        }
        if (sample.name == "dahl, exponent 1.5" || sample.name == "maxwell-slip") continue;  // saturate, do not decay
        const double period = 2000;
        const auto V = [&](double t) { return 1e-3 + 5e-4 * std::sin(2 * M_PI * t / period); };
        const auto motion = impose_velocity(friction, {{period, V}}, 60);
        CAPTURE(sample.name);
        for (std::size_t i = 0; i < motion.force.size(); ++i)
            CHECK(motion.force[i] == Approx(steady_force(friction, motion.velocity[i])).epsilon(2e-3));
    }
}
