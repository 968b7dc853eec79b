// What the study of one joint leaves out, and searches that end: kernels, flat delayed curves, delays that are
// outweighed.
#include <catch2/catch.hpp>

#include "analysis/simulation/attractor/nonlinear.h"
#include "analysis/stability/joint_crossings.h"
#include "analysis/stability/study.h"
#include "tests/analysis/joint/sample_joints.h"
#include "tests/analysis/simulation/joints.h"

using namespace stickslip;

TEST_CASE("a kernel knows one velocity: it is compared, but no other velocities are searched", "[stability]")
{
    Joint joint = samples::single_mass(1);
    joint.friction.law = samples::kernel(true);
    CHECK(known_at_one_velocity(joint));
    const auto study = linear_study(joint);
    CHECK(std::isnan(study.velocities.low));
    CHECK(std::isnan(study.state_variable.least));
    CHECK_FALSE(study.range_gain);
    CHECK_FALSE(study.comparison.k_p_memory.empty());
    CHECK_FALSE(known_at_one_velocity(samples::two_mass()));
}

TEST_CASE("the nonlinear outcome of every kernel is that there is none", "[stability]")
{
    for (const bool history : {false, true}) {
        Joint joint = samples::single_mass(1);
        joint.friction.law = samples::kernel(history);
        CHECK(nonlinear_verdict(joint, {}).outcome == Outcome::linear_only);
    }
}

TEST_CASE("a flat curve that is delayed remembers nothing", "[stability]")
{
    Friction flat;
    flat.law = samples::time_lag(KineticStatic{10, 13});
    CHECK(linearise(flat, 1e-3).rational());
    flat.law = samples::time_lag(Stribeck{10, 0, 4, 1e-2, 2});
    CHECK_FALSE(linearise(flat, 1e-3).rational());
    CHECK(linearise(flat, 10).rational());  // e^{-(10/0.01)²} is zero
}

TEST_CASE("where the direct effect outweighs the delays the crossings end", "[stability]")
{
    // g = 1.5e5 e^{-100 t} + w δ(t − 2 ms): C = 1000 > w, so that Re G(iω) = C has no solution at high ω
    Kernel law;
    law.f_v = 1000;
    law.exponentials.push_back({1.5e5, 100});
    law.impulses.push_back({100, 2e-3});
    Joint joint = samples::single_mass(1);
    joint.friction.law = law;
    const auto search = crossings(linear_joint(joint, 1e-3));
    CHECK(search.searched_to == infinity);
    REQUIRE(search.crossings.size() == 1);
    const double w = search.crossings[0].omega, t = 2e-3;
    CHECK(1.5e5 * 100 / (1e4 + w * w) + 100 * std::cos(w * t) == Approx(1000).epsilon(1e-12));  // (34)
    CHECK(w * w + w * (1.5e5 * w / (1e4 + w * w) + 100 * std::sin(w * t)) ==
          Approx(search.crossings[0].k_p).epsilon(1e-12));  // (35)
    law.impulses[0].weight = 1100;
    joint.friction.law = law;
    CHECK(crossings(linear_joint(joint, 1e-3)).searched_to < infinity);
}

TEST_CASE("the growth rate alone is that of the row of a sweep", "[stability]")
{
    Joint lagging = samples::single_mass(1);
    lagging.friction.law = samples::time_lag(Stribeck{10, 0, 4, 1e-2, 2});
    Joint bristled = samples::single_mass(1);
    bristled.friction.law = samples::lugre();
    Joint unset = samples::single_mass(1);
    unset.control.V0 = not_set;
    for (const auto& joint : {lagging, bristled, samples::single_mass(2), samples::two_mass(), samples::nine_states()})
        CHECK(growth_rate(joint) == linear_point(joint).spectral_abscissa);
    CHECK(std::isnan(growth_rate(unset)));
}

TEST_CASE("the margins of a sampled loop are those of k_p alone, as its window says", "[stability]")
{
    const auto study = linear_study(ticked_joint(70e3, 1e-3));
    // by a monodromy of its own, k_p turned and k_v held; turned together it is 0.939288 and 11.20057
    CHECK(study.margins.gain_below == Approx(0.937901).epsilon(1e-5));
    CHECK(study.margins.gain_above == Approx(10.55030).epsilon(1e-5));
}

TEST_CASE("the gains that a cascade's theories are compared in are those of its verdict", "[stability]")
{
    Joint joint = samples::single_mass(1);
    auto& c = joint.control;
    c.structure = Structure::cascade;
    c.velocity_gain = 200, c.position_gain = 300, c.velocity_integral_gain = 5e3;
    const auto verdict = linear_verdict(joint).state_variable.stable_intervals;
    const auto compared = linear_study(joint).comparison.k_p_memory;
    REQUIRE_FALSE(verdict.empty());
    REQUIRE(compared.size() == verdict.size());
    for (std::size_t i = 0; i < verdict.size(); ++i) {
        CHECK(compared[i].low == verdict[i].low);
        CHECK(compared[i].high == verdict[i].high);
    }
}
