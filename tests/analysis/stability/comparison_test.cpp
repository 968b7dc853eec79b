// What each theory demands, against closed forms.
#include <catch2/catch.hpp>

#include "analysis/stability/comparison.h"
#include "analysis/stability/joint_spectrum.h"
#include "analysis/stability/reduction_study.h"
#include "tests/analysis/joint/sample_joints.h"

using namespace stickslip;

TEST_CASE("velocity-only asks for k_v whatever the spring, memory for less with a stiffer one", "[stability]")
{
    Joint joint = samples::single_mass(1);  // A = 1, B = 1.5, L = 1e-5, V_0 = 1e-3
    joint.control.k_p = 3e4;
    const auto both = compare_theories(joint);
    CHECK(both.k_v_demanded_velocity_only() == Approx(500));  // (B − A)/V_0
    // memory: k_cr(k_v) = 30000, with ((0.5 − 1e-3 k)/1e-5)(1 + 100/(k + 1000)) = 30000 solved for k by hand:
    // (500 − k)(k + 1100) = 300 (k + 1000)  ⇒  k² + 900 k − 250000 = 0
    CHECK(both.k_v_demanded_memory() == Approx((-900 + std::sqrt(900.0 * 900 + 4 * 250000)) / 2).epsilon(1e-9));
    CHECK(both.k_p_velocity_only.empty());
    REQUIRE(both.forbidden_needlessly.size() == 1);
    CHECK(both.forbidden_needlessly[0].low == Approx(55000));
    CHECK(both.forbidden_needlessly[0].high == infinity);
    CHECK(both.allowed_wrongly.empty());
}

TEST_CASE("windows of k_v and k_p end where the spectrum of either theory turns, for several masses, too",
          "[stability]")
{
    // two masses, the link fed back: a spring between sensor and motor bounds the gains from above
    Joint joint = samples::two_mass();
    auto& m = joint.mechanism;
    m.motor_inertia = 10, m.link_inertia = 1;
    m.transmission = {.stiffness = 1e5};
    joint.frictions.motor.law = CoulombViscous{1, 10};
    RateAndState link;
    link.f0 = 60, link.A = 1, link.V_star = 1e-3;
    link.B.push_back(0.9), link.L.push_back(1e-5);
    joint.frictions.link.law = link;
    joint.control.kind = ControlKind::position;
    joint.control.feedback = Feedback::link;
    joint.control.k_p = 1.26e5, joint.control.k_v = 300, joint.control.V0 = 1e-4;
    const auto turns = [&](const std::vector<Interval>& windows, double& gain, bool memory) {
        const double own = gain;
        for (const auto& window : windows)
            for (const double end : {window.low, window.high}) {
                if (end == 0 || end == infinity) continue;
                for (const double side : {-1e-6, 1e-6}) {
                    gain = end * (1 + side);
                    const auto linear = linear_joint(joint, joint.control.V0);
                    const double growth = spectral_abscissa(memory ? linear : velocity_only(linear));
                    CHECK((growth < 0) == ((side > 0) == (end == window.low)));
                }
            }
        gain = own;
    };
    const auto both = compare_theories(joint);
    turns(both.k_p_memory, joint.control.k_p, true);
    turns(both.k_p_velocity_only, joint.control.k_p, false);
    // a gain that velocity-only allows and memory forbids, although f_v > 0 and g ≥ 0
    REQUIRE(both.allowed_wrongly.size() == 1);
    CHECK(both.allowed_wrongly[0].low == both.k_p_memory.back().high);
    CHECK(both.allowed_wrongly[0].high == both.k_p_velocity_only.back().high);
    CHECK(both.allowed_wrongly[0].low < joint.control.k_p);
    CHECK(joint.control.k_p < both.allowed_wrongly[0].high);

    joint.control.k_p = 5e4;
    const auto softer = compare_theories(joint);
    turns(softer.k_v_memory, joint.control.k_v, true);
    turns(softer.k_v_velocity_only, joint.control.k_v, false);
    for (const auto* windows : {&softer.k_v_memory, &softer.k_v_velocity_only}) {
        REQUIRE(windows->size() == 1);
        CHECK(std::isfinite(windows->front().high));
    }
}

TEST_CASE("a lag and LuGre forbid what velocity-only allows", "[stability]")
{
    // this LuGre, by its closed form: f_v = −73.185, steady slope −428.482: at k_v = 400 memory asks for k_p > 1801.88
    Joint joint = samples::single_mass(1);
    joint.friction.law = LuGre{1e5, std::sqrt(1e5), 0.4, 1, 1.5, 1e-3};
    joint.control.V0 = 1e-3 / std::sqrt(2.0);
    joint.control.k_v = 400;
    CHECK(compare_theories(joint).k_p_memory.at(0).low == Approx(1801.88).epsilon(1e-5));
    // a lag of 5 ms on a falling curve: k_p = mω² + ω|f'| sin ωτ and k_v = |f'| cos ωτ at the boundary, |f'| = 14.07…
    const Stribeck curve{10, 0, 1, 1e-2, 2};
    joint.friction.law = samples::time_lag(curve, 5e-3);
    const double slope = 2 * joint.control.V0 / 1e-4 * std::exp(-0.005);  // (23)
    double low = 0, high = 200;
    while (high - low > 1e-12 * high) {
        const double w = (low + high) / 2;
        (w * w + w * slope * std::sin(w * 5e-3) < joint.control.k_p ? low : high) = w;
    }
    CHECK(compare_theories(joint).k_v_demanded_memory() == Approx(slope * std::cos(low * 5e-3)).epsilon(1e-5));
    // on a rising curve velocity-only allows every k_p; with a lag some are forbidden
    joint.control.k_v = 0;
    joint.friction.law = samples::time_lag(CoulombViscous{1, 50});
    const auto rising = compare_theories(joint);
    REQUIRE(rising.k_p_velocity_only.size() == 1);
    CHECK(!rising.allowed_wrongly.empty());
    for (const auto& wrong : rising.allowed_wrongly)
        for (const auto& right : rising.k_p_memory) CHECK((wrong.high <= right.low || wrong.low >= right.high));
}

TEST_CASE("the optimal mix of gains lies where the boundary touches a circle of equal noise", "[stability]")
{
    Joint joint = samples::single_mass(1);
    const auto k_cr = [](double k) { return (0.5 - 1e-3 * k) / 1e-5 * (1 + 100 / (k + 1000)); };
    CHECK(least_position_gain(joint) == Approx(55000));
    for (const double ratio : {50.0, 100.0, 300.0}) {
        const auto mix = optimal_mix(joint, ratio);
        // least of k_cr² + ρ² k² over a fine grid
        double best = infinity;
        for (double k = 0; k < 500; k += 0.01) best = std::min(best, std::hypot(k_cr(k), ratio * k));
        CHECK(mix.noise == Approx(best).epsilon(1e-7));
        CHECK(mix.k_p == Approx(k_cr(mix.k_v)).epsilon(1e-9));
    }
    // cheap velocity: no position gain is needed; costly velocity: position alone
    CHECK(optimal_mix(joint, 1e-3).k_p < 1);
    CHECK(optimal_mix(joint, 1e6).k_v < 1e-3 * 500);
}

TEST_CASE("each reduction holds where its assumption does", "[stability]")
{
    // position control, friction on the link alone: quasi-statically loop and transmission are in series,
    // 1/k_p + 1/k_tr = 1/k_cr; the ideal motor says k_tr = k_cr. Light bodies make it so.
    auto joint = samples::two_mass();
    joint.mechanism.motor_inertia = joint.mechanism.link_inertia = 1e-6;
    joint.mechanism.transmission.damping = 0;
    joint.mechanism.transmission.stiffness = 1e5;
    joint.frictions.motor.law = CoulombViscous{0, 0};
    joint.control.k_p = 1e7;
    const auto studies = reduction_studies(joint);
    REQUIRE(studies.size() == 2);
    const auto& ideal = studies[0];
    CHECK(ideal.refused.empty());
    CHECK(ideal.boundary_path == "joint.transmission.stiffness");
    REQUIRE(ideal.own.full.size() == 1);
    CHECK(ideal.own.reduced.at(0) == Approx(5e4).epsilon(1e-4));
    CHECK(ideal.own.full[0] == Approx(5e4 / (1 - 5e4 / 1e7)).epsilon(1e-4));
    // the error k_cr/k_p falls below 1 % at k_p = 100 k_cr, below 10 % at 10 k_cr; steps of 4 decades/32
    CHECK(ideal.good_from == Approx(5e6).epsilon(0.35));
    CHECK(ideal.fair_from == Approx(5e5).epsilon(0.35));
    // rigid transmission: k_p = k_cr k_tr/(k_tr − k_cr), 1 % at k_tr = 100 k_cr
    CHECK(studies[1].good_from == Approx(5e6).epsilon(0.35));
    // frictions without a single law act side by side on one body; two that remember by delays have no room there
    auto three = samples::nine_states();
    TimeLag delayed;
    delayed.lag = 1e-3;
    delayed.curve.law = CoulombViscous{1, 0};
    three.frictions.transmission.law = three.frictions.motor.law = delayed;
    CHECK_THROWS_AS(three_mass_to_two_mass(three, Placement::at_motor), std::invalid_argument);
    StudyOptions coarse;
    coarse.values = 3;
    for (const auto& study : reduction_studies(samples::nine_states(), coarse)) CHECK(study.refused.empty());
    CHECK(reduction_studies(samples::single_mass(1)).empty());
}

TEST_CASE("a reduction that compares no boundaries has no error", "[stability]")
{
    // rate-and-state friction with k_v above (B − A)/V_0 on every body: no boundary in k_p at all, on either side
    auto joint = samples::two_mass();
    joint.frictions.motor.law = CoulombViscous{1, 2000};
    joint.frictions.link.law = CoulombViscous{1, 2000};
    StudyOptions coarse;
    coarse.values = 3;
    for (const auto& study : reduction_studies(joint, coarse)) {
        CHECK(study.own.full.empty());
        CHECK(study.own.reduced.empty());
        CHECK(std::isnan(study.own.error));
        CHECK(std::isnan(study.good_from));
        CHECK(std::isnan(study.fair_from));
        CHECK(study.searched_high / joint.control.k_p >= 1e9 * (1 - 1e-9));
    }
}

TEST_CASE("a boundary far from the joint's own gain is found and compared", "[stability]")
{
    // light bodies: the boundary of the whole lies at k_cr = (B − A)/L = 5e4 in series with k_tr; the own gain is 10^5
    // times that
    auto joint = samples::two_mass();
    joint.mechanism.motor_inertia = joint.mechanism.link_inertia = 1e-9;
    joint.mechanism.transmission.damping = 0;
    joint.mechanism.transmission.stiffness = 1e7;
    joint.frictions.motor.law = CoulombViscous{0, 0};
    joint.control.k_p = 5e9;
    StudyOptions coarse;
    coarse.values = 3;
    const auto studies = reduction_studies(joint, coarse);
    REQUIRE(studies.size() == 2);
    const auto& rigid = studies[1];
    CHECK(rigid.boundary_path == "control.k_p");
    REQUIRE(rigid.own.full.size() == 1);
    CHECK(rigid.own.full[0] == Approx(5e4 / (1 - 5e4 / 1e7)).epsilon(1e-4));
    CHECK(rigid.own.error == Approx(5e4 / 1e7).epsilon(1e-2));
}

TEST_CASE("where any small gains hold the joint, the least noise is none", "[stability]")
{
    // a wafer stage: flat friction with bristles under ticks of 8 kHz; k_v = 0 is unstable, any small one is not
    Joint joint = samples::single_mass(1);
    joint.mechanism.inertia = 22.5;
    joint.friction.law = Dahl{1.2, 4e5};
    auto& c = joint.control;
    c.k_p = 1.1e7, c.k_v = 3e4, c.V0 = 1e-6;
    c.period = c.delay = 1.25e-4;
    c.velocity_estimate.form = EstimateForm::backward_difference;
    REQUIRE(least_position_gain(joint) == 0);
    const auto mix = optimal_mix(joint, std::sqrt(2.0) / c.period);
    // the least k_v that is tried is no gain that the joint asks for
    CHECK(mix.k_v == 0);
    CHECK(mix.k_p == 0);
    CHECK(mix.noise == 0);
}

TEST_CASE("a reduction that does not apply is named by its steps", "[stability]")
{
    auto joint = samples::nine_states();
    TimeLag delayed;
    delayed.lag = 1e-3;
    delayed.curve.law = CoulombViscous{1, 0};
    joint.frictions.transmission.law = joint.frictions.motor.law = delayed;
    StudyOptions coarse;
    coarse.values = 2;
    const auto refused = [](const ReductionStudy& s) { return !s.refused.empty(); };
    const auto studies = reduction_studies(joint, coarse);
    const auto first = std::find_if(studies.begin(), studies.end(), refused);
    REQUIRE(first != studies.end());
    CHECK(first->name == "Fig. 5 to 6, transmission at the motor");
}
