#include "analysis/diagnosis/heldout/heldout.h"
#include "analysis/diagnosis/audit/audit.h"
#include "analysis/diagnosis/audit/prepare.h"
#include "analysis/diagnosis/audit/reading_noise.h"
#include "analysis/diagnosis/fit/candidate_numbers.h"
#include "analysis/diagnosis/fit/corrections.h"
#include "analysis/diagnosis/fit/problem.h"
#include "analysis/diagnosis/heldout/ensemble.h"
#include "analysis/diagnosis/policy/ladder.h"
#include "tests/analysis/diagnosis/small_machine.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <random>

using namespace stickslip;
using namespace stickslip::gap;

TEST_CASE("a record that alone reaches the limit is held out in thirds, one of many that show friction whole", "[gap]")
{
    test::Machine m;
    m.limit = 4, m.coulomb = 2.3;  // documented: no limit, 2 N
    std::vector<Case> cases;
    std::vector<Note> notes;
    for (const auto& [seed, amplitude] : {std::pair{1u, 1.0}, {2u, 0.2}, {3u, 0.2}}) {
        m.amplitude = amplitude;
        cases.push_back(prepare(test::record_of(m, seed), test::nominal_joint(), notes));
        cases.back().number = cases.size() - 1;
    }
    const Scales scales = scales_of(cases);
    const auto cause = [&](const char* name, double value) {
        Attribution a;
        a.candidate = {{effect_named(name)}, {&effect_named(name)->forms[0]}, cases.size()};
        a.x.fill(to_fit(a.candidate, {value}));
        return a;
    };
    const auto saturated = folds_for(cases, scales, cause("saturation", m.limit / scales.peak_effort));
    REQUIRE(saturated.size() == 5);
    for (std::size_t i = 0; i < 3; ++i) CHECK(saturated[i].record == 0);
    CHECK(saturated[0].to == saturated[1].from);
    CHECK(saturated[1].to == Approx(4).margin(0.01));  // of six seconds
    CHECK(saturated[2].to == infinity);
    // what is left out is left out of the fit, and nothing else
    const auto rest = without(cases, saturated[1]);
    REQUIRE(rest.size() == 3);
    CHECK_FALSE(rest[0].judged(3000));
    CHECK(rest[0].judged(1000));

    CHECK(folds_for(cases, scales, cause("coulomb-level", 0.3 / scales.effort)).size() == 3);
}

TEST_CASE("floors are of the joint in question: the steps of a coarser encoder than documented are gap, not noise",
          "[gap]")
{
    test::Machine m;
    m.quantum = 1e-4;  // documented: 5 µm
    std::vector<Note> notes;
    const Joint documented = test::nominal_joint();
    Case c = prepare(test::record_of(m, 1), documented, notes);
    Joint audited = c.joint;
    audited.sensor.encoder_quantum = m.quantum;
    const auto floor_of = [&](const Joint& joint) {
        const auto squares = compare(c, joint, 4, -infinity, infinity);
        REQUIRE(squares[0].signal == "position");
        return squares[0].floor;
    };
    const double before = floor_of(documented);
    c.joint = audited;
    c.sigma = reading_sigma(audited.sensor, 0);  // as an audit leaves it
    CHECK(floor_of(documented) == before);
    const double steps = m.quantum * m.quantum / 12;
    CHECK(before < 0.1 * steps);
    CHECK(floor_of(audited) >= 0.5 * steps);
    c.noise_documented = false;  // below its steps nothing is known of the joint, documented or audited
    CHECK(floor_of(documented) >= 0.5 * steps);
}

TEST_CASE("two joints whose encoder steps lie anywhere differ by about the floor of these steps", "[gap]")
{
    std::vector<Note> notes;
    const Case c = prepare(test::record_of({}, 1, 2), test::nominal_joint(), notes);
    Joint joint = c.joint;
    const double finer = joint.sensor.encoder_quantum, step = joint.sensor.encoder_quantum = 5e-4;
    std::mt19937 random(3);
    std::uniform_real_distribution<double> anywhere(0, step);
    const auto elsewhere = [&] {
        Ticks ticks = c.ticks;
        const double by = anywhere(random);
        for (double& x : ticks.reference) x += by;
        for (double& x : ticks.position) x += by;
        Trace trace = simulate_closed_loop(flatten(joint), ticks, 1);
        for (double& x : trace.position) x -= by;
        return trace;
    };
    constexpr int pairs = 8;
    double of_position = 0, of_command = 0;
    for (int i = 0; i < pairs; ++i) {
        const Trace one = elsewhere(), other = elsewhere();
        const auto n = static_cast<double>(pairs * one.position.size());
        for (std::size_t k = 0; k < one.position.size(); ++k) {
            of_position += std::pow(one.position[k] - other.position[k], 2) / n;
            of_command += std::pow(one.command[k] - other.command[k], 2) / n;
        }
    }
    std::vector<SignalSquares> squares(2);
    squares[0].signal = "position", squares[1].signal = "effort_command";
    raise_floor_to_steps(c, joint, finer, squares);
    CHECK(squares[0].floor == Approx(of_position).epsilon(0.5));
    CHECK(squares[1].floor == Approx(of_command).epsilon(0.5));
    // the derivative makes more of a step than the stiffness does
    CHECK(squares[1].floor > 4 * std::pow(joint.control.k_p, 2) * step * step / 6);
    squares[0].floor = 1;
    raise_floor_to_steps(c, joint, finer, squares);
    CHECK(squares[0].floor == 1);
}

TEST_CASE("a nominal simulation that is unstable at its rate is no noise floor", "[gap]")
{
    test::Machine m;
    std::vector<Note> notes;
    Joint delayed = test::nominal_joint();
    delayed.control.delay = 0.03;  // 45 N·s/m on 1.2 kg forgets in 27 ms: the loop swings up to its limit
    delayed.control.effort_limit = 40;
    const std::vector<Case> cases{prepare(test::record_of(m, 1), delayed, notes)};
    CHECK_FALSE(closed_loop_at_floor(cases, {}, {}, [](std::size_t n, const auto& task) {
        for (std::size_t i = 0; i < n; ++i) task(i);
    }));
}

TEST_CASE("a number that is kept stays where it is, whatever its prior says", "[gap]")
{
    // the level of the record that is held out once went back to that of the document in this way
    test::Machine sticky, easy;
    sticky.coulomb = 2.3, easy.coulomb = 1.8;
    std::vector<Note> notes;
    std::vector<Case> cases;
    for (const auto& machine : {sticky, easy}) {
        cases.push_back(prepare(test::record_of(machine, 1, 3), test::nominal_joint(), notes));
        cases.back().number = cases.size() - 1;
    }
    const Scales scales = scales_of(cases);
    const Corrections corrections(cases, scales, policy::correction_prior);
    const Corrected model = corrections.beside({});
    const Candidate& all = model.candidate;
    Eigen::VectorXd x = Corrections::start(model, model, {}, {});
    Kept kept(all.parameter_count(), 0);
    bool any = false;
    constexpr double own = 0.02;  // within what a prior allows
    for (std::size_t i = 0; i < kept.size(); ++i)
        if (record_of(all, i) == std::optional<std::size_t>(0))
            kept[i] = 1, any = true, x[static_cast<Eigen::Index>(i)] = own;
    REQUIRE(any);
    const auto fit = descend({{cases[1]}, all, scales, levels[1]}, x, 3, kept);
    for (std::size_t i = 0; i < kept.size(); ++i)
        if (kept[i]) CHECK(fit.x[static_cast<Eigen::Index>(i)] == own);
    CHECK(fit.x != x);
}
