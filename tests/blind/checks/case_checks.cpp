// Whole cases: reproducible, honest about what they contain.
#include "tests/blind/generate/files.h"
#include "tests/blind/generate/random.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <set>

using namespace blind;

TEST_CASE("the catalogue is the one of the interface", "[blind]")
{
    const auto& names = effect_names();
    CHECK(names.size() == 29);
    CHECK(std::set<std::string>(names.begin(), names.end()).size() == 29);
    for (const char* name : {"coulomb-level", "frictional-memory", "backlash", "gain-k_v", "supply-sag",
                             "periodic-disturbance", "gain-k_i", "feed-forward", "dead-zone"})
        CHECK(std::count(names.begin(), names.end(), name) == 1);
}

TEST_CASE("the same seed makes the same case, another seed another one", "[blind][slow]")
{
    const Wish wish{.kind = "single", .effect = "viscous"};
    const auto a = make_case(wish, 42, 0), b = make_case(wish, 42, 0), c = make_case(wish, 43, 0);
    CHECK(joint_toml(a.setting) == joint_toml(b.setting));
    CHECK(record_csv(a.records[0], a.machines[0], a.setting.columns) ==
          record_csv(b.records[0], b.machines[0], b.setting.columns));
    CHECK(truth_json({{"x", a}}, "own") == truth_json({{"x", b}}, "own"));
    CHECK(joint_toml(a.setting) != joint_toml(c.setting));
}

TEST_CASE("a case without an effect is at its floor, one with an effect is not, and its truth closes the gap",
          "[blind][slow]")
{
    const auto none = make_case({.kind = "none"}, 7, 1);
    CHECK(none.verdict == "no-gap");
    CHECK(none.gap.before == Approx(1).margin(0.1));
    const auto load = make_case({.kind = "single", .effect = "constant-load", .strength = "medium"}, 7, 2);
    CHECK(load.verdict == "gap");
    CHECK(load.gap.before > 3);
    CHECK(load.gap.after == Approx(1).margin(0.2));
    CHECK(load.equivalent == std::vector<std::string>{"asymmetric-friction"});
    REQUIRE(load.parameters.size() == 1);
    CHECK(load.parameters[0].path == "load.constant");
    CHECK(load.parameters[0].value == load.machines[0].mechanism.constant_load);
}

TEST_CASE("a dirty case without an effect tells that its friction is uneven, which is a constant load", "[blind]")
{
    const auto none = make_case({.kind = "none", .dirty = true}, 7, 1);
    CHECK(none.verdict == "no-gap");
    const double uneven = none.machines[0].mechanism.friction[0].uneven_coulomb;
    REQUIRE(uneven != 0);
    CHECK(std::ranges::count(none.equivalent, "constant-load") == 1);
    const auto off = corrections(none.setting.nominal, *none.setting.dirt);
    CHECK(std::ranges::any_of(off, [&](const Parameter& p) {
        return p.path == "friction.asymmetry.coulomb" && p.nominal == 0 && p.value == uneven;
    }));
}

TEST_CASE("the joint of a case is its nominal, never its truth", "[blind][slow]")
{
    for (const char* effect : {"inertia", "compliance", "gain-k_p"}) {
        const auto c = make_case({.kind = "single", .effect = effect}, 19, 0);
        Setting opened = c.setting;
        opened.nominal.machine = c.machines[0];
        CHECK(joint_toml(c.setting) != joint_toml(opened));
        CHECK(joint_toml(c.setting).find("single-mass") != std::string::npos);
    }
}

TEST_CASE("both effects of a pair matter", "[blind][slow]")
{
    const auto c = make_case({.kind = "pair"}, 3, 0);
    REQUIRE(c.effects.size() == 2);
    CHECK(may_pair(c.effects[0], c.effects[1]));
    REQUIRE(c.gap_without.size() == 2);
    CHECK(*std::min_element(c.gap_without.begin(), c.gap_without.end()) > 1.5);
}
