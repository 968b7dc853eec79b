// Terms of a controller that no document has, in commands that nothing reproduces to digits.
#include "analysis/diagnosis/audit/audit.h"
#include "analysis/diagnosis/audit/prepare.h"
#include "analysis/diagnosis/diagnose.h"
#include "tests/analysis/diagnosis/answers.h"
#include "tests/analysis/diagnosis/small_machine.h"
#include "tests/in_order.h"

#include <catch2/catch.hpp>

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

TEST_CASE("a filter of two poles is no gain of a controller with an integral", "[gap]")
{
    // the same readings under a controller whose velocity goes through two filters, as a log would have them
    Record r = test::record_of({}, 1, 4);
    const double tick = r.time[1] - r.time[0], share = tick / (5e-3 + tick);
    double once = 0, twice = 0, sum = 0;
    for (std::size_t k = 0; k < r.rows(); ++k) {
        const double error = r.reference_position[k] - r.position[k];
        const double rise = k == 0 ? 0 : (r.position[k] - r.position[k - 1]) / tick;
        once += share * (rise - once), twice += share * (once - twice);
        sum += tick * error;
        r.effort_command[k] = 1200 * error + 45 * (r.reference_velocity[k] - twice) + 3000 * sum;
    }
    Joint joint = test::nominal_joint();
    joint.control.k_i = 3000;
    std::vector<Note> notes;
    std::vector<gap::Case> cases{gap::prepare(r, joint, notes)};
    const auto audit = gap::audit(cases);
    REQUIRE(audit.findings.size() == 1);
    CHECK(audit.findings[0].effect == "velocity-filter");
    CHECK(!audit.command_explained);
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
