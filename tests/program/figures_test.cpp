// The paper's page and the page of a joint, as a user gets them.
#include "tests/program/run.h"

#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

using program::stickslip;

TEST_CASE("figures writes the page, the charts and the drawings, and meets every number", "[program][slow]")
{
    program::Folder folder;
    const auto run = stickslip("figures --json -o '" + (folder / "paper") + "'");
    CHECK(run.exit_code == 0);
    CHECK(program::read(folder / "paper/figures.json") == run.output);
    const auto numbers = nlohmann::json::parse(run.output).at("numbers");
    CHECK(numbers.size() >= 16);
    for (const auto& n : numbers) CHECK(n.at("relative_difference").get<double>() < 1e-6);
    for (const char* file : {"paper/report.html", "paper/charts/fig-3.svg", "paper/charts/regions.csv",
                             "paper/models/fig-4.svg", "paper/models/fig-7b.svg"}) {
        CAPTURE(file);
        CHECK(program::read(folder / file).size() > 1000);
    }
}

TEST_CASE("evaluate -o draws what the linear theory says of a joint", "[program]")
{
    program::Folder folder;
    const auto run =
        stickslip("evaluate examples/02-ball-screw/joint-with-memory.toml -o '" + (folder / "joint") + "'");
    CHECK(run.exit_code == 0);
    const auto printed = stickslip("evaluate examples/02-ball-screw/joint-with-memory.toml --json");
    CHECK(program::read(folder / "joint/evaluation.json") == printed.output);
    CHECK_THAT(run.output, Catch::Matchers::Contains("report.html"));
    for (const char* id : {"k-v-demanded", "response-curve"})
        CHECK_THAT(program::read(folder / "joint/report.html"), Catch::Matchers::Contains(id));
}

TEST_CASE("evaluate answers disturbances of every kind and refuses what it cannot follow", "[program][slow]")
{
    program::Folder folder;
    const std::string joint = "examples/02-ball-screw/joint-with-memory.toml";
    const std::string file = folder.write("force.csv", "time,force\n0,1\n1,1\n");
    for (const std::string& kind : std::vector<std::string>{"impulse", "step", "sine", "noise", file}) {
        const auto run = stickslip("evaluate " + joint + " --json --force '" + kind + "'");
        CAPTURE(kind);
        CHECK(run.exit_code == 0);
        CHECK(nlohmann::json::parse(run.output).at("linear").at("forced").at("peak").get<double>() > 0);
    }
    // a lasting force of 1 N is carried by k_p
    const auto step = nlohmann::json::parse(stickslip("evaluate " + joint + " --json --force step").output);
    CHECK(step.at("linear").at("forced").at("final").get<double>() == Approx(1 / 1.370727e6).epsilon(1e-3));
    CHECK(stickslip("evaluate " + joint + " --force nothing.csv").exit_code == 2);
}
