// Terms of a controller that no document has, in commands that nothing reproduces to digits.
#include "analysis/diagnosis/audit/audit.h"
#include "analysis/diagnosis/audit/prepare.h"
#include "analysis/diagnosis/diagnose.h"
#include "tests/analysis/diagnosis/answers.h"
#include "tests/analysis/diagnosis/record_rows.h"
#include "tests/analysis/diagnosis/small_machine.h"
#include "tests/in_order.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

using namespace stickslip;
using stickslip::test::in_order;
using stickslip::test::Machine;

TEST_CASE("a feed-forward of an acceleration that the log shows only roughly is named", "[gap][slow]")
{
    Machine m;
    m.fed = 1.2;  // all of the inertia
    const auto d =
        test::answer(test::nominal_joint(), {test::record_of(m, 1), test::record_of(m, 2)}, in_order).diagnosis;
    REQUIRE(d.verdict == Verdict::gap);
    CHECK(d.effects[0].names == std::vector<std::string>{"feed-forward"});
    REQUIRE(d.effects[0].parameters.size() == 1);
    CHECK(d.effects[0].parameters[0].name == "feed-forward.acceleration");
    CHECK(d.effects[0].parameters[0].value == Approx(1.2).epsilon(0.03));
}

namespace {

constexpr double k_i = 3000;  // N/(m·s)

/// A filter of the velocity from tick to tick.
using VelocityFilter = std::function<double(double)>;

/// Two filters of 5 ms, one behind the other.
VelocityFilter two_filters(double tick)
{
    return [share = tick / (5e-3 + tick), once = 0.0, twice = 0.0](double rise) mutable {
        once += share * (rise - once), twice += share * (once - twice);
        return twice;
    };
}

/// Butterworth's of second order, by the bilinear transform.
VelocityFilter butterworth(double tick, double corner)
{
    const double w = corner * tick / 2, root = std::sqrt(2.0), all = 1 + root * w + w * w;
    return [=, x1 = 0.0, x2 = 0.0, y1 = 0.0, y2 = 0.0](double rise) mutable {
        const double y = (w * w * (rise + 2 * x1 + x2) - 2 * (w * w - 1) * y1 - (1 - root * w + w * w) * y2) / all;
        x2 = x1, x1 = rise, y2 = y1, y1 = y;
        return y;
    };
}

/// Readings under a controller with an integral whose velocity goes through this filter, as a log would have them.
Record of_filter(const std::function<VelocityFilter(double tick)>& filter, double k_p = 1200)
{
    Record r = test::record_of({}, 1, 4);
    const double tick = r.time[1] - r.time[0];
    const auto filtered = filter(tick);
    double sum = 0;
    r.velocity.clear();
    for (std::size_t k = 0; k < r.rows(); ++k) {
        const double error = r.reference_position[k] - r.position[k];
        r.velocity.push_back(filtered(k == 0 ? 0 : (r.position[k] - r.position[k - 1]) / tick));
        sum += tick * error;
        r.effort_command[k] = k_p * error + 45 * (r.reference_velocity[k] - r.velocity[k]) + k_i * sum;
    }
    return r;
}

Record of_two_filters(double k_p = 1200)
{
    return of_filter(two_filters, k_p);
}

gap::Audit audit_of(const Record& r)
{
    Joint joint = test::nominal_joint();
    joint.control.k_i = k_i;
    std::vector<Note> notes;
    std::vector<gap::Case> cases{gap::prepare(r, joint, notes)};
    return gap::audit(cases);
}

Record with_holes(const Record& r)
{
    return test::rows_where(r, [](std::size_t k) { return k % 800 < 700 || k % 800 > 717; });
}

}  // namespace

TEST_CASE("a filter of two poles is no gain of a controller with an integral", "[gap]")
{
    Record r = of_two_filters();
    r.velocity.clear();
    const auto audit = audit_of(r);
    REQUIRE(audit.findings.size() == 1);
    CHECK(audit.findings[0].effect == "velocity-filter");
    CHECK(!audit.command_explained);
}

TEST_CASE("velocities that the command is made of tell a filter of two poles and leave nothing of the command", "[gap]")
{
    for (const bool holes : {false, true}) {
        CAPTURE(holes);
        const Record r = of_two_filters();
        const auto audit = audit_of(holes ? with_holes(r) : r);
        REQUIRE(audit.findings.size() == 1);
        CHECK(audit.findings[0].effect == "velocity-filter");
        CHECK(audit.findings[0].value == Approx(2 * 5e-3).epsilon(1e-6));  // delays of filters in a row add up
        CHECK(audit.command_explained);
        REQUIRE_FALSE(audit.notes.empty());
        CHECK(audit.notes[0].code == Note::Code::filter_of_two_poles);
    }
    const double corner = 300;  // rad/s
    const auto audit = audit_of(with_holes(of_filter([&](double tick) { return butterworth(tick, corner); })));
    REQUIRE(audit.findings.size() == 1);
    CHECK(audit.findings[0].value == Approx(std::sqrt(2.0) / corner).epsilon(1e-6));  // of slow motion
    // somebody else's velocities
    Record r = of_two_filters();
    for (std::size_t k = r.rows() - 1; k > 0; --k) r.velocity[k] = r.velocity[k - 1];
    for (const auto& note : audit_of(r).notes) CHECK(note.code != Note::Code::filter_of_two_poles);
}

TEST_CASE("velocities of a cascade tell its filter where no command was logged", "[gap]")
{
    Record r = test::record_of({}, 1, 4);
    const double tick = r.time[1] - r.time[0], tau = 8e-3;
    double filtered = 0;
    for (std::size_t k = 0; k < r.rows(); ++k) {
        filtered += tick / (tau + tick) * ((k == 0 ? 0 : (r.position[k] - r.position[k - 1]) / tick) - filtered);
        r.velocity[k] = filtered;
    }
    r.effort_command.clear();
    Joint joint = test::nominal_joint();
    joint.control.structure = Structure::cascade;
    joint.control.k_p = joint.control.k_v = 0;
    joint.control.position_gain = 25, joint.control.velocity_gain = 45, joint.control.velocity_integral_gain = 900;
    std::vector<Note> notes;
    std::vector<gap::Case> cases{gap::prepare(r, joint, notes)};
    const auto audit = gap::audit(cases);
    REQUIRE(audit.findings.size() == 1);
    CHECK(audit.findings[0].effect == "velocity-filter");
    CHECK(audit.findings[0].value == Approx(tau).epsilon(1e-3));
}

TEST_CASE("a wrong gain is exact behind holes in which an integral gathered what nobody saw", "[gap]")
{
    Record r = of_two_filters(1500);
    const Record holed = with_holes(r);
    // a disturbance within each hole, of which only the integral knows
    double gathered = 0;
    std::size_t row = 0;
    Record disturbed = holed;
    for (std::size_t k = 0; k < holed.rows(); ++k) {
        const bool behind_hole = k > 0 && holed.time[k] - holed.time[k - 1] > 1.5 * (r.time[1] - r.time[0]);
        if (behind_hole) gathered += ++row % 2 == 0 ? 0.3 : 0.5;  // N
        disturbed.effort_command[k] += gathered;
    }
    REQUIRE(row > 2);
    const auto audit = audit_of(disturbed);
    const auto k_p = std::ranges::find(audit.findings, "gain-k_p", &gap::AuditFinding::effect);
    REQUIRE(k_p != audit.findings.end());
    CHECK(k_p->value == Approx(1.25).epsilon(1e-3));
    CHECK(audit.command_explained);
}

TEST_CASE("the limit of an integral is that of its own gain, not of the documented one", "[gap][slow]")
{
    Machine m;
    m.k_i = 2000, m.integral_limit = 0.8, m.load = 3;
    std::vector<Note> notes;
    for (const double documented : {infinity, 0.8}) {
        CAPTURE(documented);
        Joint joint = test::nominal_joint();
        joint.control.k_i = 6000, joint.control.integral_limit = documented;
        std::vector<gap::Case> cases{gap::prepare(test::record_of(m, 1), joint, notes)};
        const auto audit = gap::audit(cases);
        CHECK(cases[0].joint.control.k_i == Approx(2000).epsilon(0.01));
        CHECK(cases[0].joint.control.integral_limit == Approx(0.8).epsilon(0.01));
        const auto limit = std::ranges::find(audit.findings, "gain-k_i.integral_limit", &gap::AuditFinding::parameter);
        CHECK((limit != audit.findings.end()) == !(documented < infinity));
    }
}
