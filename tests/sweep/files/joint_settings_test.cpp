#include "analysis/joint/parameters.h"
#include "sweep/files/toml/joint_file.h"
#include "tests/sweep/files/good_joint.h"
#include "tests/sweep/files/messages.h"

#include <catch2/catch.hpp>
#include <string>

using namespace stickslip;
using Catch::Contains;
using Catch::EndsWith;
using Catch::StartsWith;

TEST_CASE("settings change one value, with the same rules")
{
    Joint joint = read_joint_text(good, "joint.toml");
    apply_setting(joint, "control.k_p=3e4");
    CHECK(joint.control.k_p == 3e4);
    apply_setting(joint, "control.k_p = 25 kN/m");
    CHECK(joint.control.k_p == 25e3);
    apply_setting(joint, "control.kind=force");
    CHECK(joint.control.kind == ControlKind::force);
    apply_setting(joint, "control.reference_velocity=false");
    CHECK(!joint.control.reference_velocity);
    apply_setting(joint, "friction.B=[1, 2 ]");
    apply_setting(joint, "friction.L=[1e-5, \"20 µm\"]");
    apply_setting(joint, "friction.L.1=30 µm");
    apply_setting(joint, "friction.L.0=3e-6");
    const auto& law = std::get<RateAndState>(joint.friction.law);
    CHECK(law.B.size == 2);
    CHECK(law.L[0] == 3e-6);
    CHECK(law.L[1] == 3e-5);
    apply_setting(joint, "friction.law=rate-and-state");  // the same law keeps its numbers
    CHECK(std::get<RateAndState>(joint.friction.law).f0 == 60);
    apply_setting(joint, "control.velocity_estimate={tau=0.1}");
    CHECK(joint.control.velocity_estimate.tau == 0.1);
    apply_settings(
        joint, {"friction.law=stribeck", "friction.c0=1", "friction.c1=2", "friction.c2=3", "friction.c3=\"4 mm/s\""});
    CHECK(std::get<Stribeck>(joint.friction.law).c3 == 4e-3);
}

TEST_CASE("settings that are wrong change nothing")
{
    Joint joint = read_joint_text(good, "joint.toml");
    const std::string before = canonical_text(joint);
    const auto error = [&](const std::string& setting) {
        const auto all = messages_of([&] { apply_setting(joint, setting); });
        INFO(setting);
        REQUIRE(all.size() == 1);
        return all.front();
    };
    CHECK(error("control.k_p=fast") ==
          "--set control.k_p=fast: control.k_p: \"fast\" is not a number with a unit such as N/m");
    CHECK_THAT(error("control.kp=1"),
               StartsWith("--set control.kp=1: control.kp: unknown key") && EndsWith("\"k_p\"?"));
    CHECK_THAT(error("k_p=1"), EndsWith("did you mean \"control.k_p\"?"));
    CHECK_THAT(error("control.k_p"), EndsWith("is not a setting, expected path=value such as control.k_p=2e4"));
    CHECK_THAT(error("=3"), Contains("is not a setting"));
    CHECK_THAT(error("control.k_p=1 mm"), EndsWith("expected N/m"));
    CHECK_THAT(error("control.k_p="), Contains("is not a number"));
    CHECK_THAT(error("control.k_p=1\nx=2"), Contains("control.k_p"));
    CHECK_THAT(error("control=3"), EndsWith("control: is 3, expected a table"));
    CHECK_THAT(error("friction.L.1=3"),
               EndsWith("friction.L.1: there is no such element; the list has 1, counted from 0"));
    CHECK_THAT(error("friction.law=stribek"), EndsWith("did you mean \"stribeck\"?"));
    CHECK_THAT(error("friction.c0=1"), Contains("it belongs to friction.law = \"stribeck\""));
    CHECK_THAT(error("joint.inertia=-1"), EndsWith("is -1, expected a number in kg, > 0"));
    const auto incomplete = messages_of([&] { apply_settings(joint, {"friction.law=stribeck", "friction.c0=1"}); });
    CHECK(incomplete.size() == 3);
    CHECK(messages_of([&] { apply_settings(joint, {"a=1", "b=1", "control.k_p=1"}); }).size() == 2);
    CHECK(canonical_text(joint) == before);
}

TEST_CASE("a setting takes numbers without a digit on either side of the point", "[files]")
{
    Joint joint;
    joint.mechanism.inertia = 1, joint.control.k_p = 1, joint.control.V0 = 1e-3;
    joint.friction.law = CoulombViscous{1, 0};
    apply_settings(joint, {"control.k_p=.4", "control.k_v=5.", "joint.inertia=+.25e1"});
    CHECK(joint.control.k_p == 0.4);
    CHECK(joint.control.k_v == 5);
    CHECK(joint.mechanism.inertia == 2.5);
    CHECK_THROWS(apply_settings(joint, {"control.k_p=."}));
}
