// Energy balance of limit cycles: over one period of m ẍ + k_v ẋ + k_p x + f = f_ss the work of friction beyond f_ss
// and the work of the damper cancel, ∮ (f − f_ss + k_v ẋ) ẋ dt = 0.
#include <catch2/catch.hpp>
#include <cmath>

#include "analysis/simulation/attractor/attractor.h"
#include "analysis/simulation/simulate.h"
#include "analysis/stability/verdict.h"
#include "tests/analysis/simulation/joints.h"

using namespace stickslip;

namespace {

/// The integral over one period by Simpson's rule on the steps of the solver, relative to that of its modulus.
double energy_defect(const SlidingFlow& flow, const FlowVector& start, double period)
{
    const auto stepper = rodas5p_stepper(1e-11);
    const Events none;
    stepper->start(flow, 0, start, none);
    const auto power = [&](const FlowVector& y) {
        States theta{};
        for (int i = 0; i < flow.states; ++i) theta[i] = y[2 + i];
        const double excess = flow.velocity(y) - flow.V0;
        return (respond(flow.friction, flow.velocity(y), theta).force - flow.steady_friction + flow.k_v * excess) *
               excess;
    };
    double sum = 0, modulus = 0, t = 0, at_start = power(start);
    for (auto end = StepEnd::step; end == StepEnd::step;) {
        end = stepper->step(period).end;
        const double h = stepper->time() - t, at_end = power(stepper->state());
        const double step = h / 6 * (at_start + 4 * power(stepper->at(t + h / 2)) + at_end);
        sum += step;
        modulus += std::abs(step);
        t = stepper->time();
        at_start = at_end;
    }
    return std::abs(sum) / modulus;
}

}  // namespace

TEST_CASE("limit cycles balance their energy", "[nonlinear][slow]")
{
    for (const double M : {0.001, 0.1, 1.0, 10.0})
        for (const double c : {0.0, 0.25})
            for (const double ratio : {0.3, 0.7, 0.98}) {
                const double beta = 1.5, K = ratio * (beta - 1 - c) * (1 + M / (1 + c));
                const auto flow = sliding_flow(dimensionless_joint(K, M, beta, c)).flow;
                FlowVector start = flow.steady();
                start[0] = 1;
                const auto end = follow(flow, start, false, {});
                CAPTURE(M, c, ratio);
                REQUIRE(end.kind == Attractor::Kind::cycle);
                CHECK(energy_defect(flow, end.start, end.period) < 1e-6);
            }
}

TEST_CASE("a trajectory keeps its steps, sticks truly and starts where it is disturbed", "[nonlinear]")
{
    const Joint joint = stribeck_joint(1e4, 0, 1e-3);
    SimulateOptions options;
    options.disturbance = {DisturbanceKind::start, 0};
    options.duration = 1;
    const auto path = simulate(joint, options);
    REQUIRE(path.time.size() > 100);
    CHECK(path.reason == Reason::none);
    CHECK(path.time.back() == Approx(1));
    CHECK(path.velocity.front() == 0);
    CHECK(path.friction.front() == Approx(14));  // c0 + c2, wound up to breakaway
    double stuck = 0;
    for (std::size_t i = 1; i < path.time.size(); ++i) {
        CHECK(path.time[i] >= path.time[i - 1]);
        if (path.stuck[i]) {
            CHECK(path.velocity[i] == 0);
            CHECK(std::abs(path.friction[i]) <= 14 * (1 + 1e-9));
            stuck += path.time[i] - path.time[i - 1];
        }
    }
    CHECK(stuck > 0.3);
}

TEST_CASE("a small disturbance that decays is followed at the rate of the spectrum to its end", "[nonlinear]")
{
    const Joint joint = example_joint(6e4, 10, 1e-3);
    const auto path = simulate(joint, {});
    REQUIRE(path.reason == Reason::none);
    double greatest_early = 0, greatest_late = 0;  // share of the steady velocity, each counted back to its start
    const double rate = linear_point(joint).spectral_abscissa, turns = path.time.back();
    for (std::size_t i = 0; i < path.time.size(); ++i) {
        const double undamped = std::abs(path.velocity[i] / 1e-3 - 1) * std::exp(-rate * path.time[i]);
        auto& greatest = path.time[i] < 0.5 * turns ? greatest_early : greatest_late;
        if (path.time[i] > 0.1 * turns) greatest = std::max(greatest, undamped);
    }
    CHECK(rate == Approx(-2.5).epsilon(0.05));
    // at its end the motion is some 25 times what the solver's least tolerance, 1e-12 of V_0, lets be an error
    CHECK(greatest_late == Approx(greatest_early).epsilon(0.04));
}
