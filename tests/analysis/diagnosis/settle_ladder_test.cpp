// What is taken away from a ladder, or climbed to anew, once it stands.
#include "analysis/diagnosis/verdict/settle_ladder.h"
#include "analysis/diagnosis/diagnose.h"
#include "analysis/diagnosis/policy/ladder_verdict.h"
#include "tests/analysis/diagnosis/answers.h"
#include "tests/analysis/diagnosis/ladder_search.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace stickslip;
using namespace stickslip::gap;
using stickslip::test::in_order;
using stickslip::test::Machine;

TEST_CASE("a load that no document states is a cause where most of the gap is its, and has rivals", "[gap][slow]")
{
    // an eighth of the Coulomb level: as a correction, two and a half of its standard deviations
    Machine m;
    m.load = 0.25, m.coulomb *= 1.03, m.inertia *= 1.03;
    const auto d =
        test::answer(test::nominal_joint(), {test::record_of(m, 1), test::record_of(m, 2)}, in_order).diagnosis;
    REQUIRE(d.verdict == Verdict::gap);
    CHECK(d.effects[0].names == std::vector<std::string>{"constant-load"});
    REQUIRE(d.ladder.size() == 1);
    CHECK(d.ladder[0].names == d.effects[0].names);
    CHECK(d.ladder[0].share > 0.5);
    // friction that differs by direction makes the same motion
    CHECK(d.ladder[0].ambiguous_with == std::vector<std::vector<std::string>>{{"asymmetric-friction"}});
}

TEST_CASE("a number whose own error reaches the document is no cause", "[gap][ladder][slow]")
{
    // a scale of the reading is a factor on all of them, and their priors hold none of them back
    Machine m;
    m.inertia *= 1.07, m.coulomb *= 0.93, m.viscous *= 1.07;
    LadderRecords records(m, {"sensor-offset:scale"});
    const Fit fit{records.cases, records.scales, records.nominal, in_order};
    auto j = records.judged(records.search->climb({}, 1));
    CHECK(j.ladder.rungs.size() == 1);
    const OnlyNoise only_noise = [&](const FittedSet& set) { return leaves_noise(fit, set); };
    const std::vector<Attribution> none;
    const std::vector<Joint> documented(records.cases.size(), test::nominal_joint());
    settle_ladder(*records.search, fit, {none, only_noise, documented, 2}, j);
    CHECK(j.ladder.rungs.empty());
    CHECK(j.only_corrections);
}

TEST_CASE("a last rung that may take nothing is no rung", "[gap][ladder][slow]")
{
    // readings that are held now and then leave more than noise, of which a second cause makes a little by chance
    Machine m;
    m.viscous = 6;
    LadderRecords records(m, {"viscous", "gravity"}, 0.03);
    const Fit fit{records.cases, records.scales, records.nominal, in_order};
    Attribution known;
    known.candidate = {{effect_named("viscous"), effect_named("gravity")},
                       {&effect_named("viscous")->forms[0], &effect_named("gravity")->forms[0]},
                       records.cases.size()};
    known.x.fill(to_fit(known.candidate, {4.5, 0.01}));
    auto j = records.judged(records.search->of(known));
    REQUIRE(j.ladder.rungs.size() == 2);
    REQUIRE_FALSE(j.noise_left);
    const OnlyNoise only_noise = [&](const FittedSet& set) { return leaves_noise(fit, set); };
    const std::vector<Attribution> none;
    const std::vector<Joint> documented(records.cases.size(), test::nominal_joint());
    settle_ladder(*records.search, fit, {none, only_noise, documented, 2}, j);
    REQUIRE(j.ladder.rungs.size() == 1);
    CHECK(j.ladder.last().causes.effects[0]->name == "viscous");
}
