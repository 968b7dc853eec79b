// From a joint to a record of its loop, and from the record back to the joint.
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/example_joint.h"
#include "tests/program/run.h"

using namespace program;

namespace {

const std::string machine =
    "[joint]\nmotion = \"revolute\"\nmodel = \"single-mass\"\ninertia = 0.05\n"
    "[control]\nk_p = 30\nk_v = 1.5\nperiod = 0.002\ndelay = 0.004\n"
    "[control.velocity_estimate]\nform = \"backward-difference\"\ntau = 0.004\n"
    "[friction]\nlaw = \"coulomb-viscous\"\ncoulomb = 0.4\nviscous = 0.15\n"
    "[sensor]\nencoder_quantum = 0.0002\nposition_noise = 0.0001\neffort_noise = 0.01\n";

/// Swings with reversals, rests and fast parts, every 2 ms.
std::string reference()
{
    std::ostringstream rows;
    rows.precision(12);
    rows << "time,reference_position,reference_velocity\n";
    for (int k = 0; k <= 6000; ++k) {
        const double t = 0.002 * k;
        const double a = 2 * M_PI * 0.25, b = 2 * M_PI * 0.7, c = 2 * M_PI * 1.6;
        rows << t << ',' << 0.8 * (1 - std::cos(a * t)) + 0.3 * std::sin(b * t) + 0.08 * std::sin(c * t) << ','
             << 0.8 * a * std::sin(a * t) + 0.3 * b * std::cos(b * t) + 0.08 * c * std::cos(c * t) << '\n';
    }
    return rows.str();
}

/// What diagnose makes of the record that this joint leaves, taken for `machine`.
nlohmann::json diagnosis_of(const Folder& folder, const std::string& settings)
{
    const auto joint = folder.write("joint.toml", machine);
    const auto motion = folder.write("motion.csv", reference());
    const auto out = folder / "record";
    const auto played = stickslip("simulate " + joint + settings + " --reference " + motion + " --seed 5 -o " + out);
    INFO(played.output);
    REQUIRE(played.exit_code == 0);
    const auto found = stickslip("diagnose " + joint + " " + out + "/record.csv --no-report -o " + (folder / "found"));
    INFO(found.output);
    REQUIRE(found.exit_code == 0);
    return nlohmann::json::parse(read(folder / "found/diagnosis.json"));
}

}  // namespace

TEST_CASE("a record that the joint itself played has no gap")
{
    const Folder folder;
    CHECK(diagnosis_of(folder, "")["verdict"] == "no-gap");
}

TEST_CASE("a record of an edited joint names the edit")
{
    const Folder folder;
    const auto found = diagnosis_of(folder, " --set control.delay=0.012");
    CHECK(found["verdict"] == "gap");
    REQUIRE(!found["effects"].empty());
    CHECK(found["effects"][0]["names"][0] == "delay");
}

TEST_CASE("a reference that cannot be followed says why")
{
    const Folder folder;
    const auto motion = folder.write("motion.csv", "time,reference_position\n0,0\n1,0\n2,0.1\n");
    const auto sliding = folder.write("joint.toml", example_joint_text(1, 6e4, 10, 1e-3));
    const auto run = stickslip("simulate " + sliding + " --reference " + motion + " -o " + (folder / "out"));
    CHECK(run.exit_code == 2);
    CHECK_THAT(run.output, Catch::Contains("undefined at rest"));
    const auto broken = folder.write("broken.csv", "time,reference_position\n0,0\n1,x\n");
    const auto second = stickslip("simulate " + folder.write("machine.toml", machine) + " --reference " + broken);
    CHECK(second.exit_code == 2);
    CHECK_THAT(second.output, Catch::Contains("broken.csv:3"));
}
