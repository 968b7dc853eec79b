#include "analysis/diagnosis/audit/audit.h"
#include "analysis/diagnosis/audit/prepare.h"
#include "analysis/diagnosis/fit/jumps.h"
#include "analysis/diagnosis/search/attribute.h"
#include "tests/analysis/diagnosis/record_rows.h"
#include "tests/analysis/diagnosis/small_machine.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace stickslip;
using namespace stickslip::gap;
using stickslip::test::Machine;

namespace {

/// A record of the machine from which the reference was left out, and what it was.
std::pair<std::vector<Case>, Record> without_reference(const Machine& m)
{
    Record r = test::record_of(m, 1, 4);
    const Record whole = r;
    r.reference_position.clear(), r.reference_velocity.clear();
    std::vector<Note> notes;
    return {{prepare(r, test::nominal_joint(), notes)}, whole};
}

}  // namespace

TEST_CASE("without a reference a coarse grid does not bend the gains", "[gap]")
{
    Machine m;
    m.quantum = 2e-3;  // most readings repeat the last one
    Record r = test::record_of(m, 1, 4);
    r.reference_position.clear(), r.reference_velocity.clear();
    // steps of the reference, as they come through k_p: a few rows that noise does not explain
    for (std::size_t k = 0; k < r.rows(); ++k) r.effort_command[k] += k / 250 % 2 ? 3.0 : 0.0;
    std::vector<Note> notes;
    std::vector<Case> cases{prepare(r, test::nominal_joint(), notes)};
    const auto found = audit(cases);
    for (const auto& f : found.findings) CHECK(f.effect == "quantisation");
    CHECK(found.command_explained);
}

TEST_CASE("a limit of the integral that is not the documented one is read off the command", "[gap][slow]")
{
    const Record plain = test::record_of({}, 1, 4);
    const double tick = plain.time[1] - plain.time[0];
    constexpr double k_i = 150;
    const auto integrating = [&](double most) {
        Record r = plain;
        double share = 0;
        for (std::size_t k = 0; k < plain.rows(); ++k) {
            share += tick * k_i * (plain.reference_position[k] - plain.position[k]);
            share = std::clamp(share, -most, most);
            r.effort_command[k] += share;
        }
        return r;
    };
    const Record free = integrating(infinity);
    double reached = 0;
    for (std::size_t k = 0; k < plain.rows(); ++k)
        reached = std::max(reached, std::abs(free.effort_command[k] - plain.effort_command[k]));
    const double half = 0.5 * reached;
    const auto found = [&](const Record& record, double documented, Control& corrected) {
        Joint joint = test::nominal_joint();
        joint.control.k_i = k_i, joint.control.integral_limit = documented;
        std::vector<Note> notes;
        std::vector<Case> cases{prepare(record, joint, notes)};
        const auto answer = audit(cases);
        corrected = cases[0].joint.control;
        return answer;
    };
    Control corrected;
    for (const double documented : {infinity, 0.3 * reached}) {
        const auto limited = found(integrating(half), documented, corrected);
        REQUIRE(limited.findings.size() == 1);
        CHECK(limited.findings[0].effect == "gain-k_i");
        CHECK(limited.findings[0].parameter == "gain-k_i.integral_limit");
        CHECK(limited.findings[0].value == Approx(half).epsilon(1e-3));
        CHECK(corrected.integral_limit == limited.findings[0].value);
        CHECK(corrected.k_i == k_i);
        CHECK(limited.command_explained);
    }
    // a documented limit that is not there
    const auto unlimited = found(free, half, corrected);
    REQUIRE(unlimited.findings.size() == 1);
    CHECK(unlimited.findings[0].value == infinity);
    CHECK(corrected.integral_limit == infinity);
    // one that is as documented, and one that no integral reaches
    CHECK(found(integrating(half), half, corrected).findings.empty());
    CHECK(found(free, 10 * reached, corrected).findings.empty());
}

TEST_CASE("integral action and feed-forward that the document lacks are read off the command", "[gap][slow]")
{
    const Record plain = test::record_of({}, 1, 4);
    const double tick = plain.time[1] - plain.time[0];
    Record integrating = plain, fed = plain;
    double integral = 0;
    for (std::size_t k = 0; k < plain.rows(); ++k) {
        integral += tick * (plain.reference_position[k] - plain.position[k]);
        integrating.effort_command[k] += 150 * integral;
        fed.effort_command[k] += 0.3 * std::tanh(plain.reference_velocity[k] / 1e-3);
    }
    std::vector<Note> notes;
    std::vector<Case> with_integral{prepare(integrating, test::nominal_joint(), notes)};
    const auto k_i = audit(with_integral);
    REQUIRE(k_i.findings.size() == 1);
    CHECK(k_i.findings[0].effect == "gain-k_i");
    CHECK(k_i.findings[0].value == Approx(150).epsilon(1e-3));
    CHECK(with_integral[0].joint.control.k_i == k_i.findings[0].value);

    // where the integral is documented and the filter is not the documented one, that is what is named
    Machine slower;
    slower.tau = 0.0051;
    Record filtered = test::record_of(slower, 1, 4);
    integral = 0;
    for (std::size_t k = 0; k < filtered.rows(); ++k) {
        integral += tick * (filtered.reference_position[k] - filtered.position[k]);
        filtered.effort_command[k] += 150 * integral;
    }
    Joint integrates = test::nominal_joint();
    integrates.control.k_i = 150;
    std::vector<Case> with_filter{prepare(filtered, integrates, notes)};
    const auto filter = audit(with_filter);
    REQUIRE(filter.findings.size() == 1);
    CHECK(filter.findings[0].effect == "velocity-filter");
    CHECK(filter.findings[0].value == Approx(0.0051).epsilon(1e-3));
    CHECK(filter.command_explained);

    // a trace of a feed-forward, a thousandth of the command, is found in clean logs and is no finding
    Joint documented = test::nominal_joint();
    documented.control.k_i = 150;
    Record traced = integrating;
    for (std::size_t k = 0; k < traced.rows(); ++k)
        traced.effort_command[k] += 2e-3 * std::tanh(plain.reference_velocity[k] / 1e-3);
    std::vector<Case> with_trace{prepare(traced, documented, notes)};
    CHECK(audit(with_trace).findings.empty());

    // and where the command is none of a controller of this kind, nothing is named
    Record strange = filtered;
    for (std::size_t k = 0; k < strange.rows(); ++k)
        strange.effort_command[k] = 40 * std::sin(0.7 * plain.time[k] * plain.time[k]);
    std::vector<Case> with_another{prepare(strange, integrates, notes)};
    CHECK(audit(with_another).findings.empty());

    std::vector<Case> with_feed_forward{prepare(fed, test::nominal_joint(), notes)};
    const auto coulomb = audit(with_feed_forward);
    REQUIRE(coulomb.findings.size() == 1);
    CHECK(coulomb.findings[0].parameter == "feed-forward.coulomb");
    CHECK(coulomb.findings[0].value == Approx(0.3).epsilon(1e-3));
    // whatever the speed at which it has come up
    Record slowly = plain;
    for (std::size_t k = 0; k < plain.rows(); ++k)
        slowly.effort_command[k] += 0.3 * std::tanh(plain.reference_velocity[k] / 0.04);
    std::vector<Case> with_slow_one{prepare(slowly, test::nominal_joint(), notes)};
    const auto slow = audit(with_slow_one);
    REQUIRE(slow.findings.size() == 1);
    CHECK(slow.findings[0].parameter == "feed-forward.coulomb");
    CHECK(slow.findings[0].value == Approx(0.3).epsilon(1e-3));
    CHECK(with_slow_one[0].joint.control.feed_forward.coulomb_speed == Approx(0.04).epsilon(1e-3));
}

TEST_CASE("wrong gains and a wrong filter are found without a reference, by the noise that comes through them", "[gap]")
{
    Machine m;
    m.k_p = 1230;  // documented: 1200
    auto gain = without_reference(m).first;
    const auto found = audit(gain);
    REQUIRE(found.findings.size() == 1);
    CHECK(found.findings[0].effect == "gain-k_p");
    CHECK(found.findings[0].value == Approx(1.025).epsilon(1e-3));

    Machine other;
    other.tau = 0.005;  // documented: 0.003
    auto filter = without_reference(other).first;
    const auto filtered = audit(filter);
    REQUIRE(filtered.findings.size() == 1);
    CHECK(filtered.findings[0].effect == "velocity-filter");
    CHECK(filtered.findings[0].value == Approx(0.005).epsilon(1e-3));
}

TEST_CASE("a filter is found where a log starts in motion, though nobody saw what it remembers there", "[gap]")
{
    Machine m;
    m.tau = 0.012;  // documented: 0.003
    const Record whole = test::record_of(m, 1, 4);
    std::size_t fastest = 500;
    for (std::size_t k = fastest; k < 2000; ++k)
        if (std::abs(whole.velocity[k]) > std::abs(whole.velocity[fastest])) fastest = k;
    const Record r = test::rows_where(whole, [&](std::size_t k) { return k >= fastest; });
    std::vector<Note> notes;
    std::vector<Case> cases{prepare(r, test::nominal_joint(), notes)};
    REQUIRE_FALSE(cases[0].ticks.at_rest);
    const auto found = audit(cases);
    REQUIRE(found.findings.size() == 1);
    CHECK(found.findings[0].effect == "velocity-filter");
    CHECK(found.findings[0].value == Approx(m.tau).epsilon(1e-5));
}

TEST_CASE("a slow filter behind much noise is told from gains exactly, although they hardly differ", "[gap]")
{
    // gain and time constant both scale the same fast noise: what tells them apart is a millionth of it
    Machine m;
    m.noise = 1.5e-4, m.tau = 0.03, m.k_v = 4, m.k_p = 90, m.coulomb = 0.1;
    Joint joint = test::nominal_joint();
    joint.control.k_p = m.k_p, joint.control.k_v = m.k_v;
    joint.control.velocity_estimate.tau = 0.013;
    joint.sensor.position_noise = m.noise;
    Record r = test::record_of(m, 1, 4);
    r.reference_position.clear(), r.reference_velocity.clear();
    std::vector<Note> notes;
    std::vector<Case> cases{prepare(r, joint, notes)};
    const auto found = audit(cases);
    REQUIRE(found.findings.size() == 1);
    CHECK(found.findings[0].effect == "velocity-filter");
    CHECK(found.findings[0].value == Approx(m.tau).epsilon(1e-5));
}

TEST_CASE("a filter that is written down with fewer digits than it works with is no other filter", "[gap]")
{
    Machine m;
    m.tau = 0.0030001;  // documented: 0.003
    auto cases = without_reference(m).first;
    CHECK(audit(cases).findings.empty());
    CHECK(filters_differently(0.003, 0.0031, 1e-3));
    CHECK_FALSE(filters_differently(0, 1e-6, 1e-3));
}

TEST_CASE("a command in whole steps is understood to its rounding, and a gain beyond it is still found", "[gap][slow]")
{
    Machine m;
    m.command_step = 0.2;
    std::vector<Note> notes;
    const auto judged = [&] {
        std::vector<Case> cases{prepare(test::record_of(m, 1), test::nominal_joint(), notes)};
        CHECK(command_step(cases[0].ticks) == Approx(0.2));
        return audit(cases);
    };
    const auto fine = judged();
    CHECK(fine.findings.empty());
    CHECK(fine.command_explained);
    CHECK(fine.residual_after > 2e-3);  // more than an exact controller leaves
    REQUIRE(fine.notes.size() == 1);
    CHECK(fine.notes[0].code == Note::Code::gains_to_steps);
    m.k_p = 1320;  // documented: 1200
    const auto wrong = judged();
    REQUIRE(wrong.findings.size() == 1);
    CHECK(wrong.findings[0].effect == "gain-k_p");
    CHECK(wrong.findings[0].value == Approx(1.1).epsilon(0.01));
}

TEST_CASE("a reference that was not logged is rebuilt from the command", "[gap]")
{
    auto [cases, whole] = without_reference({});
    const auto found = audit(cases);
    CHECK(found.findings.empty());
    CHECK(found.command_explained);
    const Ticks& t = cases[0].ticks;
    REQUIRE(t.has_reference);
    // it moves by 0.2; where it began is forgotten within k_v/k_p = 40 ms
    for (std::size_t k = 400; k < t.size(); ++k) {
        if (t.time[k] > 0.99 && t.time[k] < 1.4) continue;  // its rate jumps at 1 s
        INFO(t.time[k]);
        REQUIRE(t.reference[k] == Approx(whole.reference_position[k]).margin(2e-6));
        REQUIRE(t.reference_rate[k] == Approx(whole.reference_velocity[k]).margin(1e-4));
    }
}

TEST_CASE("of a log at every second tick and without a reference the commands between are those that were given",
          "[gap]")
{
    Machine m;
    m.command_limit = 20;
    m.step = GENERATE(0.01, 0.03);         // 12 N, and 36 N: into the limit
    m.step_time = GENERATE(2.000, 2.001);  // with a row, and between two rows
    CAPTURE(m.step, m.step_time);
    const Record whole = test::record_of(m, 1, 4);
    Record half = test::every_nth_row(whole, 2);
    half.reference_position.clear(), half.reference_velocity.clear();
    Joint joint = test::nominal_joint();
    joint.control.effort_limit = m.command_limit;
    std::vector<Note> notes;
    std::vector<Case> cases{prepare(half, joint, notes)};
    CHECK(audit(cases).findings.empty());
    settle_jumps(cases, {}, {});
    const auto command = known_command(flatten(cases[0].joint), cases[0].ticks);
    int limited = 0;
    for (std::size_t k = 0; k < command.size(); ++k) {
        if (std::abs(whole.time[k] - 1) < 1.5e-3) continue;  // this machine's rate jumps in two halves
        CAPTURE(whole.time[k]);
        REQUIRE(command[k] == Approx(whole.effort_command[k]).margin(0.05));
        limited += std::abs(command[k]) == m.command_limit;
    }
    CHECK((limited > 0) == (m.step > 0.02));
}

TEST_CASE("logged velocities tell the filter without a command, exactly", "[gap]")
{
    Machine m;
    m.tau = GENERATE(0.003, 0.0051);  // documented: 0.003
    Record r = test::record_of(m, 1, 3);
    r.effort_command.clear();
    std::vector<Note> notes;
    std::vector<Case> cases{prepare(r, test::nominal_joint(), notes)};
    const auto found = audit(cases);
    CHECK(found.filter_seen);
    REQUIRE(found.findings.size() == (m.tau == 0.003 ? 0 : 1));
    CHECK(cases[0].joint.control.velocity_estimate.tau == Approx(m.tau).epsilon(1e-6));
    for (const auto& c : single_candidates(cases, found)) CHECK(c.effects[0]->name != "velocity-filter");
}

TEST_CASE("velocities that the command is made of tell the filter where rows were lost", "[gap]")
{
    Machine m;
    m.tau = GENERATE(0.003, 0.011);  // documented: 0.003
    const bool own = GENERATE(true, false), referred = GENERATE(true, false);
    if (!referred) m.step = 0.01;  // and its rate is no smooth one
    Record r = test::record_of(m, 1, 3);
    CAPTURE(m.tau, own, referred);
    if (!referred) r.reference_position.clear(), r.reference_velocity.clear();
    if (!own)  // another filter of the logger's, which the command knows nothing of
        for (std::size_t k = 1; k < r.rows(); ++k)
            r.velocity[k] = r.velocity[k - 1] + 0.2 * ((r.position[k] - r.position[k - 1]) / 1e-3 - r.velocity[k - 1]);
    for (const std::ptrdiff_t lost : {500, 1100, 2300})
        for (auto* column : {&r.time, &r.position, &r.velocity, &r.reference_position, &r.reference_velocity,
                             &r.effort_command, &r.effort_measured})
            if (!column->empty()) column->erase(column->begin() + lost, column->begin() + lost + 4);
    std::vector<Note> notes;
    std::vector<Case> cases{prepare(r, test::nominal_joint(), notes)};
    REQUIRE(cases[0].ticks.lost);
    const auto found = audit(cases);
    CHECK(found.filter_seen == own);
    if (!own) return;
    REQUIRE(found.findings.size() == (m.tau == 0.003 ? 0 : 1));
    CHECK(cases[0].joint.control.velocity_estimate.tau == Approx(m.tau).epsilon(1e-6));
}

TEST_CASE("a velocity from anywhere else is no evidence of the controller's filter", "[gap]")
{
    const Record whole = test::record_of({}, 1, 3);
    const bool central = GENERATE(false, true), commanded = GENERATE(false, true);
    CAPTURE(central, commanded);
    Record r = whole;
    if (!commanded) r.effort_command.clear();
    for (std::size_t k = 0; k < r.rows(); ++k) {
        const std::size_t a = k == 0 ? 0 : k - 1, b = central ? std::min(k + 1, r.rows() - 1) : k;
        r.velocity[k] = b > a ? (r.position[b] - r.position[a]) / (r.time[b] - r.time[a]) : 0;
    }
    std::vector<Note> notes;
    std::vector<Case> cases{prepare(r, test::nominal_joint(), notes)};
    const auto found = audit(cases);
    CHECK_FALSE(found.filter_seen);
    CHECK(found.findings.empty());
}

TEST_CASE("velocities at every second tick tell the filter by the grid on which the readings between must lie",
          "[gap][slow]")
{
    Machine m;
    m.tau = GENERATE(0.0044, 0.0044367);  // documented: 0.003
    const bool at_rest = GENERATE(false, true), fine = GENERATE(false, true);
    CAPTURE(m.tau, at_rest, fine);
    if (at_rest) m.amplitude = 0, m.step = 0.02, m.step_time = 2.9, m.noise = 0;
    if (fine) m.quantum = 1e-6;
    const Record whole = test::record_of(m, 1, 3.5);
    Record half = test::every_nth_row(whole, 2);
    half.reference_velocity.clear(), half.effort_command.clear();
    for (std::size_t k = 1; k < half.rows(); k += 2) half.time[k] += 5e-6;  // rounding of the time column
    Joint joint = test::nominal_joint();
    joint.sensor.encoder_quantum = m.quantum;
    std::vector<Note> notes;
    std::vector<Case> cases{prepare(half, joint, notes)};
    const auto found = audit(cases);
    REQUIRE(found.findings.size() == 1);
    CHECK(found.findings[0].value == Approx(m.tau).epsilon(1e-4));
    for (std::size_t k = 0; k < cases[0].ticks.size(); ++k)
        REQUIRE(cases[0].ticks.position[k] == Approx(whole.position[k]).margin(1e-9));
}

TEST_CASE("readings between rows are interpolated where the velocities follow no filter", "[gap]")
{
    const Record whole = test::record_of({}, 1, 3);
    Record half = test::every_nth_row(whole, 2);
    half.reference_velocity.clear(), half.effort_command.clear();
    for (std::size_t k = 0; k < whole.rows(); k += 2) {
        const std::size_t a = k > 3 ? k - 4 : 0, b = std::min(k + 4, whole.rows() - 1);
        half.velocity[k / 2] = (whole.position[b] - whole.position[a]) / (whole.time[b] - whole.time[a]);
    }
    std::vector<Note> notes;
    std::vector<Case> cases{prepare(half, test::nominal_joint(), notes)};
    REQUIRE(cases[0].ticks.rebuilt);
    const auto found = audit(cases);
    CHECK_FALSE(found.filter_seen);
    CHECK(found.findings.empty());
    CHECK_FALSE(cases[0].ticks.rebuilt);
    for (std::size_t k = 0; k + 1 < cases[0].ticks.size(); ++k)
        REQUIRE(cases[0].ticks.position[k] == Approx(whole.position[k]).margin(5e-5));
}
