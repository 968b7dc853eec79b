// What is told of a joint that moves backwards is what is told of the same joint forwards.
#include "tests/program/run.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using Json = nlohmann::json;
using program::Folder;
using program::stickslip;

TEST_CASE("the answer about a motion backwards mirrors that forwards", "[program][backwards]")
{
    Folder folder;
    const auto joint =
        folder.write("joint.toml",
                     "[joint]\ninertia = 2.0\n[control]\nk_p = 2000.0\nk_v = 20.0\nV0 = 0.02\n"
                     "[friction]\nlaw = \"stribeck\"\nc0 = 5.0\nc1 = 10.0\nc2 = 0.5\nc3 = 0.03\nc4 = 2.0\n");
    const std::string call = "evaluate '" + joint + "' --disturbance velocity ";
    const auto forwards = Json::parse(stickslip(call + "--size 0.01 --json").output),
               backwards = Json::parse(stickslip(call + "--size -0.01 --set control.V0=-0.02 --json").output);
    for (const char* theory : {"velocity_only", "state_variable"}) {
        const auto &a = forwards["linear"]["velocities"][theory], &b = backwards["linear"]["velocities"][theory];
        CHECK(a["reason_codes"] == Json::array({"stable-at-lowest"}));
        CHECK(b["reason_codes"] == a["reason_codes"]);
        CHECK(b["least"].get<double>() == -a["least"].get<double>());
        CHECK(b["all_above"].get<double>() == -a["all_above"].get<double>());
    }
    const auto &a = forwards["nonlinear"], &b = backwards["nonlinear"];
    CHECK(a["outcome"] == b["outcome"]);
    CHECK(a["overshoot"].get<double>() == Approx(b["overshoot"].get<double>()));
    CHECK(b["disturbance"]["size"] == -0.01);
    const auto page = folder / "page";
    REQUIRE(stickslip(call + "--set control.V0=-0.02 -o '" + page + "'").exit_code == 0);
    CHECK_THAT(program::read(page + "/report.html"), Catch::Matchers::Contains("V<sub>min</sub> ≤ 20 µm/s, backwards"));
}

TEST_CASE("a force on the link pushes the way its sign says, whichever way the joint moves", "[program][backwards]")
{
    Folder folder;
    const auto joint = folder.write("joint.toml",
                                    "[joint]\ninertia = 2.0\n[control]\nk_p = 2000.0\nk_v = 20.0\nV0 = 0.02\n"
                                    "[friction]\nlaw = \"coulomb-viscous\"\ncoulomb = 5.0\nviscous = 1.0\n");
    for (const double V0 : {0.02, -0.02}) {
        const auto run = stickslip("simulate '" + joint + "' --set control.V0=" + std::to_string(V0) +
                                   " --force step --force-size 0.5 -o '" + (folder / "out") + "'");
        INFO(run.output);
        REQUIRE(run.exit_code == 0);
        std::istringstream rows(program::read(folder / "out/trajectory.csv"));
        std::string row;
        std::getline(rows, row);
        double t = 0, velocity = 0;
        while (t < 1e-3 && std::getline(rows, row))
            REQUIRE(std::sscanf(row.c_str(), "%lf,%*f,%lf", &t, &velocity) == 2);
        REQUIRE(t < 3e-3);
        CHECK(velocity - V0 == Approx(0.5 * t / 2.0).epsilon(0.03));  // F t/m, before spring and damping answer
    }
}
