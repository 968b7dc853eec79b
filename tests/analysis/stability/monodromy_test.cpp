// The monodromy of the sampled loop against a controller written out tick by tick: random joints of every kind.
#include "tests/analysis/friction/sample_laws.h"
#include "tests/analysis/simulation/joints.h"
#include "tests/analysis/stability/tick_by_tick.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <random>

using namespace stickslip;

namespace {

double between(std::mt19937_64& random, double low, double high)
{
    const double share = static_cast<double>(random() >> 11) * 0x1p-53;
    return low * std::pow(high / low, share);
}

Joint random_joint(std::mt19937_64& random)
{
    const auto pick = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
    static const auto laws = samples::laws();
    const auto draw = [&] {
        for (;;) {
            const auto& law = laws[static_cast<std::size_t>(pick(static_cast<int>(laws.size())))].law;
            if (!info(law).needs_history) return law;
        }
    };
    Joint j = example_joint(between(random, 1e3, 1e6), between(random, 1, 1e3), between(random, 1e-4, 1e-2));
    j.mechanism.inertia = between(random, 0.1, 10);
    j.friction.law = draw();
    if (pick(3) == 0) {
        auto& m = j.mechanism;
        m.model = Model::two_mass;
        m.motor_inertia = between(random, 0.1, 3);
        m.link_inertia = between(random, 0.1, 3);
        m.transmission.stiffness = between(random, 1e5, 1e7);
        m.transmission.damping = between(random, 1, 100);
        j.frictions.motor.law = draw();
        j.frictions.link.law = draw();
        j.control.feedback = pick(2) ? Feedback::link : Feedback::motor;
    }
    auto& c = j.control;
    c.period = between(random, 2e-5, 3e-3);
    c.delay = pick(2) ? c.period * pick(4) : c.period * between(random, 0.01, 5);
    if (pick(2)) c.k_i = between(random, 1e3, 1e7);
    if (pick(2)) c.velocity_estimate.tau = between(random, 1e-4, 1e-2);
    if (pick(2)) c.velocity_estimate.average = 1 + pick(4);
    c.velocity_estimate.form = pick(4) ? EstimateForm::backward_difference : EstimateForm::exact;
    if (pick(2)) j.actuator.lag = between(random, 1e-4, 1e-2);
    if (pick(2)) j.actuator.effort_gain = between(random, 0.3, 3);
    if (pick(3) == 0) j.sensor.position_scale = between(random, 0.8, 1.2);
    return j;
}

}  // namespace

TEST_CASE("The monodromy of random sampled joints is that of a controller written out tick by tick", "[slow]")
{
    std::mt19937_64 random(20231);
    int compared = 0, wrong = 0, apart = 0;
    while (compared < 2000) {
        const Joint j = random_joint(random);
        const double growth = growth_rate(j);
        const double told = samples::written_out(j).growth();
        if (!std::isfinite(growth) || !std::isfinite(told)) continue;
        ++compared;
        const double rounding = 1e-7 * (std::abs(told) + 1e-3 / j.control.period);
        if (std::abs(growth - told) <= rounding) continue;
        ++apart;
        if ((growth < 0) != (told < 0)) ++wrong;
        UNSCOPED_INFO("growth " << growth << " told " << told << " T " << j.control.period << " delay "
                                << j.control.delay << " bodies " << (j.mechanism.model == Model::two_mass ? 2 : 1));
    }
    CHECK(apart == 0);
    CHECK(wrong == 0);
}
