// What prepare() takes for noise of the sensors.
#include "analysis/diagnosis/audit/prepare.h"
#include "analysis/diagnosis/audit/reading_noise.h"
#include "analysis/diagnosis/heldout/ensemble.h"
#include "tests/analysis/diagnosis/small_machine.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <random>

using namespace stickslip;
using namespace stickslip::gap;

namespace {

/// A document that gives the step of the encoder and no noise.
Joint without_noise(const test::Machine& m)
{
    Joint joint = test::nominal_joint();
    joint.sensor.position_noise = 0;
    joint.sensor.encoder_quantum = m.quantum;
    return joint;
}

}  // namespace

TEST_CASE("noise estimated from rounded readings is that before rounding", "[gap]")
{
    test::Machine m;
    m.noise = 4e-5, m.quantum = 8e-5;
    const Joint joint = without_noise(m);
    std::vector<Note> notes;
    const Case c = prepare(test::record_of(m, 5), joint, notes);
    CHECK(c.joint.sensor.position_noise == Approx(m.noise).epsilon(0.05));
    CHECK(c.sigma == Approx(std::hypot(m.noise, m.quantum / std::sqrt(12.0))).epsilon(0.05));
}

TEST_CASE("noise with a memory is not taken for the little that it does from row to row", "[gap]")
{
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    const auto readings = [&](double kept, double motion) {
        std::vector<double> y;
        double noise = 0;
        for (int k = 0; k < 12000; ++k) {
            noise = kept * noise + std::sqrt(1 - kept * kept) * normal(random);
            y.push_back(2e-5 * noise + motion * std::sin(0.02 * k));
        }
        return y;
    };
    // how long the memory is shows at six rows no better than to a third of the noise; from row to row a quarter is
    // seen
    for (const double motion : {0.0, 0.05})  // whose jerk is, at six rows, four times the noise
        for (const double kept : {0.3, 0.8, 0.9}) {
            const auto y = readings(kept, motion);
            CAPTURE(motion, kept, noise_of(y));
            CHECK(noise_with_memory(y).sigma == Approx(2e-5).epsilon(0.33));
            CHECK(noise_with_memory(y).kept == Approx(kept).margin(0.15));
        }
    CHECK(noise_of(readings(0.9, 0)) < 0.3 * 2e-5);
    for (const double motion : {0.0, 0.5}) {
        const auto white = readings(0, motion);
        CHECK(noise_with_memory(white).sigma == Approx(noise_of(white)));
        CHECK(noise_with_memory(white).kept == 0);
    }
}

TEST_CASE("noise of a measured effort is that of its sensor, not what the encoder puts into the command", "[gap]")
{
    test::Machine m;
    m.noise = 2e-5, m.effort_noise = 0.05;  // the encoder's alone makes the command rattle by 0.4 N
    std::vector<Note> notes;
    const Case c = prepare(test::record_of(m, 3), test::nominal_joint(), notes);
    CHECK(c.joint.sensor.effort_noise == Approx(m.effort_noise).epsilon(0.05));
}

TEST_CASE("noise that is not stated counts although the step of the encoder makes most of it", "[gap]")
{
    test::Machine m;
    m.quantum = 2e-5, m.noise = 3e-6;  // together 1.12 of what rounding alone makes
    const Joint joint = without_noise(m);
    std::vector<Note> notes;
    const Case c = prepare(test::record_of(m, 5), joint, notes);
    CHECK(c.sigma == Approx(std::hypot(m.noise, m.quantum / std::sqrt(12.0))).epsilon(0.03));
}

TEST_CASE("a joint at rest hides the noise of its encoder behind the steps, and gets that of the others", "[gap]")
{
    test::Machine m;
    m.quantum = 2e-5, m.noise = 5e-6;
    const Joint joint = without_noise(m);
    std::vector<Note> notes;
    test::Machine still = m;
    still.amplitude = 0;
    std::vector<Case> cases{prepare(test::record_of(m, 5), joint, notes),
                            prepare(test::record_of(still, 6), joint, notes)};
    const double rounding = m.quantum / std::sqrt(12.0), truth = std::hypot(m.noise, rounding);
    REQUIRE(cases[1].sigma < 0.99 * truth);
    share_noise(cases, joint.sensor, notes);
    for (const auto& c : cases) {
        CHECK(c.sigma == Approx(truth).epsilon(0.03));
        CHECK(c.joint.sensor.position_noise == Approx(m.noise).epsilon(0.1));
    }
    // a documented noise is nobody else's
    Joint documented = joint;
    documented.sensor.position_noise = m.noise;
    std::vector<Case> told{prepare(test::record_of(m, 5), documented, notes),
                           prepare(test::record_of(still, 6), documented, notes)};
    const double before = told[1].sigma;
    told[0].sigma *= 1.3;
    share_noise(told, documented.sensor, notes);
    CHECK(told[1].sigma == before);
}

TEST_CASE("a stop that shakes a joint now and then is not taken for noise of its encoder", "[gap]")
{
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    std::vector<double> quiet, shaken;
    for (int k = 0; k < 20000; ++k) {
        quiet.push_back(std::sin(1e-3 * k) + 1e-4 * normal(random));
        const int since = k % 400;  // ticks after an impact
        shaken.push_back(quiet.back() + (since < 20 ? 5e-3 * std::exp(-0.1 * since) * std::sin(1.5 * since) : 0));
    }
    CHECK(noise_of(quiet) == Approx(1e-4).epsilon(0.02));
    CHECK(noise_of(shaken) == Approx(1e-4).epsilon(0.1));
}

TEST_CASE("a coarser grid than documented is not booked as noise", "[gap]")
{
    test::Machine m;
    m.noise = 1e-5, m.quantum = 8e-5;
    Joint joint = test::nominal_joint();
    joint.sensor.position_noise = m.noise;
    joint.sensor.encoder_quantum = 0;
    std::vector<Note> notes;
    const Case c = prepare(test::record_of(m, 2), joint, notes);
    CHECK(c.joint.sensor.position_noise == m.noise);
    CHECK(notes.empty());
}

TEST_CASE("what a coarse grid leaves open reaches the command's floor through k_p", "[gap]")
{
    test::Machine m;
    m.noise = 0, m.quantum = 2e-3, m.amplitude = 0;
    const Joint joint = without_noise(m);
    std::vector<Note> notes;
    const Case c = prepare(test::record_of(m, 1, 2), joint, notes);
    // a joint at rest on a step of its grid: every run gives the same readings and the same command
    const auto signals = compare(c, joint, 3, -infinity, infinity);
    const auto command = std::ranges::find(signals, "effort_command", &SignalSquares::signal);
    REQUIRE(command != signals.end());
    CHECK(command->floor == Approx(0.5 * std::pow(m.k_p * m.quantum, 2) / 12));
}
