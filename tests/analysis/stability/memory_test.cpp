// Friction with memory beyond one state on one mass: published and closed numbers, limits.
#include <catch2/catch.hpp>

#include "analysis/stability/frequency_search.h"
#include "analysis/stability/joint_spectrum.h"
#include "analysis/stability/verdict.h"
#include "tests/analysis/joint/sample_joints.h"

using namespace stickslip;

namespace {

Joint with_law(FrictionLaw law, double V0, double k_v, double k_p = 1000)
{
    Joint joint = samples::single_mass(1);
    joint.friction.law = std::move(law);
    joint.control.V0 = V0;
    joint.control.k_v = k_v;
    joint.control.k_p = k_p;
    return joint;
}

/// A falling curve of slope −100 N·s/m at V_0 = c3/√2: c1 − √2 c2/c3 e^{−1/2}, (26)
TimeLag falling(double lag)
{
    const double c3 = 1e-2;
    return samples::time_lag(Stribeck{10, 0, 100 * c3 / std::sqrt(2.0) * std::exp(0.5), c3, 2}, lag);
}

}  // namespace

TEST_CASE("a time lag has windows of stable gains", "[stability]")
{
    // m = 1, |f'| = 100, τ = 5 ms, k_v = 0: 130112 < k_p < 794017 and 2624481 < k_p < 4616195 N/m
    const double V0 = 1e-2 / std::sqrt(2.0);
    const auto without = linear_verdict(with_law(falling(5e-3), V0, 0, 2e6)).state_variable;
    REQUIRE(without.stable_intervals.size() >= 2);
    CHECK(without.stable_intervals[0].low == Approx(130112).epsilon(1e-5));
    CHECK(without.stable_intervals[0].high == Approx(794017).epsilon(1e-6));
    CHECK(without.stable_intervals[1].low == Approx(2624481).epsilon(1e-6));
    CHECK(without.stable_intervals[1].high == Approx(4616195).epsilon(1e-6));
    CHECK(std::isnan(without.k_cr));
    CHECK(without.searched_to >= 8e6);
    CHECK(without.doubtful.empty());
    CHECK_FALSE(without.stable);

    const auto damped = linear_verdict(with_law(falling(5e-3), V0, 50, 5e5)).state_variable;
    REQUIRE(damped.stable_intervals.size() >= 1);
    CHECK(damped.stable_intervals[0].low == Approx(62003).epsilon(1e-5));
    CHECK(damped.stable_intervals[0].high == Approx(1005933).epsilon(1e-6));
    CHECK(damped.stable);

    CHECK(linear_verdict(with_law(falling(0.1), V0, 0)).state_variable.stable_intervals.empty());
    const auto enough = linear_verdict(with_law(falling(5e-3), V0, 101)).state_variable;
    CHECK(enough.crossings.empty());
    CHECK(enough.stable);
}

TEST_CASE("among many crossings the stable windows are those that a look at every gap finds", "[stability]")
{
    const double V0 = 1e-2 / std::sqrt(2.0);
    for (const double k_v : {0.0, 60.0, 95.0}) {
        const auto joint = with_law(falling(2e-2), V0, k_v, 1e5);
        const auto verdict = linear_verdict(joint).state_variable;
        CAPTURE(k_v);
        REQUIRE(verdict.crossings.size() > 10);
        for (std::size_t i = 0; i + 1 < verdict.crossings.size(); ++i) {
            const double low = verdict.crossings[i].k_p, high = verdict.crossings[i + 1].k_p;
            const double k_p = std::sqrt(low * high);
            bool inside = false;
            for (const auto& w : verdict.stable_intervals) inside = inside || (w.low < k_p && k_p < w.high);
            const auto there = linear_verdict(with_law(falling(2e-2), V0, k_v, k_p)).state_variable;
            CHECK((there.spectral_abscissa < 0) == inside);
        }
    }
}

TEST_CASE("roots of a lagging joint solve the characteristic equation, and none lies further right", "[stability]")
{
    const double V0 = 1e-2 / std::sqrt(2.0);
    for (const double k_p : {1e4, 3e5, 1e6, 3e6}) {
        const auto verdict = linear_verdict(with_law(falling(5e-3), V0, 10, k_p)).state_variable;
        REQUIRE_FALSE(verdict.eigenvalues.empty());
        for (const auto s : verdict.eigenvalues) {
            // m s² + (k_v − 100 e^{−sτ}) s + k_p
            const auto value = s * s + (10.0 - 100.0 * std::exp(-s * 5e-3)) * s + k_p;
            CHECK(std::abs(value) < 1e-8 * (std::norm(s) + k_p));
        }
        CHECK(verdict.spectral_abscissa == verdict.eigenvalues.front().real());
        // the verdict of the roots is that of the windows
        bool inside = false;
        for (const auto& w : verdict.stable_intervals) inside = inside || (w.low < k_p && k_p < w.high);
        CHECK(verdict.stable == inside);
    }
}

TEST_CASE("lugre: gains of the stiff bristle", "[stability]")
{
    const double V0 = 1e-3 / std::sqrt(2.0);
    struct Known {
        double k_v, k_cr;
    };
    for (const auto& k : {Known{80, 169438.28}, Known{200, 17700.43}, Known{400, 1801.88}})
        CHECK(linear_verdict(with_law(samples::lugre(), V0, k.k_v)).state_variable.k_cr ==
              Approx(k.k_cr).epsilon(3e-6));
    for (const double k_v : {0.0, 50.0, 73.185}) {
        const auto verdict = linear_verdict(with_law(samples::lugre(), V0, k_v)).state_variable;
        CHECK(verdict.stable_intervals.empty());
        CHECK(std::isnan(verdict.k_cr));
    }
    CHECK(linear_verdict(with_law(samples::lugre(), V0, 429)).state_variable.stable);
}

TEST_CASE("a vanishing slip distance leaves the velocity-only theory", "[stability]")
{
    for (const double k_v : {400.0, 600.0}) {  // velocity-only asks for (B − A)/V_0 = 500
        const auto law = samples::rate_and_state<RateAndState>({1.5}, {1e-14});
        const auto verdict = linear_verdict(with_law(law, 1e-3, k_v, 1e6));
        CHECK(verdict.velocity_only.k_v_min == Approx(500).epsilon(1e-12));
        CHECK(verdict.state_variable.stable == verdict.velocity_only.stable);
        CHECK(verdict.state_variable.stable == (k_v > 500));
    }
}

TEST_CASE("a kernel sampled from rate-and-state friction has its critical gain", "[stability][slow]")
{
    // g(t) = (B/L) e^{−V_0 t/L}, f_v = A/V_0; k_cr = 55000 N/m
    KernelTable table;
    for (int i = 0; i <= 2000; ++i) {
        const double t = 2e-4 * i;
        table.time.push_back(t);
        table.value.push_back(1.5e5 * std::exp(-t / 1e-2));
    }
    Kernel sampled;
    sampled.f_v = 1000;
    sampled.samples = std::make_shared<const KernelTable>(table);
    Kernel exact;
    exact.f_v = 1000;
    exact.exponentials.push_back({1.5e5, 100});
    const auto verdict = linear_verdict(with_law(sampled, 1e-3, 0, 3e4)).state_variable;
    CHECK(linear_verdict(with_law(exact, 1e-3, 0)).state_variable.k_cr == Approx(55000).epsilon(1e-12));
    CHECK(verdict.k_cr == Approx(55000).epsilon(2e-4));  // straight lines over t = L/V_0/50
    CHECK(verdict.searched_to == infinity);
    CHECK(verdict.doubtful.empty());
    CHECK_FALSE(verdict.stable);
    // the same root as the law's own
    const auto state = linear_verdict(with_law(exact, 1e-3, 0, 3e4)).state_variable;
    CHECK(verdict.spectral_abscissa == Approx(state.spectral_abscissa).epsilon(2e-3));
}

TEST_CASE("a kernel that changes sign: every window, decided by the roots", "[stability]")
{
    Kernel law;
    law.f_v = 300;
    law.exponentials.push_back({-4e5, 200});
    law.exponentials.push_back({6e5, 1000});
    law.exponentials.push_back({5e4, 20});
    const auto verdict = linear_verdict(with_law(law, 1e-3, 0)).state_variable;
    CHECK(verdict.crossings.size() >= 1);
    for (double k_p = 10; k_p < 1e9; k_p *= 1.31) {
        const auto at = linear_verdict(with_law(law, 1e-3, 0, k_p)).state_variable;
        bool inside = false;
        for (const auto& w : verdict.stable_intervals) inside = inside || (w.low < k_p && k_p < w.high);
        CAPTURE(k_p);
        CHECK(at.stable == inside);
    }
}

TEST_CASE("regularised and ageing laws have the boundary of the slip law", "[stability]")
{
    for (const FrictionLaw& law :
         {FrictionLaw(samples::rate_and_state<Ageing>()), FrictionLaw(samples::regularised(MemoryForm::slip)),
          FrictionLaw(samples::regularised(MemoryForm::ageing))})
        CHECK(linear_verdict(with_law(law, 1e-3, 0)).state_variable.k_cr == Approx(55000).epsilon(1e-12));
    // and in reverse, where the law allows it
    CHECK(linear_verdict(with_law(samples::regularised(MemoryForm::slip), -1e-3, 0)).state_variable.k_cr ==
          Approx(55000).epsilon(1e-12));
}

TEST_CASE("friction of the transmitted load is as a heavier mass on weaker gains", "[stability]")
{
    // (1 − μ)(k_p, k_v) against m and f: k_cr in the joint's own k_p
    Joint joint = with_law(samples::rate_and_state<RateAndState>(), 1e-3, 0);
    joint.friction.load_coefficient = 0.2;
    CHECK(linear_verdict(joint).state_variable.k_cr == Approx(55000 / 0.8).epsilon(1e-12));
}

TEST_CASE("a kernel that is negative like the damping loses stability at a rising gain", "[stability]")
{
    // m s³ + (C − mλ) s² + (k_p − Cλ − w) s − k_p λ with C < 0, w < 0: Routh's condition holds below one k_p
    LuGre law;
    law.sigma0 = 1e5, law.sigma1 = 1000, law.sigma2 = 0.4, law.coulomb = 1, law.breakaway = 1.5;
    law.stribeck_velocity = 1e-2;
    const auto verdict = linear_verdict(with_law(law, 7.0710678e-3, 200, 1.34e6)).state_variable;
    REQUIRE(verdict.crossings.size() == 1);
    CHECK(verdict.crossings[0].k_p == Approx(1350232.156).epsilon(1e-8));
    REQUIRE(verdict.stable_intervals.size() == 1);
    CHECK(verdict.stable_intervals[0].low == 0);
    CHECK(verdict.stable_intervals[0].high == Approx(1350232.156).epsilon(1e-8));
    CHECK(verdict.stable);
    CHECK_FALSE(linear_verdict(with_law(law, 7.0710678e-3, 200, 1.36e6)).state_variable.stable);
}
