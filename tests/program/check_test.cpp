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

TEST_CASE("a check passes on every kind of CPU and on one thread as on all", "[program][check]")
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
