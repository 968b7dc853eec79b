// Points that a limit of effort leaves at rest for good: every page, terminal text and summary of a sweep says so.
#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

#include "tests/program/run.h"

using namespace program;

namespace {

/// 4 N of Coulomb and 6 N of static friction; sliding at 5 mm/s takes 5 N.
std::string joint_text(double k_v)
{
    return "[joint]\nmotion = \"prismatic\"\nmodel = \"single-mass\"\ninertia = 1\n[control]\nk_p = 2000\nk_v = " +
           std::to_string(k_v) +
           "\nV0 = 5e-3\nperiod = 1e-3\nvelocity_estimate = { form = \"backward-difference\" }\n"
           "effort_limit = 5.5\n[friction]\nlaw = \"stribeck\"\nc0 = 4\nc1 = 2\nc2 = 2\nc3 = 6e-3\nc4 = 2\n";
}

std::string spec_text(double k_v)
{
    return joint_text(k_v) + R"([axes]
"control.k_p" = { from = 1000, to = 4000, points = 3, scale = "log" }
"control.k_v" = { from = 20, to = 600, points = 4, scale = "log" }
[nonlinear]
enabled = true
)";
}

}  // namespace

TEST_CASE("a sweep's page says that points come to rest for good", "[held][slow]")
{
    const Folder folder;
    const auto run = stickslip("sweep " + folder.write("spec.toml", spec_text(20)) + " -o " + (folder / "out"));
    INFO(run.output);
    REQUIRE(run.exit_code == 0);
    CHECK(run.output.rfind("Comes to rest for good: sliding at 5 mm/s is unstable", 0) == 0);
    CHECK(run.output.find("9 points at rest for good") != std::string::npos);
    const auto page = read(folder / "out/report.html");
    for (const char* words :
         {"Comes to rest for good", "The design comes to rest for good.", "9 points come to rest for good",
          "a start from near rest leaves the joint at rest for good (bistable)",
          "bistable: a larger disturbance ends at rest for good"})
        CHECK(page.find(words) != std::string::npos);
    for (const char* words : {"The design sticks and slips", "a larger disturbance ends in stick-slip",
                              "Sampling, saturation and quantisation of a digital loop."})
        CHECK(page.find(words) == std::string::npos);
}

TEST_CASE("a design that slides or rests is told so on its sweep's page", "[held][slow]")
{
    const Folder folder;
    const auto spec = folder.write("spec.toml", spec_text(600));
    const auto run = stickslip("sweep " + spec + " -o " + (folder / "out"));
    INFO(run.output);
    REQUIRE(run.exit_code == 0);
    CHECK(run.output.find("a large enough disturbance brings it to rest for good") != std::string::npos);
    CHECK(run.output.find("ends in stick-slip") == std::string::npos);
    CHECK(read(folder / "out/report.html").find("a larger one leaves it at rest for good") != std::string::npos);
    const auto again = stickslip("sweep " + spec + " -o " + (folder / "out") + " --no-report --json");
    CHECK(nlohmann::json::parse(again.output).at("held") == 9);
}

TEST_CASE("what changed between a design in stick-slip and one at rest", "[held][slow]")
{
    const Folder folder;
    auto text = spec_text(20);
    REQUIRE(
        stickslip("sweep " + folder.write("rests.toml", text) + " --no-report -o " + (folder / "rests")).exit_code ==
        0);
    text.replace(text.find("5.5"), 3, "6.5");
    REQUIRE(
        stickslip("sweep " + folder.write("slips.toml", text) + " --no-report -o " + (folder / "slips")).exit_code ==
        0);
    const auto run = stickslip("report " + (folder / "slips") + " " + (folder / "rests") + " -o " + (folder / "page"));
    INFO(run.output);
    CHECK(run.output.find("The design was in stick-slip and is at rest for good now.") != std::string::npos);
}
