// Every spec under examples/ runs and says what it said before. `STICKSLIP_UPDATE=1 tests_program "[examples]"` stores
// what they say now.
#include "tests/program/said.h"

#include <catch2/catch.hpp>

#include <set>

using program::Folder;
using program::stickslip;

namespace {

const std::string root = SOURCE_ROOT;

std::set<std::string> example_specs()
{
    std::set<std::string> specs;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root + "/examples")) {
        const auto name = entry.path().filename().string();
        if (name.starts_with("spec") && name.ends_with(".toml"))
            specs.insert(std::filesystem::relative(entry.path(), root).string());
    }
    return specs;
}

}  // namespace

TEST_CASE("every example runs and says what it said", "[program][examples][slow]")
{
    const auto specs = example_specs();
    REQUIRE(specs.size() >= 4);
    for (const auto& spec : specs) {
        Folder folder;
        const auto run = stickslip("sweep " + spec + " -o '" + (folder / "out") + "'");
        INFO(spec << "\n" << run.output);
        CHECK(run.exit_code == 0);
        const auto path = std::filesystem::path(spec);
        program::check_said(path.parent_path().filename().string() + "-" + path.stem().string(), run.output);
    }
}

TEST_CASE("the pipeline step passes, and fails where a boundary has moved", "[program][examples]")
{
    Folder folder;
    const auto step = [&](const std::string& name) {
        return program::shell("STICKSLIP='" + std::string(STICKSLIP) + "' examples/ci/run.sh '" + (folder / name) +
                              "'");
    };
    const auto run = step("stability");
    INFO(run.output);
    CHECK(run.exit_code == 0);
    program::check_said("ci-run", run.output);
    CHECK_THAT(program::read(folder / "stability/stability.xml"), Catch::Matchers::Contains("failures=\"0\""));
    CHECK(std::filesystem::exists(folder / "stability/report.html"));
}

TEST_CASE("shards by GNU parallel give the summary of one sweep", "[program][examples][slow]")
{
    if (program::shell("command -v parallel >/dev/null").exit_code != 0) {
        WARN("skipped: GNU parallel is not installed here");
        return;
    }
    Folder folder;
    // shards end in any order, what they print need not
    const auto run = program::shell("cd '" + (folder / "") + "' && PARALLEL=--keep-order SPEC='" + root +
                                    "/examples/02-ball-screw/spec.toml' OUT=out SHARDS=3 STICKSLIP='" + STICKSLIP +
                                    "' '" + root + "/examples/05-cluster/parallel.sh'");
    INFO(run.output);
    CHECK(run.exit_code == 0);
    CHECK(std::filesystem::exists(folder / "out/results.nc"));
    program::check_said("05-cluster-parallel", run.output);
}
