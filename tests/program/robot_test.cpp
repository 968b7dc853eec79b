// stickslip diagnose --all-joints, as a user with an arm runs it: each joint's planted cause under its name, and every
// joint that cannot be diagnosed said beside the others.
#include "tests/program/run.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <cmath>
#include <map>
#include <sstream>
#include <vector>

using Catch::Matchers::Contains;
using program::Folder;
using program::stickslip;

namespace {

/// What a joint file says.
std::string joint_file(double inertia)
{
    return "[joint]\nmotion = \"revolute\"\ninertia = " + std::to_string(inertia) +
           "\n[control]\nk_p = 400\nk_v = 20\nperiod = 2e-3\n"
           "velocity_estimate = { form = \"backward-difference\" }\n"
           "[friction]\nlaw = \"coulomb-viscous\"\ncoulomb = 1.0\nviscous = 0.3\n"
           "[sensor]\nencoder_quantum = 1e-6\nposition_noise = 1e-6\n";
}

/// A motion to and fro that every joint makes.
std::string motion()
{
    std::string text = "time,reference_position\n";
    for (int k = 0; k < 1500; ++k) {
        const double t = 2e-3 * k;
        text += std::to_string(t) + "," + std::to_string(0.4 * (1 - std::cos(3.5 * t))) + "\n";
    }
    return text;
}

std::vector<std::vector<std::string>> cells(const std::string& file)
{
    std::vector<std::vector<std::string>> rows;
    std::istringstream in(program::read(file));
    for (std::string line; std::getline(in, line);) {
        if (line.starts_with('#')) continue;
        rows.emplace_back();
        std::istringstream row(line);
        for (std::string cell; std::getline(row, cell, ',');) rows.back().push_back(cell);
    }
    return rows;
}

/// One table of all joints: what each joint's loop logs with a cause planted in it, columns `NAME_signal`.
std::string log_of(const Folder& folder, const std::vector<std::pair<std::string, std::string>>& planted,
                   const std::string& joiner = "_")
{
    const auto reference = folder.write("motion.csv", motion());
    std::vector<std::string> lines;
    int seed = 0;
    for (const auto& [name, cause] : planted) {
        const auto out = folder / ("loop-" + name);
        const auto run =
            stickslip("simulate '" + (folder / (name + ".toml")) + "' --reference '" + reference + "' --seed " +
                      std::to_string(++seed) + (cause.empty() ? "" : " --set " + cause) + " -o '" + out + "'");
        REQUIRE(run.exit_code == 0);
        const auto rows = cells(out + "/record.csv");
        lines.resize(rows.size());
        for (std::size_t i = 0; i < rows.size(); ++i)
            for (std::size_t k = lines[i].empty() ? 0 : 1; k < rows[i].size(); ++k) {
                const bool named = i == 0 && rows[0][k] != "time";
                lines[i] += (lines[i].empty() ? "" : ",") + (named ? name + joiner : "") + rows[i][k];
            }
    }
    std::string text;
    for (const auto& line : lines) text += line + "\n";
    return text;
}

std::string robot_toml(const std::vector<std::string>& names)
{
    std::string text = "title = \"test arm\"\n[joints]\n";
    for (const auto& name : names) text += name + " = \"" + name + ".toml\"\n";
    return text;
}

nlohmann::json robot_json(const Folder& folder)
{
    return nlohmann::json::parse(program::read((folder / "out") + "/robot.json"));
}

program::Run diagnose(const Folder& folder, const std::string& words)
{
    return stickslip("diagnose " + words + " -o '" + (folder / "out") + "'");
}

}  // namespace

TEST_CASE("two joints of one log: each planted cause under its joint, and a page that leads to theirs",
          "[program][robot][slow]")
{
    const Folder folder;
    folder.write("shoulder.toml", joint_file(0.8)), folder.write("elbow.toml", joint_file(0.3));
    const auto log = folder.write(
        "run.csv", log_of(folder, {{"shoulder", "load.gravity_amplitude=6"}, {"elbow", "load.constant=3"}}));
    const auto robot = folder.write("robot.toml", robot_toml({"shoulder", "elbow"}));
    const auto run = diagnose(folder, "'" + robot + "' '" + log + "' --all-joints");
    INFO(run.output);
    REQUIRE(run.exit_code == 0);
    CHECK_THAT(run.output, Contains("2 of 2 joints differ from their files: shoulder by gravity"));
    const auto answer = robot_json(folder);
    CHECK(answer["format"] == "stickslip-robot-diagnosis/1");
    REQUIRE(answer["joints"].size() == 2);
    const std::map<std::string, std::string> cause{{"shoulder", "gravity"}, {"elbow", "load"}};
    for (const auto& joint : answer["joints"]) {
        const std::string name = joint["name"];
        INFO(name << ": " << joint.dump(1));
        CHECK(joint["status"] == "diagnosed");
        CHECK(joint["verdict"] == "gap");
        REQUIRE(!joint["causes"].empty());
        const auto own = nlohmann::json::parse(program::read((folder / "out/") + name + "/diagnosis.json"));
        CHECK(joint["causes"][0]["names"] == own["effects"][0]["names"]);
        CHECK(joint["gap"]["before"] == own["gap"]["overall"]["before"]);
        CHECK(joint["causes"][0]["share"].get<double>() > 0.9);
        CHECK(std::filesystem::exists((folder / "out/") + joint["page"].get<std::string>()));
        CHECK(std::filesystem::exists((folder / "out/") + joint["corrected_joint"].get<std::string>()));
        // no other joint's columns: the same as that joint's record alone
        const auto alone = stickslip("diagnose '" + (folder / (name + ".toml")) + "' '" + log + "' --joint " + name +
                                     " --no-report --json -o '" + (folder / "alone") + "'");
        REQUIRE(alone.exit_code == 0);
        CHECK(nlohmann::json::parse(alone.output)["effects"] == own["effects"]);
    }
    const auto page = program::read(folder / "out/robot.html");
    for (const char* name : {"shoulder", "elbow"})
        CHECK_THAT(page, Contains("<a href=\"" + std::string(name) + "/report.html\">" + name + "</a>"));
    CHECK_THAT(page, Contains("class=\"share5\""));
}

TEST_CASE("a joint that the log lacks, and one whose file is broken, are said and do not stop the third",
          "[program][robot][slow]")
{
    const Folder folder;
    for (const char* name : {"base", "elbow"}) folder.write(std::string(name) + ".toml", joint_file(0.3));
    folder.write("wrist.toml", "[joint]\ninertai = 2\n");
    const auto log = folder.write("run.csv", log_of(folder, {{"elbow", "load.constant=3"}}, "/"));
    const auto robot = folder.write("robot.toml", robot_toml({"base", "elbow", "wrist"}));
    auto run = diagnose(folder, "'" + robot + "' '" + log + "' --all-joints --no-report");
    INFO(run.output);
    CHECK(run.exit_code == 2);
    CHECK_THAT(run.output, Contains("has no joint base, it has elbow"));
    CHECK_THAT(run.output, Contains("wrist.toml:2:1: joint.inertai: unknown key"));
    CHECK_THAT(run.output, Contains("1 of 3 joints differs from its file: elbow by "));
    CHECK_THAT(run.output, Contains("Not diagnosed: base, wrist."));
    const auto answer = robot_json(folder);
    CHECK(answer["joints"][0]["status"] == "refused");
    CHECK(answer["joints"][1]["page"].is_null());
    CHECK(answer["joints"][2]["problems"].size() >= 1);
    CHECK(!std::filesystem::exists(folder / "out/robot.html"));
    // the same joints as a folder of joint files, one of them alone
    std::filesystem::remove(robot);
    std::filesystem::remove(folder / "wrist.toml");
    run = diagnose(folder, "'" + (folder / "") + "' '" + log + "' --joint base --no-report");
    CHECK(run.exit_code == 2);
    CHECK(robot_json(folder)["joints"].size() == 1);
}

TEST_CASE("what is no robot, or names no joints, is refused before any work", "[program][robot]")
{
    const Folder folder;
    const auto joint = folder.write("elbow.toml", joint_file(0.3));
    const auto plain = folder.write("run.csv", "time,position\n0,0\n0.001,0\n");
    const auto robot = folder.write("robot.toml", robot_toml({"elbow"}));
    const auto said = [&](const std::string& words, const std::string& expected) {
        const auto run = diagnose(folder, words);
        INFO(words);
        CHECK(run.exit_code == 2);
        CHECK_THAT(run.output, Contains(expected));
    };
    said("'" + robot + "' '" + plain + "'", "has several joints, expected --all-joints, or --joint NAME");
    said("'" + joint + "' '" + plain + "' --all-joints", "has no table [joints]");
    said("'" + robot + "' '" + plain + "' --joint elbwo", "has no joint elbwo, it has elbow; did you mean \"elbow\"?");
    // a plain `position` belongs to no joint: six joints would be diagnosed from one record
    said("'" + robot + "' '" + plain + "' --all-joints", "names no joints: expected columns such as elbow_position");
    const auto twice =
        folder.write("twice.toml", "[joints]\na = \"elbow.toml\"\nb = { file = \"elbow.toml\", name = \"a\" }\n");
    said("'" + twice + "' '" + plain + "' --all-joints", "joints.b: is called \"a\" in the log, as a is");
    const auto outside =
        folder.write("outside.toml", "[joints]\n\"../x\" = \"elbow.toml\"\nb = 3\nc = { path = \"x\" }\n");
    said("'" + outside + "' '" + plain + "' --all-joints", "outside.toml:2:");
    said("'" + outside + "' '" + plain + "' --all-joints", "joints.b: is 3, expected a joint file or { file, name }");
}

TEST_CASE("robot.toml says what columns are called, with the joint's name in the log", "[program][robot]")
{
    const Folder folder;
    folder.write("elbow.toml", joint_file(0.3));
    // what read_record refuses shows which columns it took
    const auto log = folder.write("run.csv", "t,j3 pos,j3 cmd,position\n0,0,0,1\n0.001,x,0,1\n");
    const auto robot = folder.write("robot.toml",
                                    "[joints]\nelbow = { file = \"elbow.toml\", name = \"j3\" }\n[record.columns]\n"
                                    "time = \"t\"\nposition = \"{joint} pos\"\neffort_command = \"{joint} cmd\"\n");
    const auto run = diagnose(folder, "'" + robot + "' '" + log + "' --all-joints --no-report");
    CHECK(run.exit_code == 2);
    CHECK_THAT(run.output, Contains("run.csv:3:7: position:"));
}
