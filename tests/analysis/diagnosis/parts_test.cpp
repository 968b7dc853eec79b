// A cause under the name of another whose formula contains it.
#include "analysis/diagnosis/ladder/climber.h"
#include "analysis/diagnosis/verdict/experiment.h"
#include "tests/analysis/diagnosis/ladder_search.h"

#include <catch2/catch.hpp>

using namespace stickslip;
using namespace stickslip::gap;
using stickslip::test::Machine;
using Search = LadderRecords;

TEST_CASE("a curve that is followed late by less than can be told is a curve, and the late one is no rival of it",
          "[gap][ladder][slow]")
{
    Machine m;
    m.peak = 1;
    const Search search(m, {"frictional-memory:lag"});
    const auto ladder = search.search->climb({}, policy::ladder.most_rungs);
    CHECK(names_of(ladder.last().causes) == std::vector<std::string>{"stribeck"});
    for (const auto& rivals : ladder.rivals)
        for (const auto& r : rivals) CHECK(names_of(r.causes) != std::vector<std::string>{"frictional-memory"});
}

TEST_CASE("a falling curve, all of it followed late, is two causes; what falls late beside a slope that does not, one",
          "[gap][ladder][slow]")
{
    for (const bool whole : {true, false}) {
        INFO((whole ? "the whole curve is late" : "the peak alone is late"));
        Search search(Machine{}, {});
        Joint late = test::nominal_joint();
        set_stribeck(late.friction, 1, 0.05, 2);
        late.friction.memory.lag = 0.05, late.friction.memory.lag_viscous = whole;
        search.simulate(late, {"frictional-memory:lag"});
        const auto names = names_of(search.search->climb({}, policy::ladder.most_rungs).last().causes);
        const std::vector<std::string> both{"stribeck", "frictional-memory"};
        CHECK(names == (whole ? both : std::vector<std::string>{"frictional-memory"}));
    }
}

TEST_CASE("a peak that hardly falls over the speeds of the records is a Coulomb level, beside numbers that are off",
          "[gap][ladder]")
{
    Machine m;
    m.coulomb = 2.6, m.viscous = 1.5 * 0.96, m.inertia = 1.2 * 0.96;
    const Search search(m, {});
    Attribution peak = search.single("stribeck:gaussian");
    peak.x.fill(to_fit(peak.candidate, {0.6 / unit_of(Scale::friction_effort, search.scales), 3}));
    const auto ladder = search.search->of(peak);
    CHECK(names_of(ladder.last().causes) == std::vector<std::string>{"coulomb-level"});
}

TEST_CASE("a lag of two poles is no lag with a dead time beside it, and a dead time that is smeared none with a lag",
          "[gap][ladder]")
{
    const auto named = [](const Machine& m) {
        const Search search(m, {"actuator-lag:with-dead-time", "delay:with-lag", "actuator-lag", "delay", "viscous"});
        return names_of(search.search->climb({}, policy::ladder.most_rungs).last().causes);
    };
    Machine m;
    m.lag = 6e-3, m.second_lag = 3e-3;
    CHECK(named(m) == std::vector<std::string>{"actuator-lag"});
    m.second_lag = 1e-3, m.lag = 1e-3, m.late = 6e-3;
    CHECK(named(m) == std::vector<std::string>{"delay"});
    m.lag = 0;
    CHECK(named(m) == std::vector<std::string>{"delay"});
    m.late = 0, m.lag = 6e-3, m.second_lag = 0;
    CHECK(named(m) == std::vector<std::string>{"actuator-lag"});
}
