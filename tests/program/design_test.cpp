// stickslip design as a user runs it.
#include "tests/program/run.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using Catch::Matchers::Contains;
using Json = nlohmann::json;
using program::Folder;
using program::stickslip;

namespace {

const std::string spec = "design examples/04-design/spec.toml ";

}  // namespace

TEST_CASE("design finds gains, their front, and what velocity-only thinking costs", "[program][design][slow]")
{
    Folder folder;
    const auto run = stickslip(spec + "--require front_points=4 --json -o '" + (folder / "out") + "'");
    INFO(run.output);
    REQUIRE(run.exit_code == 0);
    const auto json = Json::parse(run.output);
    CHECK(json["feasible"] == true);
    CHECK(json["best"]["margin"].get<double>() >= 1 - 1e-5);
    CHECK(json["best"]["peak_effort"].get<double>() <= 80 * (1 + 1e-5));
    CHECK(json["best"]["k_p"].get<double>() >= 2e4 * (1 - 1e-9));
    // the spring of the position gain carries the 60 N of friction; so it does with the joint's own gains
    for (const char* choice : {"best", "velocity_only", "as_joint"})
        CHECK(json[choice]["steady_deflection"].get<double>() ==
              Approx(60 / json[choice]["k_p"].get<double>()).epsilon(1e-9));
    // (B − A)/V_0 = 500 N·s/m is the least that velocity-only theory allows
    CHECK(json["velocity_only"]["k_v"].get<double>() > 500);
    CHECK(json["velocity_only"]["motion_noise"].get<double>() >= 0.999 * json["best"]["motion_noise"].get<double>());
    CHECK(json["front"].size() >= 3);
    for (std::size_t i = 1; i < json["front"].size(); ++i) {
        CHECK(json["front"][i]["margin"].get<double>() > json["front"][i - 1]["margin"].get<double>());
        CHECK(json["front"][i]["cost"].get<double>() >= 0.99 * json["front"][i - 1]["cost"].get<double>());
    }
    CHECK(std::filesystem::file_size(folder / "out/report.html") > 10000);
    CHECK(Json::parse(program::read(folder / "out/design.json"))["best"] == json["best"]);
}

TEST_CASE("design says why nothing is feasible, and what would be", "[program][design][slow]")
{
    const auto run = stickslip(spec + "--require effort_limit=60.001 --require front_points=2");
    INFO(run.output);
    CHECK(run.exit_code == 1);
    CHECK_THAT(run.output,
               Contains("No gains within the range meet every requirement") && Contains("peak effort can be"));
}

TEST_CASE("design refuses what means nothing", "[program][design]")
{
    const auto silent = stickslip("design examples/02-ball-screw/joint-with-memory.toml");
    CHECK(silent.exit_code == 2);
    // all that is missing, named at once
    CHECK_THAT(silent.output, Contains("requirements.position_noise") && Contains("requirements.sample_time"));
    const auto timeless =
        stickslip("design examples/02-ball-screw/joint-with-memory.toml --require 'position_noise=1 um'");
    CHECK(timeless.exit_code == 2);
    CHECK_THAT(timeless.output, Contains("sample_time"));
    const auto misspelt = stickslip(spec + "--require margim=1");
    CHECK(misspelt.exit_code == 2);
    CHECK_THAT(misspelt.output, Contains("did you mean \"margin\"?"));
    CHECK(stickslip(spec + "--require 'effort_limit=3 m'").exit_code == 2);
}
