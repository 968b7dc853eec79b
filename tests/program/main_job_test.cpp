// The main job as a user runs it: sweep, evaluate, check.
#include "tests/program/run.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <cmath>

using Catch::Matchers::Contains;
using Json = nlohmann::json;
using program::Folder;
using program::stickslip;

TEST_CASE("a sweep without a spec runs the embedded example and says where everything is", "[program][slow]")
{
    Folder folder;
    const auto run = stickslip("sweep -o '" + (folder / "out") + "'");
    INFO(run.output);
    REQUIRE(run.exit_code == 0);
    CHECK_THAT(run.output, Contains("Slides smoothly"));
    CHECK_THAT(run.output, Contains("k_cr = 53.9 kN/m"));  // ((0.5 − 0.01)/1e-5)(1 + 1e-3/(1e-5·1010)) = 53851.5
    CHECK_THAT(run.output, Contains(folder / "out/report.html"));
    CHECK(std::filesystem::file_size(folder / "out/report.html") > 10000);
    CHECK(std::filesystem::file_size(folder / "out/results.nc") > 1000000);
}

TEST_CASE("evaluate answers with the documented names", "[program]")
{
    const auto run = stickslip(
        "evaluate examples/02-ball-screw/joint-with-memory.toml --set control.k_p=2e4 --set control.k_v=0 --json");
    INFO(run.output);
    REQUIRE(run.exit_code == 0);
    const auto json = Json::parse(run.output);
    CHECK(json["linear"]["velocity_only"]["stable"] == false);
    CHECK(json["linear"]["velocity_only"]["k_v_min"].get<double>() == Approx(0.2 / 1e-4));
    const auto& memory = json["linear"]["state_variable"];
    // ((B − A)/L)(1 + m V_0²/(L A)) = 4e4 (1 + 95.1089e-8/1e-6)
    CHECK(memory["k_cr"].get<double>() == Approx(4e4 * (1 + 0.951089)).epsilon(1e-12));
    CHECK(memory["stable"] == false);
    CHECK(memory["spectral_abscissa"].get<double>() > 0);
    CHECK(memory["eigenvalues"].size() == 3);
    CHECK(memory["crossings"][0]["direction"] == -1);
    CHECK(memory["stable_intervals"][0][1].is_null());
    CHECK(json["steady"]["friction"].get<double>() == Approx(20.39 - 0.2 * std::log(0.1)));
}

TEST_CASE("evaluate and simulate take a spec as its design point, with its disturbance", "[program]")
{
    Folder folder;
    auto text = program::read(std::string(SOURCE_ROOT) + "/examples/03-bistable-strip/spec.toml");
    const auto at = text.find("enabled = true");
    REQUIRE(at != std::string::npos);
    text.insert(at, "disturbance = { kind = \"start\", size = 1e-4 }\n");
    const auto spec = folder.write("strip.toml", text);
    // inside the strip the end of the motion is told by the disturbance alone
    const auto far = Json::parse(stickslip("evaluate '" + spec + "' --json").output)["nonlinear"];
    CHECK(far["disturbance"]["kind"] == "start");
    CHECK(far["disturbance"]["size"] == 1e-4);
    CHECK(far["outcome"] == "limit-cycle");
    const auto near =
        Json::parse(stickslip("evaluate '" + spec + "' --disturbance position --json").output)["nonlinear"];
    CHECK(near["disturbance"]["kind"] == "position");
    CHECK(near["outcome"] == "stable-sliding");
    CHECK(near["region"] == "bistable");
    const auto motion = stickslip("simulate '" + spec + "' -o '" + (folder / "motion") + "'");
    INFO(motion.output);
    CHECK(motion.exit_code == 0);
    CHECK_THAT(motion.output, Contains("limit cycle"));
}

TEST_CASE("the shipped baseline holds, and a changed joint is caught", "[program][slow]")
{
    const std::string folder_of = "examples/02-ball-screw/";
    const auto held = stickslip("check " + folder_of + "spec-with-memory.toml " + folder_of + "baseline.json");
    INFO(held.output);
    CHECK(held.exit_code == 0);

    Folder folder;
    auto joint = program::read(std::string(SOURCE_ROOT) + "/" + folder_of + "joint-with-memory.toml");
    const auto at = joint.find("L = 5.0e-6");
    REQUIRE(at != std::string::npos);
    joint.replace(at, 10, "L = 5.1e-6");
    folder.write("joint-with-memory.toml", joint);
    const auto spec =
        folder.write("spec.toml", program::read(std::string(SOURCE_ROOT) + "/" + folder_of + "spec-with-memory.toml"));
    const auto moved =
        stickslip("check '" + spec + "' " + folder_of + "baseline.json --junit '" + (folder / "junit.xml") + "'");
    INFO(moved.output);
    CHECK(moved.exit_code == 1);
    CHECK_THAT(moved.output, Contains("moved by"));
    CHECK_THAT(program::read(folder / "junit.xml"), Contains("<failure"));
    const auto first = stickslip("check '" + spec + "' '" + (folder / "own.json") + "' --update");
    CHECK(first.exit_code == 0);
    CHECK(stickslip("check '" + spec + "' '" + (folder / "own.json") + "'").exit_code == 0);
    CHECK(stickslip("check '" + spec + "' '" + (folder / "nothing.json") + "'").exit_code == 2);
}

TEST_CASE("the page can be drawn again from the results alone", "[program][slow]")
{
    Folder folder;
    // The default sweep: its first page once had two labels shifted by what was drawn before them.
    REQUIRE(stickslip("sweep -o '" + (folder / "out") + "'").exit_code == 0);
    const auto first = program::read(folder / "out/report.html");
    const auto draw_again = [&] {
        std::filesystem::remove(folder / "out/report.html");
        const auto run = stickslip("report '" + (folder / "out") + "'");
        INFO(run.output);
        CHECK(run.exit_code == 0);
        CHECK(program::read(folder / "out/report.html") == first);
    };
    const std::string charts = folder / "out/charts";
    const auto map = program::read(charts + "/map-k-p-k-v.png"), locus = program::read(charts + "/root-locus.svg");
    const auto written = std::filesystem::last_write_time(charts + "/map-k-p-k-v.png");
    draw_again();
    CHECK(std::filesystem::last_write_time(charts + "/map-k-p-k-v.png") == written);  // a chart of the same is kept

    // charts that are lost or damaged, or not known to be of this sweep, are drawn
    folder.write("out/charts/map-k-p-k-v.png", map.substr(0, 1000));
    std::filesystem::remove(charts + "/root-locus.svg");
    draw_again();
    CHECK(program::read(charts + "/map-k-p-k-v.png") == map);
    CHECK(program::read(charts + "/root-locus.svg") == locus);
    for (const std::string index : {"not ours", "{\"format\":\"stickslip-charts/1\",\"charts\":{\"root-locus\":7}}"}) {
        folder.write("out/charts/drawn.json", index);
        draw_again();
    }
    std::filesystem::remove_all(charts);
    draw_again();
    CHECK(program::read(charts + "/root-locus.svg") == locus);
}
