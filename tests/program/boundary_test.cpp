// stickslip boundary as a user runs it.
#include "tests/program/run.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <cmath>

using Catch::Matchers::Contains;
using Json = nlohmann::json;
using program::Folder;
using program::stickslip;

TEST_CASE("boundary answers with located points that carry their brackets", "[program][boundary]")
{
    const auto run = stickslip(
        "boundary examples/02-ball-screw/joint-with-memory.toml --set control.k_v=0 --along control.k_p=1e3..1e7 "
        "--kind linear --json");
    INFO(run.output);
    REQUIRE(run.exit_code == 0);
    const auto json = Json::parse(run.output);
    const auto& point = json["lines"][0]["points"][0];
    CHECK(point["value"].get<double>() == Approx(4e4 * (1 + 0.951089)).epsilon(1e-9));
    CHECK(point["low"] <= point["value"]);
    CHECK(point["high"] >= point["value"]);
    CHECK(point["precision"].get<double>() <= 1e-9);
    CHECK(point["status"] == "located");
    CHECK(point["method"] == "interpolation");
    CHECK(point["direction"] == -1);
    CHECK(point["evaluations"].get<int>() > 0);
    CHECK_FALSE(json["lines"][0]["could_be_missed"].get<std::string>().empty());
}

TEST_CASE("boundary follows a curve and writes it with its page", "[program][boundary]")
{
    Folder folder;
    const auto run = stickslip(
        "boundary examples/01-reference-joint/spec.toml --kind linear --over control.k_p control.V0=1e-6..1e-2 "
        "--set control.k_v=0 -o '" +
        (folder / "out") + "'");
    INFO(run.output);
    REQUIRE(run.exit_code == 0);
    const auto json = Json::parse(program::read(folder / "out/boundary.json"));
    int points = 0;
    for (const auto& piece : json["curves"][0]["pieces"])
        for (const auto& p : piece["points"]) {
            const double V = p["y"].get<double>();
            // m V_0²/(L A): 1e-7 … 10
            CHECK(p["x"].get<double>() == Approx(5e4 * (1 + V * V / 1e-5)).epsilon(1e-9));
            ++points;
        }
    CHECK(points > 10);
    CHECK(std::filesystem::file_size(folder / "out/report.html") > 10000);
    CHECK_THAT(program::read(folder / "out/boundary.csv"), Contains("linear,control.k_p,control.V0,0,"));
}

TEST_CASE("boundary answers impossible requests with what is possible", "[program][boundary][slow]")
{
    const std::string joint = "boundary examples/02-ball-screw/joint-with-memory.toml --set control.k_v=0 ";
    const auto outside = stickslip(joint + "--kind linear --along control.k_p=1e6..1e7");
    CHECK(outside.exit_code == 0);
    CHECK_THAT(outside.output,
               Contains("No linear boundary") && Contains("stable throughout") && Contains("78.04356 kN/m"));
    const auto endless = stickslip(joint + "--along control.k_p=1..");
    CHECK(endless.exit_code == 2);
    CHECK_THAT(endless.output, Contains("--along control.k_p: got \"1..\", expected a range such as"));
    const auto misspelt = stickslip(joint + "--along control.kp=1..2");
    CHECK(misspelt.exit_code == 2);
    CHECK_THAT(misspelt.output, Contains("did you mean \"control.k_p\"?"));
    const auto unit = stickslip(joint + "--along 'control.V0=1 N..2 N'");
    CHECK(unit.exit_code == 2);
    CHECK_THAT(unit.output, Contains("expected m/s"));
    const auto least = stickslip(joint + "--kind v-min --along control.k_p");
    CHECK(least.exit_code == 2);
    CHECK_THAT(least.output, Contains("--over control.k_p control.V0"));
    const auto reversed = stickslip(joint + "--along control.k_p=2..1");
    CHECK(reversed.exit_code == 2);
    const auto open = stickslip(joint + "--along load.constant=-1..x");
    CHECK(open.exit_code == 2);
    const auto range = stickslip(joint + "--along control.k_v");
    CHECK(range.exit_code == 2);
    CHECK_THAT(range.output, Contains("--along control.k_v=FROM..TO"));
}

TEST_CASE("folds along the position gain are looked for in joints of several bodies, too", "[program][slow]")
{
    for (const char* joint : {"three-mass", "memory"}) {
        const auto run = stickslip(std::string("boundary tests/fuzz/corpus/joint/") + joint +
                                   ".toml --along control.k_p=1e3..1e6 --kind fold --threads 1");
        INFO(run.output);
        CHECK((run.exit_code == 0 || run.exit_code == 4));
        CHECK(run.output.find("evaluations") != std::string::npos);
    }
}

TEST_CASE("boundary refuses one path along two axes", "[program][boundary]")
{
    const std::string ask = "boundary examples/02-ball-screw/joint-with-memory.toml --kind linear --along ";
    const auto twice = stickslip(ask + "control.k_p=1e4..1e5 --along control.k_p=1e5..1e6");
    INFO(twice.output);
    CHECK(twice.exit_code == 2);
    CHECK_THAT(twice.output, Contains("--along: got control.k_p twice, expected different axes"));
    CHECK(stickslip(ask + "control.k_p=1e4..1e5 --along control.k_v=1..100").exit_code == 0);
}

TEST_CASE("gains that evaluate does not search in a loop are found where it says", "[program][boundary]")
{
    // force control through a transmission, with dead time; another program finds the edges 67.0178 and 247.3689 kN/m
    const Folder folder;
    const auto joint = folder.write("joint.toml", R"([joint]
motion = "prismatic"
model = "two-mass"
motor_inertia = 0.5
link_inertia = 1.0
transmission = { stiffness = 1e5, damping = 5.0 }
[control]
kind = "force"
k_p = 2.0e5
k_v = 10.0
force_rate = 200.0
force_gain = 0.5
delay = 1e-3
contact_stiffness = 1e4
[friction.motor]
law = "coulomb-viscous"
coulomb = 1.0
viscous = 5.0
[friction.link]
law = "rate-and-state"
f0 = 60
A = 1.0
B = 1.5
L = 1e-5
V_star = 1e-3
)");
    const auto told = stickslip("evaluate '" + joint + "'");
    INFO(told.output);
    CHECK_THAT(told.output, Contains("not searched in this loop: boundary --along control.k_p finds it"));
    const auto found =
        Json::parse(stickslip("boundary '" + joint + "' --along control.k_p --kind linear --json").output);
    const auto& points = found["lines"][0]["points"];
    REQUIRE(points.size() == 2);
    CHECK(points[0]["value"].get<double>() == Approx(67017.8).epsilon(1e-6));
    CHECK(points[0]["direction"] == -1);
    CHECK(points[1]["value"].get<double>() == Approx(247368.9).epsilon(1e-6));
    CHECK(points[1]["direction"] == 1);
}
