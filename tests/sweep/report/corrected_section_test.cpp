// What the page of a diagnosis says of the gains: the chart of both joints, how they move, and which gains are right.
#include "sweep/report/pages/corrected_section.h"

#include "analysis/diagnosis/diagnose.h"
#include "analysis/stability/verdict.h"
#include "sweep/report/figures/moved_boundary.h"
#include "tests/analysis/simulation/joints.h"
#include "tests/in_order.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace stickslip;
using Catch::Matchers::Contains;

namespace {

const StabilityMap* map_of(const Section& section, const std::string& id)
{
    for (const auto& figure : section.figures)
        if (figure.id == id) return &std::get<StabilityMap>(figure.picture);
    return nullptr;
}

Joint with_length(double L)
{
    Joint joint = example_joint(60e3, 10, 1e-3);
    std::get<RateAndState>(joint.friction.law).L[0] = L;
    return joint;
}

}  // namespace

TEST_CASE("the page of a cause shows both joints over their gains, and gains that are right", "[report][slow]")
{
    // k_cr = ((B − A − k_v V_0)/L)(1 + m V_0/(L C)): 53.9 kN/m, and 117 kN/m for half the length
    const Joint before = with_length(1e-5), after = with_length(5e-6);
    const auto gains = corrected_gains(before, after, 1e-3, test::in_order);
    REQUIRE((gains.right && gains.right->feasible));
    Joint right = after;
    right.control.k_p = gains.right->best.k_p, right.control.k_v = gains.right->best.k_v;
    CHECK(linear_verdict(right).state_variable.stable);
    CHECK_FALSE(linear_verdict(after).state_variable.stable);

    Section section;
    add_corrected_gains(section, gains, units_of(before), "with frictional-memory");
    REQUIRE((map_of(section, "map-nominal") && map_of(section, "map-corrected") && map_of(section, "map-right")));
    const auto slides = [&](const char* id) {
        const auto region = map_of(section, id)->design.region;
        return region == Region::stable || region == Region::memory_only;
    };
    CHECK(slides("map-nominal"));
    CHECK_FALSE(slides("map-corrected"));
    CHECK(slides("map-right"));
    CHECK(map_of(section, "map-nominal")->x.values == map_of(section, "map-corrected")->x.values);
    CHECK_THAT(section.text, Contains("Recommended for the joint with frictional-memory: k_{p} = "));
    CHECK_THAT(section.text, Contains("states no noise") && Contains("states no period, and 1 ms was taken"));
    CHECK_THAT(section.tables[0].rows[0][1], Contains("1 mm/s") && !Contains("between"));
    CHECK_THAT(section.tables[0].rows[1][1], Contains("between"));
}

TEST_CASE("right gains are no softer than the joint's own where those may stay", "[report][slow]")
{
    // friction that only damps: least noise alone would give the position up
    Joint before = example_joint(8e3, 120, 1e-2);
    before.friction.law = CoulombViscous{8, 15};
    Joint after = before;
    after.mechanism.inertia *= 1.3;
    const auto gains = corrected_gains(before, after, 1e-2, test::in_order);
    REQUIRE((gains.right && gains.right->feasible));
    CHECK(gains.right->best.k_p >= 8e3 * (1 - 1e-9));
}

TEST_CASE("what acts by position or time enters by simulation", "[report][slow]")
{
    // 100 N/mm of cogging beside 60 N/mm of the loop: linear theory has no term for it
    Joint before = example_joint(60e3, 200, 1e-3);
    before.friction.law = CoulombViscous{5, 50};
    Joint after = before;
    after.load.cogging.amplitude = 100, after.load.cogging.periods = 1e3;
    CHECK(linear_verdict(after).state_variable.stable);
    const auto gains = corrected_gains(before, after, 1e-3, test::in_order);
    Section section;
    add_corrected_gains(section, gains, units_of(before), "with cogging");
    CHECK_THAT(section.tables[0].rows[0][1], Contains("1 mm/s") && !Contains("between"));
    CHECK_THAT(section.tables[0].rows[1][1], Contains("between"));
    CHECK(gains.motion_after.time.back() > 2 * 2 * 3.14 / (1e3 * 1e-3));  // two turns of the cogging
}

TEST_CASE("a joint that stands still or controls a force is offered no gains", "[report]")
{
    const Joint joint = with_length(1e-5);
    Section section;
    add_corrected_gains(section, corrected_gains(joint, joint, missing, test::in_order), units_of(joint),
                        "with nothing");
    CHECK(section.tables.empty());
    Joint forced = joint;
    forced.control.kind = ControlKind::force;
    add_corrected_gains(section, corrected_gains(forced, forced, 1e-3, test::in_order), units_of(joint),
                        "with nothing");
    CHECK_THAT(section.text, Contains("No gains were looked for: the motor is a source of force"));
}

namespace {

std::string text_of(const CorrectedGains& gains, const Joint& joint)
{
    Section section;
    add_corrected_gains(section, gains, units_of(joint), "with frictional-memory");
    return section.text;
}

/// The documented joint behind dead time, and with a shorter slip distance.
std::pair<Joint, Joint> behind_dead_time()
{
    Joint before = example_joint(80e3, 10, 1e-3);
    before.control.delay = 1e-3;
    Joint after = before;
    std::get<RateAndState>(after.friction.law).L[0] = 8e-6;
    return {before, after};
}

}  // namespace

TEST_CASE("right gains behind dead time without a period: stickslip design searches them", "[report][slow]")
{
    const auto [before, after] = behind_dead_time();
    const auto late = corrected_gains(before, after, 1e-3, test::in_order);
    CHECK(late.none == NoGains::dead_time);
    CHECK_FALSE(late.right);
    CHECK_THAT(text_of(late, before), Contains("No gains were looked for: behind dead time without a period") &&
                                          Contains("stickslip design corrected-joint.toml does it"));
}

TEST_CASE("right gains behind dead time with a period are searched", "[report][slow]")
{
    auto [before, after] = behind_dead_time();
    for (Joint* joint : {&before, &after}) joint->control.period = 1e-3;
    const auto ticked = corrected_gains(before, after, 1e-3, test::in_order);
    REQUIRE((ticked.right && ticked.right->feasible));
    Joint right = after;
    right.control.V0 = 1e-3, right.control.k_p = ticked.right->best.k_p, right.control.k_v = ticked.right->best.k_v;
    CHECK(linear_verdict(right).loop.kind == LoopKind::sampled);
    CHECK(linear_verdict(right).state_variable.stable);
    CHECK_THAT(text_of(ticked, before),
               Contains("Recommended for the joint with frictional-memory: k_{p} = ") && !Contains("states no period"));
}

TEST_CASE("an interruption of the search for gains leaves the rest of the page", "[report][slow]")
{
    const Joint before = with_length(1e-5), after = with_length(5e-6);
    const auto gains = corrected_gains(before, after, 1e-3, [](std::size_t, const auto&) { throw gap::Interrupted(); });
    CHECK(gains.none == NoGains::interrupted);
    Section section;
    add_corrected_gains(section, gains, units_of(before), "with frictional-memory");
    CHECK_THAT(section.text, Contains("the search was interrupted; stickslip design corrected-joint.toml does it"));
    CHECK((map_of(section, "map-nominal") && map_of(section, "map-corrected") && !map_of(section, "map-right")));
    CHECK(section.tables.size() == 1);  // how both joints move
}

TEST_CASE("a joint that is commanded backwards has its boundary, its motions and its gains", "[report][slow]")
{
    Joint before = with_length(1e-5), after = with_length(5e-6);
    for (Joint* joint : {&before, &after}) {  // the same law with an answer backwards, too
        RateAndStateRegularised law;
        static_cast<RateStateParameters&>(law) = std::get<RateAndState>(joint->friction.law);
        joint->friction.law = law;
    }
    const auto forth = moved_boundary(before, after, 1e-3), back = moved_boundary(before, after, -1e-3);
    CHECK(back.velocity == -1e-3);
    CHECK(back.speeds == forth.speeds);
    CHECK(back.after.low.front() == Approx(forth.after.low.front()));
    const auto section = moved_section(back, units_of(before), "with frictional-memory", "");
    CHECK_THAT(section.text, !Contains("no motion") && Contains("sticks and slips with frictional-memory"));
    CHECK(std::get<LineChart>(section.figures.at(0).picture).x_label.name.find("backwards") != std::string::npos);
    const auto gains = corrected_gains(before, after, -1e-3, test::in_order);
    REQUIRE((gains.right && gains.right->feasible));
    CHECK(gains.settled_after.low < -1e-3);
    CHECK(gains.settled_after.high > -1e-3);
}
