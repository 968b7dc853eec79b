// The two-state case of Gu, Rice, Ruina & Tse (1984), J. Mech. Phys. Solids 32, without inertia: from the Hopf point
// through period doublings towards chaos.
#include <catch2/catch.hpp>
#include <cmath>

#include "analysis/simulation/attractor/attractor.h"
#include "analysis/simulation/attractor/orbit.h"
#include "tests/analysis/simulation/joints.h"
#include "tests/oracles/matrices.h"

using namespace stickslip;

namespace {

constexpr double critical = 0.0802755656;  // κ_cr, published

SlidingFlow two_states_with_mass(double share, double mass)
{
    Joint joint = dimensionless_joint(share * critical, mass, 1, 0);
    auto& law = std::get<RateAndState>(joint.friction.law);
    law.B.push_back(0.84);
    law.L.push_back(1 / 0.048);
    return sliding_flow(joint).flow;
}

QuasiStaticFlow two_states(double share)
{
    return QuasiStaticFlow(two_states_with_mass(share, 1));
}

/// The orbit of the given number of turns at this gain, from that of a neighbouring gain.
Cycle orbit(double share, int turns, const FlowVector& guess)
{
    CycleOptions options;
    options.turns = turns;
    const auto cycle = find_cycle(two_states(share), guess, options);
    CAPTURE(share, turns);
    REQUIRE(cycle);
    return *cycle;
}

/// Where the multiplier of the orbit falls through −1, between two shares of κ_cr.
double doubling(int turns, double low, double high, FlowVector start)
{
    for (int i = 0; i < 40 && high - low > 1e-8; ++i) {
        const double middle = 0.5 * (low + high);
        const auto cycle = orbit(middle, turns, start);
        start = cycle.start;
        (cycle.multipliers[0].real() < -1 ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

}  // namespace

TEST_CASE("two states without inertia: the fixed point loses stability at the published κ_cr", "[nonlinear]")
{
    const auto abscissa = [](double share) {
        const auto flow = two_states(share);
        FlowMatrix J;
        flow.jacobian(flow.steady(), J);
        return test::spectral_abscissa(J);
    };
    CHECK(abscissa(1 + 1e-8) < 0);
    CHECK(abscissa(1 - 1e-8) > 0);
}

TEST_CASE("two states without inertia: period doublings at 0.866259 and 0.857039 κ_cr", "[nonlinear][slow]")
{
    const auto settled = follow(two_states(0.88), two_states(0.88).steady() + FlowVector::Constant(3, 0.05), false, {});
    REQUIRE(settled.kind == Attractor::Kind::cycle);
    auto cycle = orbit(0.88, 1, settled.start);
    CHECK(cycle.attracts());
    for (double share = 0.878; share > 0.8679; share -= 0.002) cycle = orbit(share, 1, cycle.start);
    const double first = doubling(1, 0.864, 0.868, cycle.start);
    CHECK(first == Approx(0.866259).margin(1e-6));

    const auto twice = follow(two_states(0.862), cycle.start, false, {});
    REQUIRE(twice.kind == Attractor::Kind::period_n);
    CHECK(twice.repeats == 2);
    auto two = orbit(0.862, 2, twice.start);
    CHECK(two.attracts());
    for (double share = 0.861; share > 0.8575; share -= 0.0005) two = orbit(share, 2, two.start);
    CHECK(doubling(2, 0.8560, 0.8580, two.start) == Approx(0.857039).margin(1e-6));
}

TEST_CASE("two states without inertia: beside a doubling the repeat is the attracting orbit's", "[nonlinear][slow]")
{
    // where the multipliers of the orbits of 4 and of 8 turns fall through −1
    const auto four = follow(two_states(0.856), two_states(0.856).steady() + FlowVector::Constant(3, 0.05), false, {});
    REQUIRE(four.repeats == 4);
    const double third = doubling(4, 0.8553, 0.8556, four.start);
    CHECK(third == Approx(0.855394).margin(1e-6));
    for (const auto& [share, turns] :
         {std::pair{third + 1e-4, 4}, std::pair{third - 1e-4, 8}, std::pair{0.85515, 8}, std::pair{0.855, 16}}) {
        const auto flow = two_states(share);
        const auto end = follow(flow, flow.steady() + FlowVector::Constant(3, 0.05), false, {});
        CAPTURE(share, end.turns);
        CHECK(end.kind == Attractor::Kind::period_n);
        CHECK(end.repeats == turns);
        CHECK(end.path == DecisionPath::shooting);
        CHECK(std::abs(end.multipliers[0]) < 1);
    }
}

TEST_CASE("orbits of several turns are sought with the work that is left", "[nonlinear]")
{
    const auto flow = two_states(0.862);
    const auto twice = follow(flow, flow.steady() + FlowVector::Constant(3, 0.05), false, {});
    REQUIRE(twice.repeats == 2);
    constexpr double rtol = 1e-9, reach = 0.1;
    Work enough(1), little(1e-4);
    CHECK(attracting_orbit(flow, twice.start, 2, rtol, reach, &enough));
    CHECK_FALSE(enough.spent());
    CHECK(enough.left() < Work(1).left());
    CHECK_FALSE(attracting_orbit(flow, twice.start, 2, rtol, reach, &little));
    CHECK(little.spent());
    CHECK(little.left() > -Work::of_step(flow.size()));
}

TEST_CASE("two states and a small mass: where neighbouring motions part, the motion is irregular", "[nonlinear][slow]")
{
    const auto flow = two_states_with_mass(0.848, 1e-3);
    FollowOptions options;
    options.turn_limit = 700;
    const auto end = follow(flow, flow.steady() + FlowVector::Constant(flow.size(), 0.05), false, options);
    CHECK(end.kind == Attractor::Kind::irregular);

    // the growth of a displacement, by the variational equations of one-step integration over the same number of turns
    CycleOptions turn;
    turn.rtol = 1e-8;
    FlowVector y = end.start, displaced = FlowVector::Ones(flow.size());
    double growth = 0;
    constexpr int turns = 200;
    for (int i = 0; i < turns; ++i) {
        const auto once = revolve(flow, y, turn);
        REQUIRE(once);
        // along the flow nothing grows: what counts is the part across it, back on the section
        FlowVector rate;
        flow.rate(once->end, rate);
        const FlowVector normal = flow.speed_gradient(once->end);
        displaced = once->displacement * displaced;
        displaced -= rate * (normal.dot(displaced) / normal.dot(rate));
        growth += std::log(displaced.norm());
        displaced.normalize();
        y = once->end;
    }
    CHECK(growth / turns > 0.05);
}
