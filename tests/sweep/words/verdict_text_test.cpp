// The verdict in words where no single critical gain exists, and where no velocity gain is enough.
#include "sweep/words/verdict_text.h"
#include "sweep/study/open_verdict.h"
#include "sweep/words/open_text.h"
#include "sweep/words/plain_text.h"

#include <catch2/catch.hpp>

#include <cmath>

#include "tests/analysis/joint/sample_joints.h"

using namespace stickslip;

namespace {

bool has(const std::string& text, const char* part)
{
    return text.find(part) != std::string::npos;
}

std::string cell(const Table& table, const std::string& name)
{
    for (const auto& row : table.rows)
        if (row[0] == name) return row[1];
    return "no such row";
}

/// m = 1 kg, a lag of 5 ms on a curve that falls by 100 N·s/m at V_0.
Joint lagged(double k_p)
{
    Joint joint = samples::single_mass(1);
    TimeLag law;
    law.lag = 5e-3;
    // exp(−(V/c_3)) at V = c_3 = 1 mm/s has the slope −c_2/(c_3 e)
    law.curve.law = Stribeck{1, 0, 100 * 1e-3 * std::exp(1.0), 1e-3, 1};
    joint.friction.law = law;
    joint.control.V0 = 1e-3;
    joint.control.k_p = k_p;
    joint.control.k_v = 0;
    return joint;
}

}  // namespace

TEST_CASE("the verdict names the windows of stable gains of a lag", "[report]")
{
    // ωτ = 2πn ± π/2, k_p = mω² + ω|f'| sin ωτ: 130112 … 794017, 2624481 … 4616195 N/m, …
    for (const double k_p : {2e5, 1e6}) {
        const Joint joint = lagged(k_p);
        const auto verdict = linear_verdict(joint);
        const auto text = plain_text(verdict_text(joint, verdict));
        CAPTURE(text);
        CHECK(has(text, k_p == 2e5 ? "one of the stable gains" : "not among the stable gains"));
        CHECK(has(text, "from 130.1 kN/m to 794 kN/m, from 2.624 MN/m to 4.616 MN/m"));
        CHECK(has(text, "searched up to"));
        const auto table = linear_table(joint, verdict);
        CHECK(has(cell(table, "stable k_{p}"), "from 130.1 kN/m to 794 kN/m"));
        // a frequency at a gain that does not exist would mislead
        CHECK(cell(table, "frequency at the critical gain ω") == "no such row");
    }
}

TEST_CASE("the verdict asks for no velocity gain where none is enough", "[report]")
{
    // with friction on the link alone the motor's damping reaches it only through the spring: too little for −500 N·s/m
    Joint joint = samples::two_mass();
    joint.mechanism.transmission.stiffness = 5e5;
    joint.mechanism.transmission.damping = 20;
    joint.mechanism.motor_inertia = 0.2;
    joint.frictions.motor.law = CoulombViscous{2, 10};
    joint.control.k_p = 1e5;
    joint.control.k_v = 50;
    const auto verdict = linear_verdict(joint);
    REQUIRE(verdict.state_variable.stable);
    REQUIRE(std::isnan(verdict.velocity_only.k_v_min));
    const auto text = plain_text(verdict_text(joint, verdict));
    CAPTURE(text);
    CHECK(has(text, "calls it stick-slip at every k_v."));
    CHECK(cell(linear_table(joint, verdict), "k_{v} required by the velocity-only model") == "no k_{v} is enough");
}

TEST_CASE("a joint that slides at every gain is said to", "[report]")
{
    Joint joint = samples::single_mass(1);
    joint.control.V0 = 1e-3;
    joint.control.k_p = 1e4;
    joint.control.k_v = 600;  // above (B − A)/V_0 = 500 N·s/m, (37)
    auto text = plain_text(verdict_text(joint, linear_verdict(joint)));
    CAPTURE(text);
    CHECK(has(text, "Slides smoothly at 1 mm/s for every k_p > 0."));
    // where a large disturbance ends otherwise, that holds of small ones only
    text = plain_text(verdict_text(joint, linear_verdict(joint), TakenOut::by_larger));
    CHECK(has(text, "leads to lasting stick-slip. Small disturbances decay for every k_p > 0."));
    text = plain_text(verdict_text(joint, linear_verdict(joint), TakenOut::by_noise));
    CHECK(has(text,
              "Not smooth: the encoder's steps, noise or forces that change on the way alone bring sliding "
              "at 1 mm/s into a lasting cycle. Small disturbances decay for every k_p > 0."));
    joint.control.k_p = -1e4;
    text = plain_text(verdict_text(joint, linear_verdict(joint)));
    CHECK(has(text, "is not among the stable gains") == false);
    CHECK(has(text, "Every k_p > 0 is stable."));
}

TEST_CASE("gains that no search has found are not called none", "[report]")
{
    Joint joint = samples::single_mass(1);
    joint.control.k_p = 1e4;
    StateVariableVerdict memory;
    CHECK(stable_gains_text(joint, memory) == "none");
    memory.searched_to = 2e4;
    CHECK(stable_gains_text(joint, memory) == "none up to 20 kN/m");
    memory.searched_to = 0;
    CHECK(has(stable_gains_text(joint, memory), "not known"));
    memory.stable_intervals = {{5e3, 5e4}};
    CHECK(stable_gains_text(joint, memory) == "from 5 kN/m to 50 kN/m");
}

TEST_CASE("a gain beside the critical one is told by how much and to which side", "[report]")
{
    Joint joint = samples::single_mass(1);
    joint.control.V0 = 1e-3;
    const double k_cr = linear_verdict(joint).state_variable.k_cr;
    const auto text_at = [&](double k_p) {
        joint.control.k_p = k_p;
        return plain_text(verdict_text(joint, linear_verdict(joint)));
    };
    CHECK(has(text_at(1.0005 * k_cr), " is 0.05 % above the critical gain k_cr = "));
    CHECK(has(text_at(0.9999 * k_cr), " is 0.01 % below the critical gain k_cr = "));
    CHECK(has(text_at(2 * k_cr), " is 2 × the critical gain k_cr = "));
}

TEST_CASE("neutral sliding is called neutral, not stick-slip", "[report]")
{
    Joint joint = samples::single_mass(1);
    joint.friction.law = KineticStatic{10, 15};
    joint.control.V0 = 1e-3;
    auto text = plain_text(verdict_text(joint, linear_verdict(joint)));
    CAPTURE(text);
    CHECK(has(text, "Neutral: small disturbances of sliding at 1 mm/s neither decay nor grow."));
    CHECK(has(text, "no k_p changes that"));
    CHECK_FALSE(has(text, "tick-slip"));
    CHECK_FALSE(has(text, "critical gain"));
    CHECK(cell(linear_table(joint, linear_verdict(joint)), "k_{v} required by the velocity-only model") ==
          "any k_{v} > 0");
    joint.control.k_v = 10;
    joint.control.k_p = 0;
    text = plain_text(verdict_text(joint, linear_verdict(joint)));
    CHECK(has(text, "Nothing brings the position back: k_p = 0."));
    joint.control.k_p = -100;
    text = plain_text(verdict_text(joint, linear_verdict(joint)));
    CHECK(has(text, "Unstable: with k_p < 0"));
}

TEST_CASE("the verdict says where a window of velocity gains ends", "[report]")
{
    // two masses on a spring: a motor that velocity feedback holds fast leaves the link to its falling curve
    Joint joint = samples::two_mass();
    joint.mechanism.transmission.stiffness = 1e6;
    joint.mechanism.transmission.damping = 10;
    joint.frictions.motor.law = CoulombViscous{5, 20};
    joint.control.k_p = 3e5;
    const auto verdict = linear_verdict(joint);
    REQUIRE(verdict.state_variable.stable);
    REQUIRE(verdict.velocity_only.stable_k_v.size() == 1);
    const auto [low, high] = verdict.velocity_only.stable_k_v[0];
    REQUIRE(std::isfinite(high));
    // the other side of either end, by the verdict itself
    for (const double k_v : {0.99 * low, 1.01 * low, 0.99 * high, 1.01 * high}) {
        joint.control.k_v = k_v;
        CHECK(linear_verdict(joint).velocity_only.stable == (k_v > low && k_v < high));
    }
    joint.control.k_v = 0;
    const auto text = plain_text(verdict_text(joint, verdict));
    CAPTURE(text);
    CHECK(has(text, " < k_v < "));
}

TEST_CASE("above the gains of a real loop the verdict speaks of the loop, below of stick-slip", "[report]")
{
    // T = 1 ms, delay 1 ms, k_v 10: stable for 65653 … 738521 N/m
    Joint joint = samples::single_mass(1);
    RateAndState law;
    law.f0 = 60, law.A = 1, law.V_star = 1e-3;
    law.B.push_back(1.5), law.L.push_back(1e-5);
    joint.friction.law = law;
    joint.control.V0 = 1e-3;
    joint.control.k_v = 10;
    joint.control.period = joint.control.delay = 1e-3;
    joint.control.velocity_estimate.form = EstimateForm::backward_difference;
    joint.control.k_p = 6e4;
    CHECK(verdict_text(joint, linear_verdict(joint)).rfind("Stick-slip: ", 0) == 0);
    joint.control.k_p = 8e5;
    const auto above = verdict_text(joint, linear_verdict(joint));
    CHECK(above.rfind("Unstable loop: ", 0) == 0);
    CHECK_FALSE(has(above, "Stick-slip"));
}

TEST_CASE("a simulation that shows the opposite of the linear theory is told first", "[words]")
{
    LinearVerdict linear;
    linear.state_variable.stable = true;
    linear.loop.not_used = {{"control.feed_forward.coulomb_from", WhyNot::fed_back, true}};
    NonlinearVerdict motion;
    motion.region = NonlinearRegion::stick_slip;
    CHECK(contradicted_text(contradicting_terms(linear, motion), true).find("Stick-slip: small disturbances grow") ==
          0);
    motion.region = NonlinearRegion::bistable;
    CHECK(contradicting_terms(linear, motion).empty());
    linear.state_variable.stable = false;
    CHECK(contradicted_text(contradicting_terms(linear, motion), false).find("coulomb_from") != std::string::npos);
    linear.loop.not_used.clear();
    CHECK(contradicting_terms(linear, motion).empty());
}

TEST_CASE("a cycle that moves backwards is not said to stick all that time")
{
    NonlinearVerdict cycle;
    cycle.outcome = Outcome::reversal;
    cycle.amplitude = 0.0155, cycle.period = 0.032, cycle.stick_fraction = 0.4957;
    cycle.velocity_min = -2.99, cycle.velocity_max = 3.1;
    const Joint joint = samples::single_mass(1);
    CHECK(has(cell(nonlinear_table(joint, cycle), "share of the period spent sticking or moving backwards"), "49.6"));
    cycle.velocity_min = 0;
    CHECK(has(cell(nonlinear_table(joint, cycle), "share of the period spent sticking"), "49.6"));
}

TEST_CASE("A joint that is not computed has no empty sets of gains, and says which terms stand together", "[report]")
{
    Joint joint = samples::single_mass(1);
    joint.friction.law = CoulombViscous{3, 0};
    joint.friction.bristle.stiffness = 1e5;
    joint.friction.memory.B = 1, joint.friction.memory.L = 1e-5, joint.friction.memory.V_star = 1e-3;
    joint.control.V0 = 1e-3, joint.control.k_p = 1e4;
    const auto verdict = linear_verdict(joint);
    REQUIRE(verdict.steady.reason == Reason::unsupported);
    CHECK(has(verdict_text(joint, verdict), "friction.bristle with friction.memory is not computed"));
    const auto table = linear_table(joint, verdict);
    CHECK(cell(table, "stable k_{p}") == "no such row");
    CHECK(cell(table, "k_{v} required by the velocity-only model") == "no such row");
}

TEST_CASE("A limit that is too low is told with all that it has to hold", "[report]")
{
    Joint joint = samples::single_mass(1);
    joint.friction.law = CoulombViscous{60, 0};
    joint.control.V0 = 1e-3, joint.control.k_p = 1e4, joint.control.effort_limit = 100;
    joint.load.constant = -200;
    const auto text = verdict_text(joint, linear_verdict(joint));
    CHECK(has(text, "No steady sliding"));
    CHECK(has(text, "constant load"));
}
