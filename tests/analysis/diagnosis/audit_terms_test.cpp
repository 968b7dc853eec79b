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
