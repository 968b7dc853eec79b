// That a simulation contradicts the linear theory is a part of the answer, not only of its sentences.
#include "tests/program/run.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using Catch::Matchers::Contains;
using Json = nlohmann::json;
using program::Folder;
using program::stickslip;

TEST_CASE("terms by which a simulation contradicts the linear theory stand in the answer", "[program][contradiction]")
{
    // the friction falls by 47.5 N·s/m at V_0 and k_v is 10: unstable. A push by the position error fades as the joint
    // moves faster, 3 N (1 − tanh²(0.4))/(0.05 m/s) = 51.3 N·s/m of damping that the linear theory has no term for
    Folder folder;
    const auto joint = folder.write(
        "joint.toml",
        "[joint]\ninertia = 2.0\n[control]\nk_p = 2000.0\nk_v = 10.0\nV0 = 0.02\n"
        "feed_forward = { coulomb = 3.0, coulomb_speed = 0.05, coulomb_from = \"error\", coulomb_width = 1e-5 }\n"
        "[friction]\nlaw = \"stribeck\"\nc0 = 5.0\nc1 = 10.0\nc2 = 2.0\nc3 = 0.03\nc4 = 2.0\n");
    const std::string call = "evaluate '" + joint + "' ";
    const auto run = stickslip(call + "--json");
    INFO(run.output);
    REQUIRE(run.exit_code == 0);
    const auto json = Json::parse(run.output);
    REQUIRE(json["linear"]["state_variable"]["stable"] == false);
    REQUIRE(json["nonlinear"]["growth_rate"].get<double>() < 0);
    CHECK(json["contradicting_terms"] == Json::array({"control.feed_forward.coulomb_from"}));
    CHECK_THAT(stickslip(call).output, Contains("which has no term for control.feed_forward.coulomb_from"));
    const auto plain = stickslip(call + "--set control.feed_forward.coulomb=0 --json");
    CHECK(Json::parse(plain.output)["contradicting_terms"] == Json::array());
}
