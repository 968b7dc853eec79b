#include "analysis/diagnosis/rig/rig.h"
#include "tests/in_order.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <random>

using namespace stickslip;
using namespace stickslip::gap;

namespace {

constexpr double slow = 3e-6, quick = 10e-6, step_at = 30;  // m/s, s
constexpr double stiffness = 3000, A = 0.008, B = 0.009, L = 6e-6;

double load_point(double t)
{
    return slow * std::min(t, step_at) + quick * std::max(0.0, t - step_at);
}

/// A velocity step as a laboratory logs it: 10 rows a second, 100 after the step. `friction_at` is asked in order.
template <class Friction>
Record velocity_step(Friction friction_at, double noise)
{
    Record r;
    r.name = "step";
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    for (int k = 0; k < 300 + 600; ++k) {
        const double t = k < 300 ? 0.1 * k : step_at + 0.01 * (k - 300);
        r.time.push_back(t);
        r.reference_position.push_back(load_point(t));
        r.effort_measured.push_back(0.6 + friction_at(t) + noise * normal(random));
    }
    return r;
}

/// Slip law behind a spring, by classical Runge-Kutta in steps of 0.1 ms at most.
struct SlipLaw {
    double B = ::B, L = ::L;
    double t = 0, slip = 0, theta = 0;
    std::pair<double, double> rate(double at, double s, double th) const
    {
        const double v = slow * std::exp((stiffness * (load_point(at) - s) - th) / A);
        return {v, -v / L * (th + B * std::log(v / slow))};
    }
    double operator()(double until)
    {
        while (t < until - 1e-9) {
            const double h = std::min(1e-3, until - t);
            const auto [a1, b1] = rate(t, slip, theta);
            const auto [a2, b2] = rate(t + h / 2, slip + h / 2 * a1, theta + h / 2 * b1);
            const auto [a3, b3] = rate(t + h / 2, slip + h / 2 * a2, theta + h / 2 * b2);
            const auto [a4, b4] = rate(t + h, slip + h * a3, theta + h * b3);
            slip += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4), theta += h / 6 * (b1 + 2 * b2 + 2 * b3 + b4);
            t += h;
        }
        return stiffness * (load_point(until) - slip);
    }
};

double number(const Cause& cause, const std::string& name)
{
    for (const auto& p : cause.parameters)
        if (p.name == name) return p.value;
    FAIL("no parameter " << name);
    return 0;
}

}  // namespace

TEST_CASE("a velocity step of a rig with memory is named, with its numbers, and its law is called ambiguous",
          "[gap][slow]")
{
    const auto d = diagnose_rig({}, {velocity_step(SlipLaw{}, 8e-4)}, test::in_order).diagnosis;
    REQUIRE(d.verdict == Verdict::gap);
    REQUIRE(d.effects.at(0).names == std::vector<std::string>{"frictional-memory"});
    CHECK(d.effects[0].probability > 0.9);
    // the peak is A ln(10/3) = 0.0096, twelve times the noise, and lasts about 2 s
    CHECK(number(d.effects[0], "frictional-memory.A") == Approx(A).epsilon(0.15));
    CHECK(number(d.effects[0], "frictional-memory.L") == Approx(L).epsilon(0.3));
    CHECK(number(d.effects[0], "frictional-memory.A") - number(d.effects[0], "frictional-memory.B") ==
          Approx(A - B).margin(2e-4));
    CHECK(d.ambiguous_with == std::vector<std::vector<std::string>>{{"frictional-memory"}});
    // all its laws in one remark, that by which it is named first
    std::vector<Note> alike;
    std::copy_if(d.reasons.begin(), d.reasons.end(), std::back_inserter(alike),
                 [](const Note& note) { return note.code == Note::Code::rig_laws_alike; });
    REQUIRE(alike.size() == 1);
    CHECK(alike[0].names.size() >= 3);
    CHECK(d.effects[0].form.starts_with(alike[0].names.at(1)));
    CHECK(d.gap.at(0).floor == Approx(8e-4).epsilon(0.1));
    REQUIRE(d.next_experiment.separates.size() == 1);
    CHECK(d.next_experiment.time.size() == d.next_experiment.reference.size());
}

TEST_CASE("a rig whose friction follows the speed at once has no memory", "[gap][slow]")
{
    const auto follows = [](double t) { return t < step_at ? 0.0 : 0.01; };
    const auto d = diagnose_rig({}, {velocity_step(follows, 8e-4)}, test::in_order).diagnosis;
    REQUIRE(d.verdict == Verdict::gap);
    CHECK(d.effects.at(0).names != std::vector<std::string>{"frictional-memory"});
}

TEST_CASE("a rig with a constant friction has no gap", "[gap][slow]")
{
    const auto d = diagnose_rig({}, {velocity_step([](double) { return 0.0; }, 8e-4)}, test::in_order).diagnosis;
    CHECK(d.verdict == Verdict::no_gap);
    CHECK(d.effects.empty());
}

TEST_CASE("a gouge that strengthens with memory is named with a negative B and a slip distance within its travel",
          "[gap][slow]")
{
    const double strengthening = -0.007, distance = 20e-6;
    const auto d = diagnose_rig({}, {velocity_step(SlipLaw{strengthening, distance}, 3e-4)}, test::in_order).diagnosis;
    REQUIRE(d.verdict == Verdict::gap);
    REQUIRE(d.effects.at(0).names == std::vector<std::string>{"frictional-memory"});
    CHECK(number(d.effects[0], "frictional-memory.B") == Approx(strengthening).epsilon(0.25));
    CHECK(number(d.effects[0], "frictional-memory.L") < 0.5 * load_point(36));
    CHECK(number(d.effects[0], "frictional-memory.L") == Approx(distance).epsilon(0.4));
}

TEST_CASE("a friction that rises with the logarithm of speed at once is viscous, no Stribeck curve", "[gap][slow]")
{
    const auto rises = [](double t) { return t < step_at ? 0.0 : 0.02 * std::log(quick / slow); };
    const auto d = diagnose_rig({}, {velocity_step(rises, 8e-4)}, test::in_order).diagnosis;
    REQUIRE(d.verdict == Verdict::gap);
    CHECK(d.effects.at(0).names == std::vector<std::string>{"viscous"});
}

TEST_CASE("a few rows behind a turn of the load point are not judged", "[gap][slow]")
{
    Record r = velocity_step(SlipLaw{}, 8e-4);
    const double end = r.time.back(), place = r.reference_position.back();
    for (int k = 1; k <= 100; ++k) {
        r.time.push_back(end + 0.1 * k);
        r.reference_position.push_back(place - 3e-6 * 0.1 * k);
        r.effort_measured.push_back(-0.6);  // friction turns with the motion
    }
    const auto d = diagnose_rig({}, {r}, test::in_order).diagnosis;
    REQUIRE(d.verdict == Verdict::gap);
    CHECK(d.effects.at(0).names == std::vector<std::string>{"frictional-memory"});
    CHECK(number(d.effects[0], "frictional-memory.A") == Approx(A).epsilon(0.2));
}

TEST_CASE("friction that follows a known normal load depends on the load", "[gap][slow]")
{
    Record r = velocity_step([](double t) { return 0.6 * 0.1 * std::sin(t); }, 8e-4);
    for (const double t : r.time) r.normal_load.push_back(1 + 0.1 * std::sin(t));
    const auto d = diagnose_rig({}, {r}, test::in_order).diagnosis;
    REQUIRE(d.verdict == Verdict::gap);
    CHECK(d.effects.at(0).names == std::vector<std::string>{"load-dependent-friction"});
    CHECK(number(d.effects[0], "load-dependent-friction.coefficient") == Approx(0.6).epsilon(0.02));
}

namespace {

/// Slip law behind a spring in both directions, by classical Runge-Kutta: the slider moves as the spring pulls it, its
/// friction against the motion, the state goes on over the turn.
struct BothWays {
    double stiffness, level;
    std::vector<std::pair<double, double>> speeds;  ///< of the load point: until when, how fast
    double t = 0, slip = -level / stiffness, theta = 0;

    double load(double at) const
    {
        double x = 0, from = 0;
        for (const auto& [until, speed] : speeds) {
            x += speed * (std::min(at, until) - from);
            if (at <= until) break;
            from = until;
        }
        return x;
    }
    double force(double at) const { return stiffness * (load(at) - slip); }
    std::pair<double, double> rate(double at, double s, double th) const
    {
        const double pull = stiffness * (load(at) - s), v = slow * std::exp((std::abs(pull) - level - th) / A);
        return {std::copysign(v, pull), -v / L * (th + B * std::log(v / slow))};
    }
    void go_to(double until)
    {
        while (t < until - 1e-9) {
            const double h = std::min(1e-3, until - t);
            const auto [a1, b1] = rate(t, slip, theta);
            const auto [a2, b2] = rate(t + h / 2, slip + h / 2 * a1, theta + h / 2 * b1);
            const auto [a3, b3] = rate(t + h / 2, slip + h / 2 * a2, theta + h / 2 * b2);
            const auto [a4, b4] = rate(t + h, slip + h * a3, theta + h * b3);
            slip += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4), theta += h / 6 * (b1 + 2 * b2 + 2 * b3 + b4);
            t += h;
        }
    }
    /// `rows` a second, with noise.
    Record record(const std::string& name, double rows, double noise)
    {
        Record r;
        r.name = name;
        std::mt19937 random(11);
        std::normal_distribution<double> normal;
        for (int k = 0; k < speeds.back().first * rows; ++k) {
            go_to(k / rows);
            r.time.push_back(t);
            r.reference_position.push_back(load(t));
            r.effort_measured.push_back(force(t) + noise * normal(random));
        }
        return r;
    }
};

}  // namespace

TEST_CASE("one law with one set of numbers answers several records of a rig, each with its own level", "[gap][slow]")
{
    std::vector<Record> records;
    // a step up, a step down, and one that begins at another speed than the first
    records.push_back(BothWays{3000, 0.55, {{20, slow}, {25, quick}}}.record("up", 20, 8e-4));
    records.push_back(BothWays{3000, 0.66, {{8, quick}, {30, slow}}}.record("down", 20, 8e-4));
    records.push_back(BothWays{3000, 0.60, {{10, 3 * slow}, {14, 9 * slow}}}.record("quicker", 40, 8e-4));
    for (auto& r : records) {  // the slider already slides at the first speed
        const double settled = 4;
        const auto first = static_cast<std::ptrdiff_t>(std::ranges::lower_bound(r.time, settled) - r.time.begin());
        for (auto* column : {&r.time, &r.reference_position, &r.effort_measured})
            column->erase(column->begin(), column->begin() + first);
    }
    const auto d = diagnose_rig({}, records, test::in_order).diagnosis;
    REQUIRE(d.verdict == Verdict::gap);
    REQUIRE(d.effects.at(0).names == std::vector<std::string>{"frictional-memory"});
    CHECK(d.records.size() == 3);
    CHECK(d.traces.size() == 3);
    CHECK(number(d.effects[0], "frictional-memory.A") == Approx(A).epsilon(0.1));
    CHECK(number(d.effects[0], "frictional-memory.L") == Approx(L).epsilon(0.2));
    CHECK(number(d.effects[0], "frictional-memory.A") - number(d.effects[0], "frictional-memory.B") ==
          Approx(A - B).margin(2e-4));
    CHECK(d.gap.at(0).after == Approx(d.gap.at(0).floor).epsilon(0.1));
}

TEST_CASE("both directions of a reversing rig are judged, without the unloading of the spring between them",
          "[gap][slow]")
{
    // 0.6 over 30 000 per metre: the spring turns from one side to the other over 40 um, 4 s
    BothWays rig{30000, 0.6, {{20, slow}, {26, quick}, {40, -quick}, {60, -slow}}};
    const auto r = rig.record("to and fro", 20, 8e-4);
    const auto d = diagnose_rig({}, {r}, test::in_order).diagnosis;
    REQUIRE(d.verdict == Verdict::gap);
    CHECK(d.effects.at(0).names == std::vector<std::string>{"frictional-memory"});
    REQUIRE(d.traces.size() == 2);
    std::vector<std::vector<double>> rows;
    for (const auto& note : d.notes)
        if (note.code == Note::Code::rig_turns_round) rows.push_back(note.values);
    REQUIRE(rows.size() == 2);
    CHECK(rows[0][0] == 1);
    CHECK(rows[1][0] > 20 * 29);  // behind the 4 s that the spring takes
    CHECK(rows[1][0] < 20 * 32);
    CHECK(number(d.effects[0], "frictional-memory.A") == Approx(A).epsilon(0.2));
    // against the motion in both directions
    for (const auto& trace : d.traces) CHECK(*std::ranges::min_element(trace.effort_measured) > 0);
}

TEST_CASE("records under different normal loads name the load, with its coefficient", "[gap]")
{
    std::vector<Record> records;
    std::mt19937 random(5);
    std::normal_distribution<double> normal;
    for (const double load : {10.0, 20.0, 40.0}) {
        Record r;
        r.name = std::to_string(load);
        for (int k = 0; k < 300; ++k) {
            r.time.push_back(0.1 * k);
            r.reference_position.push_back(slow * r.time.back());
            r.effort_measured.push_back(1.5 + 0.6 * load + 0.05 * normal(random));
            r.normal_load.push_back(load);
        }
        records.push_back(r);
    }
    const auto d = diagnose_rig({}, records, test::in_order).diagnosis;
    REQUIRE(d.verdict == Verdict::gap);
    CHECK(d.effects.at(0).names == std::vector<std::string>{"load-dependent-friction"});
    CHECK(number(d.effects[0], "load-dependent-friction.coefficient") == Approx(0.6).epsilon(0.01));
}
