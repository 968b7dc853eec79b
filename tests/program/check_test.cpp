// stickslip check in a pipeline: the same answer wherever it runs.
#include "tests/program/run.h"

#include <catch2/catch.hpp>

#include <regex>

using Catch::Matchers::Contains;
using program::Folder;
using program::shell;

namespace {

/// The bistable strip along its position gain, outcomes watched beside its folds.
std::string strip()
{
    auto text = program::read(std::string(SOURCE_ROOT) + "/examples/03-bistable-strip/spec.toml");
    text = std::regex_replace(text, std::regex("points = 41"), "points = 9");
    text = std::regex_replace(text, std::regex("\"control.k_v\" = \\{.*\\}\n"), "");
    text = text.substr(0, text.find("[report]"));
    return std::regex_replace(text, std::regex("enabled = true"),
                              "enabled = true\ndisturbance = { kind = \"start\", size = 1e-4 }");
}

}  // namespace

TEST_CASE("a check passes on every kind of CPU and on one thread as on all", "[program][check][slow]")
{
    Folder folder;
    const auto files = "'" + folder.write("spec.toml", strip()) + "' '" + (folder / "baseline.json") + "'";
    const std::string check = " '" + std::string(STICKSLIP) + "' check " + files;
    const auto stored = shell(check + " --update");
    INFO(stored.output);
    REQUIRE(stored.exit_code == 0);
    for (const char* machine :
         {"STICKSLIP_INSTRUCTIONS=baseline", "GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2,-FMA,-AVX512F"}) {
        const auto run = shell(machine + check + " --threads 1");
        INFO(machine << "\n" << run.output);
        CHECK(run.exit_code == 0);
        for (const char* kind : {"state_variable along", "fold along", "outcome along"})
            CHECK_THAT(run.output, Contains(kind));
    }
}

TEST_CASE("an instruction set that there is not is told from those that there are", "[program][check]")
{
    const auto run = shell("STICKSLIP_INSTRUCTIONS=sse9 '" + std::string(STICKSLIP) + "' list laws");
    CHECK(run.exit_code == 2);
    CHECK_THAT(run.output, Contains("STICKSLIP_INSTRUCTIONS: got \"sse9\", this processor has baseline"));
}

TEST_CASE("a check fails where the design leaves the stable gains, though no boundary moves", "[program][check]")
{
    // stable above k_cr = 100 kN/m, below it stick-slip
    Folder folder;
    const auto spec = [&](const char* k_p) {
        return folder.write("spec.toml",
                            std::string("[joint]\ninertia = 10\n[control]\nk_p = ") + k_p +
                                "\nk_v = 0\nV0 = 1e-3\n[friction]\nlaw = \"rate-and-state\"\nf0 = 60\nA = "
                                "1.0\nB = 1.5\nL = 1e-5\nV_star = 1e-3\n[axes]\n\"control.k_p\" = { from = "
                                "1e4, to = 1e6, points = 5, scale = \"log\" }\n");
    };
    const std::string baseline = "'" + (folder / "baseline.json") + "'", junit = folder / "junit.xml";
    const auto check = [&](const char* k_p, const std::string& more) {
        return program::stickslip("check '" + spec(k_p) + "' " + baseline + more);
    };
    REQUIRE(check("2e5", " --update").exit_code == 0);
    CHECK(check("3e5", "").exit_code == 0);
    const auto lost = check("5e4", " --junit '" + junit + "' -o '" + (folder / "out") + "'");
    INFO(lost.output);
    CHECK(lost.exit_code == 1);
    CHECK_THAT(lost.output, Contains("the design itself: was stable, is not") && Contains("0 out of tolerance"));
    CHECK_THAT(program::read(junit), Contains("failures=\"1\""));
    CHECK_THAT(program::read(folder / "out/report.html"), Contains("The design itself was stable and is not."));
}
