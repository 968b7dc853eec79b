#include "analysis/diagnosis/plant/simulator.h"
#include "analysis/diagnosis/plant/step.h"
#include "analysis/results/not_fitted.h"
#include "tests/oracles/matrices.h"

#include <catch2/catch.hpp>
#include <cmath>

using namespace stickslip;
using namespace stickslip::gap;

namespace {

Joint sliding_mass(double inertia, double coulomb, double viscous)
{
    Joint j;
    j.mechanism.inertia = inertia;
    CoulombViscous law;
    law.coulomb = coulomb;
    law.viscous = viscous;
    j.friction.law = law;
    j.control.k_p = 100;
    j.control.k_v = 5;
    j.control.period = 1e-3;
    return j;
}

Record at_ticks(int rows, double period)
{
    Record r;
    for (int k = 0; k < rows; ++k) {
        r.time.push_back(k * period);
        r.position.push_back(0);
        r.effort_command.push_back(0);
    }
    return r;
}

}  // namespace

TEST_CASE("a law that no record is fitted with is refused by a code and its numbers", "[gap]")
{
    const auto refused = [](auto law) {
        Joint j = sliding_mass(1, 0, 0);
        j.friction.law = std::move(law);
        try {
            flatten(j);
        } catch (const NotFitted& e) {
            return e;
        }
        throw std::logic_error("is fitted");
    };
    RateAndState two_states;
    for (const double B : {0.02, 0.01}) two_states.B.push_back(B), two_states.L.push_back(1e-3);
    CHECK(refused(two_states).why == NotFitted::Why::several_states);
    MaxwellSlip elements;
    elements.elements.push_back({100, 0.3});
    elements.elements.push_back({20, 0.1});
    elements.viscous = 0.15;
    const auto in_turn = refused(elements);
    CHECK(in_turn.why == NotFitted::Why::elements);
    CHECK(in_turn.law == "maxwell-slip");
    CHECK(in_turn.level == Approx(0.4));
    CHECK(in_turn.stiffness == 120);
    CHECK(in_turn.viscous == 0.15);
    TimeLag delayed;
    delayed.lag = 0.004;
    CHECK(refused(delayed).why == NotFitted::Why::pure_delay);
    CHECK(refused(delayed).lag == 0.004);
}

TEST_CASE("a pushed mass under Coulomb friction follows the parabolas of constant force, stops and stays", "[gap]")
{
    // a force of 3 N for 0.1 s on 2 kg with 1 N friction: v = t, then v = 0.1 - 0.5 (t - 0.1), at rest from t = 0.3 s
    // on
    const Joint joint = sliding_mass(2, 1, 0);
    Record record = at_ticks(401, 1e-3);
    for (int k = 0; k < 100; ++k) record.effort_command[k] = 3;
    const Ticks ticks = on_clock(record, joint);
    Innovation run;
    predict(flatten(joint), ticks, ticks.command, 0, run);
    CHECK(-run.position[100] == Approx(0.5 * 0.1 * 0.1).epsilon(1e-12));
    CHECK(-run.position[200] == Approx(0.005 + 0.1 * 0.1 - 0.25 * 0.01).epsilon(1e-12));
    CHECK(run.velocity[300] == Approx(0).margin(1e-12));
    CHECK(run.velocity[350] == 0);
    CHECK(-run.position[400] == Approx(0.015).epsilon(1e-12));
}

TEST_CASE("a command that goes straight from row to row pushes by its ramp, late or not", "[gap]")
{
    Joint joint = sliding_mass(2, 0, 0);
    for (const double delay : {0.0, 0.0035}) {
        joint.control.delay = delay;
        Record record = at_ticks(401, 1e-3);
        for (int k = 0; k <= 400; ++k) record.effort_command[k] = 3 * record.time[k];
        Ticks ticks = on_clock(record, joint);
        ticks.straight_command = true;
        Innovation run;
        predict(flatten(joint), ticks, ticks.command, 0, run);
        CHECK(-run.position[400] == Approx(3 * std::pow(0.4 - delay, 3) / 6 / 2).epsilon(1e-5));
    }
}

TEST_CASE("a force below the friction level never moves the mass, one above it does", "[gap]")
{
    const Joint joint = sliding_mass(1, 2, 0.1);
    for (const double force : {1.999, 2.001}) {
        Record record = at_ticks(2001, 1e-3);
        for (double& u : record.effort_command) u = force;
        const Ticks ticks = on_clock(record, joint);
        Innovation run;
        predict(flatten(joint), ticks, ticks.command, 0, run);
        CHECK((run.position[2000] == 0) == (force < 2));
    }
}

TEST_CASE("the sampled loop without friction is the matrix exponential with hold", "[gap]")
{
    // ẍ = (u − F_v ẋ)/m; exact discretisation over one tick, u from the recursion of docs/theory.md, real loops
    Joint joint = sliding_mass(1.3, 0, 2.1);
    joint.control.velocity_estimate.tau = 0.003;
    joint.control.k_p = 900;
    joint.control.k_v = 30;
    Record record = at_ticks(1500, 1e-3);
    record.effort_command.clear();
    for (double t : record.time) {
        record.reference_position.push_back(0.1 * (1 - std::cos(7 * t)));
        record.reference_velocity.push_back(0.7 * std::sin(7 * t));
    }
    const Ticks ticks = on_clock(record, joint);
    const Trace trace = simulate_closed_loop(flatten(joint), ticks, 0);

    Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
    a(0, 1) = 1;
    a(1, 1) = -2.1 / 1.3;
    a(1, 2) = 1 / 1.3;
    const Eigen::Matrix3d step = test::exponential(a * 1e-3);
    Eigen::Vector3d s = Eigen::Vector3d::Zero();
    double estimate = 0, last = 0, worst = 0;
    for (std::size_t k = 0; k < record.time.size(); ++k) {
        if (k > 0) estimate += 1e-3 / (0.003 + 1e-3) * ((s[0] - last) / 1e-3 - estimate);
        last = s[0];
        s[2] = 900 * (record.reference_position[k] - s[0]) + 30 * (record.reference_velocity[k] - estimate);
        worst = std::max(worst, std::abs(trace.position[k] - s[0]));
        s = step * s;
    }
    CHECK(worst < 2e-8);  // of 0.2 m: second order with 0.25 ms steps
}

TEST_CASE("halving the step quarters the error of a Stribeck slide under gravity", "[gap]")
{
    // the tick sets the step here (below 0.25 ms), so runs of the same motion at finer ticks are runs at finer steps
    const auto end = [](double period) {
        Joint joint = sliding_mass(0.8, 0.5, 0.2);
        Stribeck law;
        law.c0 = 0.5;
        law.c1 = 0.2;
        law.c2 = 0.4;
        law.c3 = 0.3;
        joint.friction.law = law;
        joint.load.gravity_amplitude = 2;
        joint.control.period = period;
        Record record = at_ticks(static_cast<int>(std::lround(0.6 / period)) + 1, period);
        for (double& u : record.effort_command) u = 3;
        const Ticks ticks = on_clock(record, joint);
        Innovation run;
        predict(flatten(joint), ticks, ticks.command, 0, run);
        return -run.position.back();
    };
    const double finest = end(0.4e-5), coarse = end(2e-4) - finest, fine = end(1e-4) - finest;
    CHECK(std::abs(coarse / fine) == Approx(4).margin(0.6));
}

TEST_CASE("dead time, lag, gain and limit act in this order and the log sees them just after the update", "[gap]")
{
    Joint joint = sliding_mass(1, 0, 0);
    joint.control.delay = 2e-3;
    joint.actuator.effort_gain = 2;
    joint.actuator.lag = 5e-3;
    joint.actuator.limit = 1.5;
    Record record = at_ticks(40, 1e-3);
    for (double& u : record.effort_command) u = 1;
    const Ticks ticks = on_clock(record, joint);
    Innovation run;
    predict(flatten(joint), ticks, ticks.command, 0, run);
    for (int k = 0; k < 40; ++k) {
        const double lagged = k < 2 ? 0 : 1 - std::exp(-(k - 2) * 1e-3 / 5e-3);
        CHECK(run.predicted_effort[k] == Approx(std::min(1.5, 2 * lagged)).margin(1e-12));
    }
}

TEST_CASE("white reading noise reaches the innovation of a true model by the computed factor", "[gap]")
{
    Joint joint = sliding_mass(1, 0, 0);
    joint.sensor.position_noise = 1e-4;
    Record record = at_ticks(20000, 1e-3);
    record.effort_command.clear();
    record.reference_position.assign(record.rows(), 0);
    Ticks ticks = on_clock(record, joint);
    const Plant plant = flatten(joint);
    const Trace trace = simulate_closed_loop(plant, ticks, 7);
    ticks.position = trace.position;
    ticks.command = trace.command;
    for (const double omega : {110.0, 20.0}) {
        Innovation run;
        predict(plant, ticks, trace.command, omega, run);
        double sum = 0, velocity = 0;
        for (double e : run.position) sum += e * e;
        CHECK(sum / 20000 == Approx(1e-8 * noise_amplification(omega, 1e-3)).epsilon(0.04));
        // the body itself moves a little, too: noise goes round the loop
        for (std::size_t k = 0; k < run.velocity.size(); ++k)
            velocity += std::pow(run.velocity[k] - trace.true_velocity[k], 2);
        CHECK(velocity / 20000 ==
              Approx(1e-8 * velocity_noise_amplification(omega, 1e-3)).epsilon(4 / std::sqrt(10 * omega)));
    }
}

TEST_CASE("noise of neighbouring seeds is not one sequence, shifted", "[gap]")
{
    Joint j = sliding_mass(1, 1, 1);
    j.sensor.position_noise = 1;
    j.control.k_p = j.control.k_v = 0;
    Record r = at_ticks(4000, 1e-3);
    r.reference_position.assign(r.rows(), 0);
    const Ticks ticks = on_clock(r, j);
    const Plant plant = flatten(j);
    const auto one = simulate_closed_loop(plant, ticks, 1).position;
    for (std::uint64_t seed : {2, 3, 4, 5, 9})
        for (int shift = -4; shift <= 4; ++shift) {
            const auto other = simulate_closed_loop(plant, ticks, seed).position;
            double product = 0, n = 0;
            for (int k = 10; k + 10 < 4000; ++k)
                product += one[static_cast<std::size_t>(k)] * other[static_cast<std::size_t>(k + shift)], n += 1;
            INFO("seed " << seed << " shifted by " << shift);
            CHECK(std::abs(product / n) < 5 / std::sqrt(n));
        }
}

TEST_CASE("simulated readings keep the part of their noise that the records keep", "[gap]")
{
    Joint j = sliding_mass(1, 2, 0);  // at rest: what is read is noise
    j.sensor.position_noise = 1e-4;
    Record r = at_ticks(20000, 1e-3);
    r.reference_position = r.position;
    Ticks ticks = on_clock(r, j);
    for (const double kept : {0.0, 0.8}) {
        ticks.noise_kept = kept;
        const auto y = simulate_closed_loop(flatten(j), ticks, 5).position;
        double square = 0, next = 0;
        for (std::size_t k = 0; k + 1 < y.size(); ++k) square += y[k] * y[k], next += y[k] * y[k + 1];
        CAPTURE(kept);
        CHECK(std::sqrt(square / static_cast<double>(y.size())) == Approx(1e-4).epsilon(0.05));
        CHECK(next / square == Approx(kept).margin(0.02));
    }
}

TEST_CASE("a simulated joint starts anywhere within a step of its encoder", "[gap]")
{
    Joint j = sliding_mass(1, 1, 1);
    j.sensor.encoder_quantum = 0.01;
    j.control.k_p = j.control.k_v = 0;
    Record r = at_ticks(10, 1e-3);
    r.reference_position.assign(r.rows(), 0);
    const Ticks ticks = on_clock(r, j);
    const Plant plant = flatten(j);
    CHECK(simulate_closed_loop(plant, ticks, 0).true_position[0] == ticks.position[0]);
    double sum = 0, square = 0;
    constexpr int seeds = 400;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        const Trace run = simulate_closed_loop(plant, ticks, seed);
        const double off = run.true_position[0] - ticks.position[0];
        REQUIRE(std::abs(off) <= 0.005);
        REQUIRE(run.position[0] == Approx(ticks.position[0]).margin(1e-12));
        sum += off, square += off * off;
    }
    // uniform: variance of a step over twelve
    CHECK(std::abs(sum / seeds) < 4 * 0.01 / std::sqrt(12.0 * seeds));
    CHECK(square / seeds == Approx(1e-4 / 12).epsilon(0.2));
}

TEST_CASE("two masses with a stiff spring move like one", "[gap]")
{
    const Joint one = sliding_mass(1, 0.3, 0.5);
    Joint two = one;
    two.mechanism.model = Model::two_mass;
    two.mechanism.motor_inertia = 0.4;
    two.mechanism.link_inertia = 0.6;
    two.mechanism.transmission.stiffness = 1e6;
    two.mechanism.transmission.damping = 300;
    two.frictions.motor = one.friction;
    CoulombViscous none;
    none.coulomb = none.viscous = 0;
    two.frictions.link.law = none;
    Record record = at_ticks(800, 1e-3);
    for (int k = 0; k < 400; ++k) record.effort_command[k] = 1 + std::sin(0.02 * k);
    const Ticks ticks = on_clock(record, one);
    Innovation a, b;
    predict(flatten(one), ticks, ticks.command, 0, a);
    predict(flatten(two), ticks, ticks.command, 0, b);
    CHECK(b.position[799] == Approx(a.position[799]).epsilon(2e-3));
}

namespace {

/// Motor 0.4 kg and link 0.6 kg with 20 mm of backlash; friction on the link only.
Joint playing_masses(double link_coulomb, double load)
{
    Joint joint = sliding_mass(1, 0, 0);
    CoulombViscous held;
    held.coulomb = link_coulomb;
    held.viscous = 0;
    joint.mechanism.model = Model::two_mass;
    joint.mechanism.motor_inertia = 0.4;
    joint.mechanism.link_inertia = 0.6;
    joint.mechanism.transmission.stiffness = 1e6;
    joint.mechanism.transmission.damping = 300;
    joint.mechanism.transmission.backlash = 0.02;
    joint.frictions.motor = joint.friction;
    joint.frictions.link = joint.friction;
    joint.frictions.link.law = held;
    joint.load.constant = load;
    return joint;
}

}  // namespace

TEST_CASE("a link that its friction holds starts in the middle of its backlash", "[gap]")
{
    for (const double load : {0.1, -0.1}) {
        Record record = at_ticks(300, 1e-3);
        for (double& u : record.effort_command) u = 1;
        const Joint joint = playing_masses(5, load);
        const Ticks ticks = on_clock(record, joint);
        Innovation run;
        predict(flatten(joint), ticks, ticks.command, 0, run);
        // free flight q = (u / 2 J) t² over half the backlash, then the link holds the motor
        const double contact = std::sqrt(2 * 0.01 * 0.4 / 1);
        const auto before = static_cast<std::size_t>(contact / 1e-3) - 1;
        CHECK(run.velocity[before] == Approx(before * 1e-3 / 0.4).epsilon(1e-6));
        CHECK(std::abs(run.velocity[before + 20]) < 0.8 * run.velocity[before]);
    }
}

TEST_CASE("whether a loaded link starts on its flank or falls through its backlash is told by the first moments",
          "[gap]")
{
    // 0.6 kg falls under 2 N through 10 mm, then takes 0.4 kg along: momentum says −t² + 0.6 · 10 mm; pressed from the
    // start both go as −t²
    const Joint joint = playing_masses(0, -2);
    for (const double head_start : {0.0, 0.006}) {
        Record record = at_ticks(400, 1e-3);
        for (std::size_t k = 0; k < record.rows(); ++k)
            record.position[k] = std::min(0.0, head_start - record.time[k] * record.time[k]);
        record.reference_position.assign(record.rows(), 0);
        const Ticks ticks = on_clock(record, joint);
        Innovation run;
        predict(flatten(joint), ticks, ticks.command, 0, run);
        CAPTURE(head_start);
        for (std::size_t k = 0; k < 75; ++k) REQUIRE(std::abs(run.position[k]) < 2e-5);
        // the impact rebounds a little
        for (std::size_t k = 75; k < record.rows(); ++k) REQUIRE(std::abs(run.position[k]) < 2e-3);
        const Trace again = simulate_closed_loop(flatten(joint), ticks, 0);
        CHECK((again.true_position[60] == 0) == (head_start > 0));
    }
}

TEST_CASE("an observer on the motor carries along a link that presses on it", "[gap]")
{
    const Joint two = playing_masses(0, -2);
    Joint one = sliding_mass(1, 0, 0);
    one.load.constant = -2;
    Record record = at_ticks(600, 1e-3);
    for (double& u : record.effort_command) u = 2;
    for (std::size_t k = 100; k < record.rows(); ++k) record.position[k] = 1e-3;  // the encoder says it moved
    for (const double omega : {110.0, 20.0}) {
        Innovation divided, whole;
        const Ticks of_two = on_clock(record, two), of_one = on_clock(record, one);
        predict(flatten(two), of_two, of_two.command, omega, divided);
        predict(flatten(one), of_one, of_one.command, omega, whole);
        for (std::size_t k = 100; k < record.rows(); ++k)
            REQUIRE(divided.position[k] == Approx(whole.position[k]).margin(2e-5));
    }
}

TEST_CASE("a supply sags by its resistance times the current, whichever way that flows", "[gap]")
{
    Actuator a;
    a.kind = ActuatorKind::dc_motor;
    a.signal = DriveSignal::duty;
    a.k_t = 0.3, a.k_e = 0.3, a.resistance = 4, a.supply_resistance = 0.7;
    for (const double duty : {-1.0, -0.4, 0.0, 0.3, 1.0})
        for (const double speed : {-50.0, -20.0, -3.0, 0.0, 5.0, 30.0, 50.0}) {
            const double current = push_of(a, duty, 12, speed).at(speed) / a.k_t;
            CAPTURE(duty, speed);
            CHECK(a.resistance * current ==
                  Approx(duty * (12 - a.supply_resistance * std::abs(current)) - a.k_e * speed).margin(1e-12));
        }
}
