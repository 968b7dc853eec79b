// new, list keys, export and import as a user types them.
#include "tests/program/run.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <sstream>
#include <string>

using program::shell;
using program::stickslip;

TEST_CASE("a new file of every model and law runs", "[slow]")
{
    const TemporaryDirectory room;
    const std::string file = (room / "joint.toml").string(), spec = (room / "spec.toml").string();
    for (const std::string model : {"single-mass", "two-mass", "three-mass", "lever"})
        for (const std::string law : {"coulomb-viscous", "stribeck", "rate-and-state", "lugre", "maxwell-slip"}) {
            CAPTURE(model, law);
            CHECK(stickslip("new joint --model " + model + " --law " + law + " --force -o " + file).exit_code == 0);
            CHECK(stickslip("evaluate " + file + " --json").exit_code != 2);
        }
    CHECK(stickslip("new spec -o " + spec).exit_code == 0);
    CHECK(stickslip("sweep " + spec + " --no-report -o " + (room / "out").string()).exit_code == 0);
    const auto again = stickslip("new spec -o " + spec);
    CHECK(again.exit_code == 2);
    CHECK_THAT(again.output, Catch::Contains("exists already"));
    CHECK_THAT(stickslip("new joint --law stribek").output, Catch::Contains("did you mean stribeck"));
}

TEST_CASE("list keys shows words as well as numbers without a file")
{
    const auto listed = stickslip("list keys --model two-mass --law lugre");
    CHECK(listed.exit_code == 0);
    for (const char* text : {"control.reference_velocity", "true, false", "friction.motor.law", "single-mass, two-mass",
                             "joint.transmission.stiffness", "required"})
        CHECK_THAT(listed.output, Catch::Contains(text));
    // a terminal shows its lines: a long cell is wrapped
    std::istringstream lines(listed.output);
    for (std::string line; std::getline(lines, line);) {
        CAPTURE(line);
        CHECK(line.size() <= 160);
        CHECK(line.find_last_not_of(' ') + 1 == line.size());
    }
    const auto json = nlohmann::json::parse(stickslip("list keys --json").output).at("entries");
    CHECK(json.at(0).at("path") == "joint.motion");
    CHECK(json.at(0).at("value") == "prismatic");
}

TEST_CASE("export writes text for each simulator, and what is lost to standard error", "[slow]")
{
    const std::string joint = "examples/02-ball-screw/joint-with-memory.toml";
    for (const std::string to : {"mjcf", "urdf", "sdf", "isaaclab", "ros2_control"}) {
        const auto json = nlohmann::json::parse(stickslip("export " + joint + " --json --to " + to).output);
        CHECK(json.at("format") == "stickslip-export/1");
        CHECK(json.at("to") == to);
        CHECK(json.at("gap_left").is_null());
        CHECK(json.at("text").get<std::string>().size() > 100);
        bool memory = false;
        for (const auto& lost : json.at("not_expressible"))
            memory = memory || (lost.at("key") == "friction.B" && lost.at("why").get<std::string>().size() > 20);
        CHECK(memory);
    }
    const auto text = stickslip("export " + joint + " --to urdf 2>/dev/null");
    CHECK(text.output.find("Not in this text") == std::string::npos);
    CHECK_THAT(stickslip("export " + joint + " --to mjfc").output, Catch::Contains("did you mean mjcf"));
    CHECK_THAT(stickslip("export " + joint + " --to mjcf --link-inertia 1e3").output,
               Catch::Contains("--link-inertia"));
    // well formed, as another program sees it
    for (const std::string to : {"mjcf", "urdf", "sdf"})
        CHECK(
            shell(
                "\"" STICKSLIP "\" export " + joint + " --to " + to +
                " 2>/dev/null | python3 -c 'import sys, xml.dom.minidom as x; x.parseString(sys.stdin.buffer.read())'")
                .exit_code == 0);
    CHECK(shell("\"" STICKSLIP "\" export " + joint +
                " --to isaaclab 2>/dev/null | python3 -c 'import ast, sys; ast.parse(sys.stdin.read())'")
              .exit_code == 0);
}

TEST_CASE("the transmission of an exported joint does not come back by import, which says so")
{
    const TemporaryDirectory room;
    const std::string two = (room / "joint.toml").string(), robot = (room / "elbow.xml").string();
    CHECK(stickslip("new joint --motion revolute --model two-mass --law coulomb-viscous --plain -o " + two).exit_code ==
          0);
    CHECK(stickslip("export " + two + " --to mjcf --name elbow > " + robot).exit_code == 0);
    for (const std::string joint : {"elbow", "elbow_motor"}) {
        const auto json =
            nlohmann::json::parse(stickslip("import " + robot + " --joint " + joint + " --json 2>/dev/null").output);
        REQUIRE(json.at("not_taken").size() == 1);
        const auto& tendon = json.at("not_taken").at(0);
        CHECK(tendon.at("reason") == "coupling");
        CHECK(tendon.at("element") == "fixed");
        CHECK(tendon.at("name") == "elbow_transmission");
        CHECK_THAT(tendon.at("attributes").get<std::string>(), Catch::Contains("stiffness=\""));
        CHECK_THAT(tendon.at("place").get<std::string>(), Catch::StartsWith(robot + ":"));
        CHECK_THAT(json.at("text").get<std::string>(), Catch::Contains("<fixed \"elbow_transmission\">"));
        CHECK_THAT(stickslip("import " + robot + " --joint " + joint + " 2>&1 >/dev/null").output,
                   Catch::Contains("note: ") && Catch::Contains("couples joints"));
    }
}

TEST_CASE("what is exported comes back by import")
{
    const TemporaryDirectory room;
    const std::string joint = (room / "joint.toml").string(), robot = (room / "elbow.xml").string();
    CHECK(stickslip("new joint --motion revolute --law coulomb-viscous --plain --set load.gravity_amplitude=0.3 --set "
                    "load.gravity_phase=0.4 -o " +
                    joint)
              .exit_code == 0);
    CHECK(stickslip("export " + joint + " --to mjcf --name elbow > " + robot).exit_code == 0);
    const auto json = nlohmann::json::parse(stickslip("import " + robot + " --joint elbow --json").output);
    CHECK(json.at("inertia").get<double>() == Approx(0.05).epsilon(1e-7));
    CHECK(json.at("gravity").at("amplitude").get<double>() == Approx(0.3).epsilon(1e-7));
    CHECK(json.at("gravity").at("phase").get<double>() == Approx(0.4).epsilon(1e-7));
    CHECK(json.at("missing").empty());
    const auto wrong = stickslip("import " + robot + " --joint elbwo");
    CHECK(wrong.exit_code == 2);
    CHECK_THAT(wrong.output, Catch::Contains("did you mean \"elbow\""));
}
