// What a nonlinear sweep says against its own linear chart.
#include <catch2/catch.hpp>

#include "tests/example_joint.h"
#include "tests/program/run.h"

using namespace program;

TEST_CASE("a report says where the linear chart is wrong, and by how much", "[slow]")
{
    // a continuation program puts k_cr at 19449 N/m and the fold at 24849 N/m for k_v = 47.5 N·s/m, 1.278 times as much
    const Folder folder;
    const auto spec =
        folder.write("spec.toml", "title = \"strip\"\n" + example_joint_text(1, 2.2e4, 47.5, 1e-2) + R"([axes]
"control.k_p" = { from = 1e4, to = 4e4, points = 15, scale = "log" }
"control.k_v" = { from = 45.0, to = 47.5, points = 5 }
[nonlinear]
enabled = true
)");
    const auto run = stickslip("sweep " + spec + " -o " + (folder / "out"));
    INFO(run.output);
    REQUIRE(run.exit_code == 0);
    const auto page = read(folder / "out/report.html");
    const auto found = page.find("Errors of the linear chart: on ");
    REQUIRE(found != std::string::npos);
    const auto text = page.substr(found, 1500);
    CAPTURE(text);
    for (const char* words : {"1.28 times the critical gain", "47.5 N·s/m", "19.4 kN/m", "24.8 kN/m"})
        CHECK(text.find(words) != std::string::npos);
    CHECK(page.find("fold of limit cycles") != std::string::npos);
}

TEST_CASE("a report without bistable points finds no fault with its linear chart", "[slow]")
{
    const Folder folder;
    const auto spec = folder.write("spec.toml", example_joint_text(1, 6e4, 0, 1e-3) + R"([axes]
"control.k_p" = { from = 1e4, to = 1e5, points = 15, scale = "log" }
"control.V0" = { from = 1e-3, to = 1e-2, points = 5, scale = "log" }
[nonlinear]
enabled = true
)");
    REQUIRE(stickslip("sweep " + spec + " -o " + (folder / "out")).exit_code == 0);
    CHECK(read(folder / "out/report.html").find("Errors of the linear chart") == std::string::npos);
}
