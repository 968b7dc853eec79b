// Every verb that writes a page answers on its first screen: a verdict, three to five numbers, what was not checked,
// and the command that made it.
#include "tests/program/run.h"

#include <catch2/catch.hpp>

using Catch::Matchers::Contains;
using program::Folder;
using program::stickslip;

namespace {

const std::string joint =
    "[joint]\nmotion = \"prismatic\"\nmodel = \"single-mass\"\ninertia = 1.0\n"
    "[control]\nk_p = 6e4\nk_v = 10.0\nV0 = 1e-3\n"
    "[friction]\nlaw = \"rate-and-state\"\nf0 = 60.0\nA = 1.0\nB = 1.5\nL = 1e-5\nV_star = 1e-3\n";
const std::string gain_axis = "[axes]\n\"control.k_p\" = { from = 1e4, to = 1e5, points = 9, scale = \"log\" }\n";

/// Runs the verb with -o and returns its page.
std::string page_of(const Folder& folder, const std::string& arguments)
{
    const auto run = stickslip(arguments + " -o '" + (folder / "out") + "'");
    INFO(run.output);
    REQUIRE(run.exit_code == 0);
    return program::read(folder / "out/report.html");
}

void check_first_screen(const std::string& page)
{
    int cards = 0;
    for (auto at = page.find("<li class=\"card"); at != std::string::npos; at = page.find("<li class=\"card", at + 1))
        ++cards;
    CHECK(cards >= 3);
    CHECK(cards <= 5);
    CHECK_THAT(page, Contains("id=\"not-checked\"") && Contains("<dt>command</dt>"));
    CHECK_THAT(page, !Contains("<h1></h1>"));
}

}  // namespace

TEST_CASE("the page of a motion names its end and its cycle", "[program][pages][slow]")
{
    Folder folder;
    const auto page = page_of(folder, "simulate '" + folder.write("joint.toml", joint) + "' --set control.k_p=2e4");
    check_first_screen(page);
    CHECK_THAT(page, Contains("Oscillation: the motion ends in a limit cycle") && Contains("period of the cycle"));
    CHECK_THAT(page, Contains("class=\"verdict bad\""));
}

TEST_CASE("the page of one joint says how far the boundary is", "[program][pages]")
{
    Folder folder;
    const auto page = page_of(folder, "evaluate '" + folder.write("joint.toml", joint) + "'");
    check_first_screen(page);
    CHECK_THAT(page, Contains("any k<sub>v</sub>") && Contains("Stick-slip appears if L falls by 5.1 %"));
}

TEST_CASE("a verdict on the ideal loop of a joint that has another says so first, and is green only where both slide",
          "[program][pages][slow]")
{
    Folder folder;
    // stable above 53.9 kN/m in the ideal loop, above 65.7 kN/m in the one described
    const auto late = folder.write(
        "late.toml", std::string(joint).replace(joint.find("[friction]"), 0,
                                                "period = 1e-3\ndelay = 1e-3\n"
                                                "velocity_estimate = { form = \"backward-difference\" }\n"));
    const auto page = page_of(folder, "evaluate '" + late + "' --ideal-loop");
    CHECK_THAT(page, Contains("class=\"verdict warning\"") && Contains("ideal loop. Slides smoothly"));
    const auto both = page_of(folder, "evaluate '" + late + "' --ideal-loop --set control.k_p=80e3");
    CHECK_THAT(both, Contains("class=\"verdict good\"") && Contains("ideal loop. Slides smoothly"));
    const auto said = stickslip("margins '" + late + "' --ideal-loop");
    CHECK_THAT(said.output, Contains("--ideal-loop leaves out control.period, control.delay") &&
                                Contains("sliding at this velocity is unstable"));
    CHECK_THAT(stickslip("margins '" + late + "'").output, !Contains("--ideal-loop"));
}

TEST_CASE("the page of boundaries says where they lie from the design", "[program][pages]")
{
    Folder folder;
    const auto spec = joint + "[axes]\n\"control.k_p\" = { from = 1e4, to = 1e5, points = 9, scale = \"log\" }\n" +
                      "\"control.k_v\" = { from = 1.0, to = 1e3, points = 9, scale = \"log\" }\n"
                      "\"control.V0\" = { from = 1e-4, to = 1e-2, points = 9, scale = \"log\" }\n";
    const auto file = "'" + folder.write("spec.toml", spec) + "'";
    const auto page = page_of(folder, "boundary " + file +
                                          " --kind linear velocity-only --over control.k_p control.V0 --set "
                                          "control.k_v=0 --set control.V0=1e-3");
    CHECK_THAT(page, Contains("id=\"not-checked\""));
    // (35) at V_0 = 1 mm/s, k_v = 0: 55 kN/m, −8.33 % of 60 kN/m
    CHECK_THAT(page, Contains("linear boundary with memory at 55 kN/m"));
    CHECK_THAT(page, Contains("k<sub>p</sub> −8.33 %"));
}

TEST_CASE("the page of margins draws the way to each boundary", "[program][pages]")
{
    Folder folder;
    const auto page = page_of(folder, "margins '" + folder.write("joint.toml", joint) + "' --uncertain friction.L=20%");
    check_first_screen(page);
    CHECK_THAT(page, Contains("id=\"growth-by-parameter\"") && Contains("class=\"verdict bad\""));
    const auto lines = program::read(folder / "out/charts/growth-by-parameter.csv");
    for (const char* name : {"\nm,", "\nL,", "\nA,", "\nboundary,"}) CHECK_THAT(lines, Contains(name));
}

TEST_CASE("the page of a check names boundaries in words", "[program][pages]")
{
    Folder folder;
    const auto spec = "'" + folder.write("spec.toml", joint + gain_axis) + "' '" + (folder / "baseline.json") + "'";
    REQUIRE(stickslip("check " + spec + " --update").exit_code == 0);
    const auto page = page_of(folder, "check " + spec);
    check_first_screen(page);
    CHECK_THAT(page, Contains("boundary with memory along k<sub>p</sub>") && Contains("53.851485 kN/m"));
}

TEST_CASE("a simulated sweep along one axis draws its limit cycles", "[program][pages]")
{
    Folder folder;
    const auto text = joint + "[nonlinear]\nenabled = true\n" + gain_axis;
    const auto page = page_of(folder, "sweep '" + folder.write("spec.toml", text) + "'");
    check_first_screen(page);
    CHECK_THAT(page, Contains("id=\"amplitude-k-p-k-p\"") && Contains("id=\"period-k-p-k-p\""));
}

TEST_CASE("V_min is one thing with one name on every page", "[program][pages]")
{
    Folder folder;
    const auto file = folder.write("joint.toml", joint + gain_axis);
    const auto one = page_of(folder, "evaluate '" + file + "'");
    CHECK_THAT(one, Contains("V<sub>min</sub>: every faster velocity slides smoothly") &&
                        Contains("slowest smooth velocity") && !Contains("least stable velocity"));
    const auto boundary =
        page_of(folder, "boundary '" + file + "' --kind v-min --over control.k_p control.V0=1e-5..1e-1");
    CHECK_THAT(boundary, Contains("least velocity V<sub>min</sub>") && !Contains("least stable velocity"));
}
