// An integral whose limit is below what it would have to hold in steady sliding stands there, and acts on nothing.
#include "analysis/simulation/attractor/nonlinear.h"
#include "analysis/stability/integral_cost.h"
#include "analysis/stability/verdict.h"
#include "tests/analysis/simulation/joints.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace stickslip;

namespace {

bool told(const LoopUse& loop, const char* key)
{
    return std::any_of(loop.not_used.begin(), loop.not_used.end(),
                       [&](const UnusedTerm& t) { return t.key == key && t.why == WhyNot::small_signal; });
}

Joint limited(double limit)
{
    Joint joint = example_joint(80e3, 10, 1e-3);
    joint.control.k_i = 1e7;
    joint.control.integral_limit = limit;
    return joint;
}

}  // namespace

TEST_CASE("An integral at its limit moves no root", "[loop]")
{
    // the critical gains with k_i = 1e7 N/(m·s) and without
    const auto free = linear_verdict(limited(61)), stopped = linear_verdict(limited(10));
    CHECK_FALSE(free.state_variable.stable);
    CHECK(free.state_variable.k_cr == Approx(119363.430440));
    CHECK(stopped.state_variable.stable);
    CHECK(stopped.state_variable.k_cr == Approx(53851.485149));
    CHECK(told(stopped.loop, "control.k_i"));
    CHECK_FALSE(told(free.loop, "control.k_i"));
    const auto& used = stopped.loop.used;
    CHECK(std::find(used.begin(), used.end(), "control.k_i") == used.end());
    CHECK(growth_rate(limited(10)) == Approx(stopped.state_variable.spectral_abscissa));
    CHECK(linear_point(limited(10)).state_variable_stable == 1);
    CHECK_FALSE(integral_cost(limited(10), stopped));
}

TEST_CASE("A loop whose integral stands at its limit slides as its simulation does", "[loop]")
{
    for (const double period : {missing, 5e-4}) {
        Joint joint = limited(10);
        joint.control.period = period;
        joint.control.velocity_estimate.form = EstimateForm::backward_difference;
        const auto motion = nonlinear_verdict(joint, {});
        INFO("period " << period);
        CHECK(motion.region == NonlinearRegion::stable);
        CHECK(motion.growth_rate == Approx(growth_rate(joint)).epsilon(1e-4));
        joint.control.k_p = 50e3;
        CHECK(nonlinear_verdict(joint, {}).region == NonlinearRegion::stick_slip);
    }
}

TEST_CASE("A push by the reference leaves the integral less to hold", "[loop]")
{
    Joint joint = limited(10);
    joint.control.feed_forward.coulomb = 55;
    joint.control.feed_forward.coulomb_speed = 1e-6;
    CHECK(linear_verdict(joint).state_variable.k_cr == Approx(119363.430440));
}

TEST_CASE("A cascade whose integral stands at its limit is its gains without it", "[loop]")
{
    Joint joint = limited(10);
    auto& c = joint.control;
    c.structure = Structure::cascade;
    c.position_gain = 900, c.velocity_gain = 100, c.velocity_integral_gain = 2e4;
    Joint plain = example_joint(90e3, 100, 1e-3);
    CHECK(growth_rate(joint) == Approx(growth_rate(plain)));
    CHECK(nonlinear_verdict(joint, {}).growth_rate == Approx(growth_rate(plain)).epsilon(1e-3));
}

TEST_CASE("The price of an integral counts a gain that may fall like one that may grow", "[loop]")
{
    // k_cr of the ideal loop is 53851 N/m, and 70076 N/m with k_i = 1e6 N/(m·s): both below the gain
    Joint joint = example_joint(2 * 53851.485149, 10, 1e-3);
    joint.control.k_i = 1e6;
    const auto cost = integral_cost(joint, linear_verdict(joint));
    REQUIRE(cost);
    const double with = joint.control.k_p / 70075.894106;
    CHECK(cost->without == Approx(1));
    CHECK(cost->with == Approx(with - 1));
    CHECK(cost->share() == Approx(1 - std::log(with) / std::log(2)));
}
