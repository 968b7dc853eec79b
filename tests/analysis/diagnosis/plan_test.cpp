#include "analysis/diagnosis/plan/power.h"
#include "analysis/diagnosis/plan/safe_motion.h"
#include "analysis/diagnosis/plant/simulator.h"
#include "analysis/diagnosis/policy/search.h"
#include "tests/in_order.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace stickslip;
using namespace stickslip::gap;

namespace {

Joint servo(double coulomb, double viscous)
{
    Joint j;
    j.mechanism.inertia = 2;
    CoulombViscous law;
    law.coulomb = coulomb, law.viscous = viscous;
    j.friction.law = law;
    j.control.k_p = 2000, j.control.k_v = 90;
    j.control.period = 1e-3;
    j.sensor.position_noise = 2e-6;
    return j;
}

PlannedMotion motion_of(double seconds, const std::function<double(double)>& at)
{
    PlannedMotion m;
    for (int k = 0; k < static_cast<int>(seconds * 1e3); ++k)
        m.time.push_back(1e-3 * k), m.position.push_back(at(1e-3 * k));
    return m;
}

double least_of(const Power& power, const std::string& name)
{
    for (const auto& e : power.effects)
        if (e.name == name) return e.least_size;
    return not_set;
}

bool inseparable(const Power& power, const std::string& one, const std::string& other)
{
    return std::ranges::any_of(power.inseparable, [&](const auto& pair) {
        return (pair.first == one && pair.second == other) || (pair.first == other && pair.second == one);
    });
}

}  // namespace

TEST_CASE("the least constant load that shows is the one whose surprise the diagnosis sees beside the noise",
          "[gap][plan][slow]")
{
    const auto power = power_of(servo(0, 0), motion_of(8, [](double t) { return 0.05 * std::sin(t); }), test::in_order);
    // a force F on a free mass m keeps the observer at e = F/(m ω²): largest beside the noise at the slowest ω, 20
    // rad/s
    const double omega = 20, floor = 2e-6 * std::sqrt(noise_amplification(omega, 1e-3));
    CHECK(least_of(power, "constant-load") ==
          Approx(std::sqrt(policy::visible_excess) * floor * 2 * omega * omega).epsilon(0.05));
    CHECK(least_of(power, "gain-k_p") == Approx(0.004));
}

TEST_CASE("twice the noise doubles the least size of every effect that is linear in it", "[gap][plan][slow]")
{
    const auto least = [](double noise) {
        Joint j = servo(3, 5);
        j.sensor.position_noise = noise;
        return power_of(j, motion_of(6, [](double t) { return 0.05 * std::sin(2 * t); }), test::in_order);
    };
    const auto once = least(2e-6), twice = least(4e-6);
    for (const char* name : {"constant-load", "cogging", "periodic-disturbance", "asymmetric-friction", "viscous"}) {
        CAPTURE(name);
        CHECK(least_of(twice, name) == Approx(2 * least_of(once, name)).epsilon(0.1));
    }
}

TEST_CASE("a motion in one direction cannot tell a load from the Coulomb level, one to and fro can",
          "[gap][plan][slow]")
{
    const auto one_way = power_of(servo(3, 5), motion_of(6, [](double t) { return 0.02 * t; }), test::in_order);
    CHECK(inseparable(one_way, "constant-load", "coulomb-level"));
    const auto both =
        power_of(servo(3, 5), motion_of(6, [](double t) { return 0.05 * std::sin(2 * t); }), test::in_order);
    CHECK_FALSE(inseparable(both, "constant-load", "coulomb-level"));
}

TEST_CASE("the reach of a sine is its amplitude, its speed and its acceleration, noise or not", "[gap][plan]")
{
    std::vector<double> time, position;
    for (int k = 0; k < 10000; ++k) {
        time.push_back(1e-3 * k);
        position.push_back(0.3 * std::sin(4 * time.back()) + 1e-6 * (k % 2 ? 1 : -1));
    }
    const Reach r = reach_of(time, position);
    CHECK(r.high == Approx(0.3).epsilon(1e-3));
    CHECK(r.speed == Approx(1.2).epsilon(0.01));
    CHECK(r.acceleration == Approx(4.8).epsilon(0.02));
}

TEST_CASE("safe motions are continuous and stay within stroke, speed and acceleration", "[gap][plan]")
{
    const Reach reach{-0.1, 0.4, 0.8, 6, 0.05};
    const auto all = safe_motions(reach, 12, 1e-3);
    CHECK(all.size() == 5);
    for (const auto& m : all) {
        CAPTURE(m.kind);
        CHECK(m.position.front() == Approx(reach.start));
        CHECK(m.position.back() == Approx(reach.start));
        CHECK(m.time.back() < 40);
        double fastest = 0, hardest = 0;
        for (std::size_t k = 1; k < m.position.size(); ++k) {
            fastest = std::max(fastest, std::abs(m.position[k] - m.position[k - 1]) / 1e-3);
            if (k + 1 < m.position.size())
                hardest = std::max(hardest, std::abs(m.position[k + 1] - 2 * m.position[k] + m.position[k - 1]) / 1e-6);
        }
        CHECK(fastest <= reach.speed);
        CHECK(hardest <= 1.05 * reach.acceleration + 0.5);  // the end of a move is rounded to a row
        const auto [low, high] = std::minmax_element(m.position.begin(), m.position.end());
        CHECK(*low >= reach.low);
        CHECK(*high <= reach.high);
    }
}
