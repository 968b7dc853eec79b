#include "analysis/diagnosis/heldout/contest.h"
#include "analysis/diagnosis/audit/prepare.h"
#include "tests/analysis/diagnosis/small_machine.h"

#include <catch2/catch.hpp>

using namespace stickslip;
using namespace stickslip::gap;
using stickslip::test::Machine;

namespace {

void in_order(std::size_t n, const std::function<void(std::size_t)>& task)
{
    for (std::size_t i = 0; i < n; ++i) task(i);
}

/// The contest on two records of a machine whose document says less than there is.
Contest contest_of(const Machine& m)
{
    std::vector<std::string> notes;
    std::vector<Case> cases;
    for (unsigned seed : {1u, 2u}) {
        cases.push_back(prepare(test::record_of(m, seed, 5), test::nominal_joint(), notes));
        cases.back().number = cases.size() - 1;
    }
    const auto scales = scales_of(cases);
    std::vector<Attribution> singles;
    for (const char* name :
         {"stribeck", "asymmetric-friction", "load-dependent-friction", "gravity", "friction-drift"}) {
        Attribution a;
        const Effect* e = effect_named(name);
        a.candidate = {{e}, {&e->forms[0]}, cases.size()};
        a.x.fill(to_fit(a.candidate, e->forms[0].seeds[0]));
        singles.push_back(a);
    }
    return hold_contest(cases, scales, singles, in_order);
}

}  // namespace

TEST_CASE("a cause is named by what it predicts although drag of no catalogue remains and the numbers are off", "[gap]")
{
    Machine m;
    m.viscous = 3;  // documented: 1.5
    m.drag = 2;
    m.one_way = 1.2;
    const auto contest = contest_of(m);
    REQUIRE(contest.decided);
    const auto& best = contest.ranked.at(0);
    CHECK(best.fit.candidate.effects.back()->name == "asymmetric-friction");
    CHECK(contest.ambiguous.empty());
    CHECK(contest.refit.low > 0.1);  // the wrong slope is refitted for everybody
    CHECK(best.gain > 0.25);
    CHECK(best.spread.low <= best.gain);
    CHECK(best.gain <= best.spread.high);
}

TEST_CASE("where only the joint's own numbers are off, refitting them leaves no cause a name", "[gap]")
{
    Machine m;
    m.viscous = 3;
    m.load = 0.3;
    const auto contest = contest_of(m);
    CHECK_FALSE(contest.decided);
    CHECK(contest.refit.low > 0.5);
}
