#include "analysis/diagnosis/audit/effort_drive.h"

#include "analysis/diagnosis/plant/simulator.h"
#include "analysis/diagnosis/policy/audit.h"
#include "tests/analysis/diagnosis/answers.h"
#include "tests/analysis/diagnosis/small_machine.h"
#include "tests/in_order.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace stickslip;
using namespace stickslip::gap;
using test::Machine;

namespace {

/// What a bus of joint states holds: no command, and of the controller nothing.
Record without_command(const Machine& m, unsigned seed, bool with_reference)
{
    Record r = test::record_of(m, seed);
    r.effort_command.clear();
    if (!with_reference) r.reference_position.clear(), r.reference_velocity.clear();
    return r;
}

bool has_note(const std::vector<Note>& notes, Note::Code code)
{
    return std::any_of(notes.begin(), notes.end(), [&](const Note& n) { return n.code == code; });
}

Machine with_torque_sensor()
{
    Machine m;
    m.effort_noise = 0.01;
    return m;
}

}  // namespace

TEST_CASE("the noise of a measured effort shows in the innovation as a stationary process says", "[diagnosis][drive]")
{
    // a free mass under white kicks in velocity, s.d. 1 per reading, and the observer's own correction: what the
    // innovation's variance is in the long run
    const double omega = 50, step = 1e-3;
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    double q = 0, v = 0, squares = 0;
    const int rows = 2'000'000;
    for (int k = 0; k < rows; ++k) {
        const double e = q;
        squares += e * e;
        q -= 1.6 * omega * step * e, v -= omega * omega * step * e;
        v += normal(random);
        q += step * v;
    }
    CHECK(kick_amplification(omega, step) == Approx(squares / rows).epsilon(0.03));
    // e″ + 2ζω e′ + ω²e = w has the variance S/(4ζω³) with the density S = 1/T of kicks a second apart by T
    CHECK(kick_amplification(omega, 1e-5) == Approx(1 / (1e-5 * 4 * 0.8 * omega * omega * omega)).epsilon(0.01));
}

TEST_CASE("a log of position and effort alone tells what the joint lacks", "[diagnosis][drive][slow]")
{
    Machine m = with_torque_sensor();
    m.gravity = 6;
    m.amplitude = 5;
    const std::vector<Record> records{without_command(m, 1, false), without_command(m, 2, false)};
    const auto result = test::answer(test::nominal_arm(), records, test::in_order);
    CHECK(has_note(result.diagnosis.notes, Note::Code::driven_by_effort));
    REQUIRE(result.diagnosis.verdict == Verdict::gap);
    CHECK(result.diagnosis.effects[0].names == std::vector<std::string>{"gravity"});
    CHECK(result.after.load.gravity_amplitude == Approx(6).epsilon(0.02));
    // no loop can be simulated: the page shows what the joint predicts along the motion, before and after
    REQUIRE(result.diagnosis.traces.size() == 2);
    for (const auto& trace : result.diagnosis.traces) {
        CHECK(trace.predicted);
        double before = 0, after = 0;
        for (std::size_t k = 0; k < trace.time.size(); ++k) {
            before += std::pow(trace.measured[k] - trace.before[k], 2);
            after += std::pow(trace.measured[k] - trace.after[k], 2);
        }
        CHECK(after < 0.2 * before);
        CHECK(trace.effort_measured.empty());  // it drives the joint
    }
}

TEST_CASE("a joint that is its document has no gap where its measured effort drives it", "[diagnosis][drive][slow]")
{
    const Machine m = with_torque_sensor();
    const std::vector<Record> records{without_command(m, 1, false), without_command(m, 2, false)};
    const auto result = test::answer(test::nominal_joint(), records, test::in_order);
    CHECK(result.diagnosis.verdict == Verdict::no_gap);
}

TEST_CASE("a controller that did not run as documented leaves the effort to drive the joint", "[diagnosis][drive]")
{
    Machine m = with_torque_sensor();
    m.k_i = 20000;
    m.load = -8;
    std::vector<Record> records{without_command(m, 1, true)};
    std::vector<Note> notes;
    drive_by_effort(records, test::nominal_joint(), notes);
    REQUIRE(has_note(notes, Note::Code::another_controller));
    CHECK(records[0].reference_position.empty());
    const auto& values = notes.back().values;
    CHECK(values[0] > policy::made_by_controller);
    CHECK(values[1] < 0.01);
    CHECK(values[4] == Approx(m.k_i).epsilon(0.05));
}

TEST_CASE("a controller that differs by its gains or behind a limit is still the documented one", "[diagnosis][drive]")
{
    Machine m = with_torque_sensor();
    SECTION("half the gain")
    {
        m.k_p /= 2;
    }
    SECTION("an actuator that gives less")
    {
        m.gain = 0.7;
    }
    SECTION("a limit")
    {
        m.limit = 3;
    }
    SECTION("a limit under a derivative that makes noise of its own")
    {
        m.limit = 3;
        m.noise = 1e-4;
    }
    SECTION("a feed-forward that makes most of the effort")
    {
        m.fed = m.inertia, m.pushed = m.coulomb;
    }
    std::vector<Record> records{without_command(m, 1, true)};
    std::vector<Note> notes;
    drive_by_effort(records, test::nominal_joint(), notes);
    CHECK(notes.empty());
    CHECK_FALSE(records[0].reference_position.empty());
}

TEST_CASE("of a PID that made the effort the gains that differ from the document are named, the others not",
          "[diagnosis][drive]")
{
    Machine m = with_torque_sensor();
    m.k_i = 20000;
    m.k_p *= 1.5;
    m.load = -8;
    std::vector<Record> records{without_command(m, 1, true)};
    std::vector<Note> notes, reasons;
    std::vector<Case> cases(1);
    cases[0].joint = test::nominal_joint();
    cases[0].joint.control.structure = Structure::pid;
    const EffortDrive drive = drive_by_effort(records, test::nominal_joint(), notes);
    Audit audit;
    audit_effort(drive, cases, audit, reasons);
    REQUIRE(audit.findings.size() == 2);
    CHECK(audit.findings[0].effect == "gain-k_i");
    CHECK(audit.findings[0].value == Approx(20000).epsilon(0.05));
    CHECK(audit.findings[1].effect == "gain-k_p");
    CHECK(audit.findings[1].value == Approx(1.5).epsilon(0.03));
    CHECK(cases[0].joint.control.k_p == Approx(m.k_p).epsilon(0.03));
    CHECK(cases[0].joint.control.k_v == test::nominal_joint().control.k_v);
}
