// Disks that take no more, streams that are closed, interruptions: the faults that tests/reliability/silence.py found,
// each with its verb. What needs a disk of its own is tried there.
#include "tests/program/run.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using Catch::Matchers::Contains;
using program::Folder;
using program::shell;
using program::stickslip;

namespace {

const std::string ball_screw = "examples/02-ball-screw/joint-with-memory.toml";

/// The words of the program where no file may grow beyond so many blocks of 1 KiB.
std::string limited(int blocks, const std::string& words)
{
    return "( ulimit -f " + std::to_string(blocks) + "; exec '" + STICKSLIP + "' " + words + " )";
}

/// Two blind cases of one joint, with records that take a diagnosis some time.
void sealed_cases(const Folder& folder)
{
    const auto joint = folder.write("joint.toml",
                                    "[joint]\nmotion = \"revolute\"\ninertia = 0.3\n[control]\nk_p = 400\nk_v = 20\n"
                                    "period = 2e-3\nvelocity_estimate = { form = \"backward-difference\" }\n"
                                    "[friction]\nlaw = \"coulomb-viscous\"\ncoulomb = 1.0\nviscous = 0.3\n"
                                    "[sensor]\nencoder_quantum = 1e-6\nposition_noise = 1e-6\n");
    std::string motion = "time,reference_position\n";
    for (int k = 0; k < 1500; ++k)
        motion += std::to_string(2e-3 * k) + "," + std::to_string(0.4 * (1 - std::cos(7e-3 * k))) + "\n";
    const auto reference = folder.write("motion.csv", motion);
    for (const std::string name : {"case-01", "case-02"}) {
        const auto sealed = folder / ("sealed/" + name);
        REQUIRE(stickslip("simulate '" + joint + "' --reference '" + reference + "' --set load.constant=3 -o '" +
                          sealed + "'")
                    .exit_code == 0);
        std::filesystem::copy(joint, sealed + "/joint.toml");
    }
}

}  // namespace

TEST_CASE("a file that may not grow is refused in words, not by a signal, and leaves nothing", "[program][silence]")
{
    const Folder folder;
    const auto reference = folder.write("motion.csv", "time,reference_position\n0,0\n1,0.1\n");
    for (const std::string& verb :
         {"simulate " + ball_screw + " -o '" + (folder / "out") + "'",
          "simulate examples/07-measured-machines/emps.toml --reference '" + reference + "' -o '" +
              (folder / "record") + "'",
          "new spec -o '" + (folder / "spec.toml") + "'",
          "import tests/fuzz/corpus/robot/arm.urdf --joint elbow -o '" + (folder / "elbow.toml") + "'"}) {
        const auto run = shell(limited(0, verb));
        INFO(verb << ": " << run.output);
        CHECK(run.exit_code == 2);
        CHECK_THAT(run.output, Contains("File too large"));
    }
    CHECK(!std::filesystem::exists(folder / "out/trajectory.csv"));
    CHECK(!std::filesystem::exists(folder / "record/record.csv"));
    CHECK(!std::filesystem::exists(folder / "spec.toml"));
}

TEST_CASE("results that do not fit say so, keep the journal, and do not crash the end of the program",
          "[program][silence][slow]")
{
    const Folder folder;
    const auto out = folder / "out", merged = folder / "merged.nc";
    REQUIRE(stickslip("sweep --no-report --keep-journal -o '" + out + "'").exit_code == 0);
    const auto run = shell(limited(40, "merge --keep-journal '" + out + "' -o '" + merged + "'"));
    INFO(run.output);
    CHECK(run.exit_code == 3);
    CHECK_THAT(run.output, Contains("File too large") && Contains("The journals are safe"));
    CHECK(!std::filesystem::exists(merged));
    CHECK(stickslip("merge --keep-journal '" + out + "' -o '" + merged + "'").exit_code == 0);
}

TEST_CASE("a closed standard output is reported, and no file gets what was meant for it", "[program][silence]")
{
    const Folder folder;
    const auto out = folder / "out";
    const auto run = stickslip("simulate " + ball_screw + " -o '" + out + "' >&-");
    INFO(run.output);
    CHECK(run.exit_code == 3);
    CHECK_THAT(run.output, Contains("could not be written to standard output"));
    const auto whole = stickslip("simulate " + ball_screw + " -o '" + (folder / "whole") + "'");
    REQUIRE(whole.exit_code == 0);
    CHECK(program::read(out + "/trajectory.csv") == program::read((folder / "whole") + "/trajectory.csv"));
}

TEST_CASE("blind that is interrupted answers no case with half a diagnosis", "[program][silence][slow]")
{
    const Folder folder;
    sealed_cases(folder);
    const auto answers = folder / "answers.json";
    // both are at work when their folders of the answer are there; setsid: as a terminal does it, every process of the
    // run hears the signal
    const auto run =
        shell("export TMPDIR='" + (folder / "") + "'; setsid '" + STICKSLIP + "' blind '" + (folder / "sealed") +
              "' --jobs 2 --threads 1 --answers '" + answers +
              "' & while [ $(ls -d \"$TMPDIR\"/stickslip-blind-*/case-0?/answer 2>/dev/null | wc -l) != 2 ]; "
              "do sleep 0.01; done; kill -INT -$!; wait $!");
    INFO(run.output);
    CHECK(run.exit_code == 3);
    CHECK_THAT(run.output, Contains("interrupted: 0 of 2 cases"));
    CHECK(nlohmann::json::parse(program::read(answers)).empty());
}

TEST_CASE("blind reads the truth before it works", "[program][silence]")
{
    const Folder folder;
    sealed_cases(folder);
    const auto truth = folder.write("truth.json", "{\"case-01\": {}}");
    const auto run = stickslip("blind '" + (folder / "sealed") + "' --truth '" + truth + "'");
    INFO(run.output);
    CHECK(run.exit_code == 2);
    CHECK_THAT(run.output, Contains("truth.json: ") && Contains("verdict") && !Contains("case-02"));
    CHECK(!std::filesystem::exists(folder / "sealed/answers.json"));
}
