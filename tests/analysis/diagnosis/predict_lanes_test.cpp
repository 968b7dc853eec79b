#include "analysis/diagnosis/plant/helpers.h"
#include "analysis/diagnosis/plant/observer.h"
#include "analysis/diagnosis/plant/simulator.h"
#include "analysis/simulation/lanes/instructions.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>

using namespace stickslip;
using namespace stickslip::gap;

namespace {

constexpr double period = 1e-3;

/// Ticks under a command that starts, stops and turns a joint around.
Ticks some_ticks(std::size_t count, double size, double phase)
{
    Ticks t;
    for (std::size_t k = 0; k < count; ++k) {
        t.time.push_back(static_cast<double>(k) * period), t.step.push_back(period);
        t.position.push_back(1e-3 * std::sin(0.02 * static_cast<double>(k) + phase));
        t.command.push_back(size * std::sin(0.013 * static_cast<double>(k) + phase));
        for (auto* column : {&t.reference, &t.reference_rate, &t.velocity, &t.supply}) column->push_back(not_set);
        t.effort.push_back(t.command.back());
        t.enabled.push_back(k % 97 != 50), t.logged.push_back(k % 2 == 0);
    }
    t.source = CommandSource::logged;
    return t;
}

/// Joints of every kind of term, by number.
Plant some_plant(int i)
{
    Plant p;
    p.motor_inertia = 0.02;
    p.motor.coulomb = 0.3 + 0.01 * i, p.motor.viscous = 0.05;
    const int terms = i % 12;
    if (terms == 1 || terms == 9) p.motor.stribeck = 0.2, p.motor.stribeck_velocity = 0.1, p.motor.exponent = 1.5;
    if (terms == 2) p.motor.asymmetric_coulomb = 0.05, p.motor.asymmetric_viscous = 0.01;
    if (terms == 3) p.motor.bristle_stiffness = 300, p.motor.bristle_damping = 0.1;
    if (terms == 4)
        p.motor.A = 0.01, p.motor.B = 0.02, p.motor.L = 0.01, p.motor.V_star = 0.1, p.motor.per_L = 100,
        p.motor.per_V_star = 10, p.motor.ageing = i % 24 > 12;
    if (terms == 5) p.load.gravity_amplitude = 0.4, p.load.cogging.amplitude = 0.1, p.load.cogging.periods = 40;
    if (terms == 5 && i % 3 > 0) p.load.cogging.second_amplitude = 0.04, p.load.cogging.second_phase = 0.01 * i;
    if (terms == 7) p.motor.second_ripple = 0.02, p.motor.second_phase = 0.01 * i;
    if (terms == 6) p.actuator.lag = 2e-3, p.dead_time = 1.7e-3;
    if (terms == 7) p.motor.drift = 0.1, p.motor.drift_time = 0.2, p.motor.ripple = 0.05, p.motor.ripple_periods = 30;
    if (terms == 8) p.motor.lag = 0.02, p.motor.lag_viscous = true, p.actuator.limit = 0.8;
    if (terms >= 9) {
        p.two_mass = true, p.link_inertia = 0.03, p.stiffness = 400 + 10 * i, p.damping = 0.02;
        p.link.coulomb = 0.1, p.backlash = terms == 11 ? 0.01 : 0, p.load.constant = 0.05;
    }
    p.actuator.effort_gain = 1;
    return p;
}

bool same_bits(const std::vector<double>& a, const std::vector<double>& b)
{
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

}  // namespace

TEST_CASE("a prediction has the same bits alone, among others and on every instruction set", "[gap][lanes]")
{
    constexpr int count = 48;
    std::vector<Ticks> records;
    for (int i = 0; i < 5; ++i) records.push_back(some_ticks(500 + 37 * static_cast<std::size_t>(i), 1.2, 0.3 * i));
    records[3].restarts = {{200, 0.1, 0}, {330, -0.05, 0}};
    std::vector<Innovation> together(count), again(count), between(count);
    std::vector<Prediction> all;
    for (int i = 0; i < count; ++i) {
        const Ticks& t = records[static_cast<std::size_t>(i) % records.size()];
        all.push_back({some_plant(i), &t, t.command, i % 3 ? 50.0 : 110.0, &together[static_cast<std::size_t>(i)]});
    }
    predict_all(all);
    const std::string widest(lanes::name_of(lanes::best_instructions()));
    lanes::use_instructions("baseline");
    for (std::size_t i = 0; i < all.size(); ++i) all[i].out = &again[i];
    predict_all(all);
    if (widest == "avx512") lanes::use_instructions("avx2");
    for (std::size_t i = 0; i < all.size(); ++i) all[i].out = &between[i];
    predict_all(all);
    lanes::use_instructions(widest);
    for (std::size_t i = 0; i < all.size(); ++i) {
        Innovation alone;
        predict(all[i].plant, *all[i].ticks, all[i].command, all[i].omega, alone);
        CAPTURE(i);
        double moved = 0;
        for (const double v : alone.velocity) moved = std::max(moved, std::abs(v));
        CHECK(moved > 1e-3);
        CHECK(std::isfinite(moved));
        for (const auto* other : {&together[i], &again[i], &between[i]}) {
            CHECK(same_bits(alone.position, other->position));
            CHECK(same_bits(alone.effort, other->effort));
            CHECK(same_bits(alone.velocity, other->velocity));
            CHECK(same_bits(alone.predicted_effort, other->predicted_effort));
        }
    }
}

TEST_CASE("a form that is known as the program is built has the bits of one that is told", "[gap][lanes]")
{
    using One = lanes::Pack<1, 1>;
    Ticks ticks = some_ticks(400, 1.2, 0.3);
    for (auto& v : ticks.supply) v = 20;
    for (const int terms : {0, 5, 6, 10, 11})
        for (const bool motor : {false, true}) {
            CAPTURE(terms, motor);
            Plant plant = some_plant(terms);
            plant.backlash = terms == 11 ? 1e-3 : 0;
            if (motor) {
                plant.actuator.kind = ActuatorKind::dc_motor;
                plant.actuator.k_t = plant.actuator.k_e = 0.4, plant.actuator.resistance = 0.5;
                plant.actuator.supply_resistance = 0.1, plant.actuator.limit = 0.7;
                if (terms == 10) plant.dead_time = 1.3e-3;
            }
            const Kind kind = kind_of(plant, ticks);
            const Form known[] = {one_mass, two_masses, with_backlash};
            CHECK(std::count(std::begin(known), std::end(known), static_cast<const Form&>(kind)) == 1);
            std::vector<double> told(ticks.size()), built(ticks.size());
            Run run{&plant,        &ticks, ticks.command, 50,      0,       ticks.size(),
                    Rest::pressed, 0.1,    told.data(),   nullptr, nullptr, nullptr};
            Observer<One>(kind).through({&run, 1});
            run.position = built.data();
            through<One>({&run, 1}, kind);
            CHECK(same_bits(told, built));
        }
}

TEST_CASE("threads without a task help with the predictions of others, which changes none", "[gap][lanes]")
{
    const Ticks ticks = some_ticks(500, 1.2, 0.3);
    std::size_t shared = 0;
    const ParallelFor backwards = [&](std::size_t n, const std::function<void(std::size_t)>& task) {
        ++shared;
        for (std::size_t i = n; i-- > 0;) task(i);
    };
    for (const std::size_t count : {1u, 4u, 8u, 21u}) {
        CAPTURE(count);
        std::vector<Innovation> alone(count), helped(count);
        std::vector<Prediction> all;
        for (std::size_t i = 0; i < count; ++i) {
            Plant plant = some_plant(10);
            plant.motor.viscous += 0.01 * static_cast<double>(i);
            plant.load.constant = 0;  // else predictions of both ways to rest come first
            all.push_back({plant, &ticks, ticks.command, 50, &alone[i]});
        }
        Unbegun unbegun{1};
        {
            const Helpers helpers(backwards, &unbegun);
            predict_all(all);  // the others still have work
            CHECK(shared == 0);
            unbegun = 0;
            for (std::size_t i = 0; i < count; ++i) all[i].out = &helped[i];
            predict_all(all);
            CHECK((shared > 0) ==
                  (count == 21 || (count == 8 && lanes::best_instructions() != lanes::Instructions::avx512)));
        }
        CHECK(Helpers::of_this_thread() == nullptr);
        shared = 0;
        for (std::size_t i = 0; i < count; ++i) CHECK(same_bits(alone[i].position, helped[i].position));
    }
}

TEST_CASE("packs: sine and logarithm against libm", "[lanes]")
{
    for (double x = -900; x < 900; x += 0.171)
        CHECK(lanes::sine(lanes::Pack<2, 2>(x))[3] == Approx(std::sin(x)).epsilon(0).margin(3e-16));
    for (const double x : {3e7, -1e12, 0.0, 1e-300}) CHECK(lanes::sine(lanes::Pack<2, 2>(x))[0] == std::sin(x));
    for (double x = 1e-290; x < 1e290; x *= 1.37)
        CHECK(lanes::logarithm(lanes::Pack<2, 2>(x))[2] == Approx(std::log(x)).epsilon(4e-16));
    for (double d = 1e-15; d < 0.3; d *= 1.7)
        CHECK(lanes::logarithm(lanes::Pack<1, 1>(1 + d))[0] == Approx(std::log(1 + d)).epsilon(4e-16));
}
