// diagnose --guarantee as a user runs it: what is missing is said before the work, and the set stands in the answer.
#include "tests/program/run.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

using program::stickslip;
using Json = nlohmann::json;

namespace {

constexpr const char* joint = R"(
[joint]
motion = "revolute"
inertia = 0.05
[control]
k_p = 20.0
k_v = 0.5
period = 2e-3
velocity_estimate = { form = "backward-difference" }
[friction]
law = "coulomb-viscous"
coulomb = 0.3
viscous = 0.05
[sensor]
position_noise = 1e-5
)";

std::string back_and_forth()
{
    std::string text = "time,reference_position\n";
    for (int i = 0; i < 1500; ++i) {
        const double t = i * 2e-3;
        text += std::to_string(t) + "," + std::to_string(t < 2 ? 0.5 * (1 - std::cos(3.14159265 * t)) : 0.0) + "\n";
    }
    return text;
}

bool says(const program::Run& run, const std::string& words)
{
    return run.output.find(words) != std::string::npos;
}

}  // namespace

TEST_CASE("a promise is given from enough cases of this joint, and refused with the reason from anything else",
          "[guarantee][slow]")
{
    const program::Folder folder;
    const auto file = folder.write("joint.toml", joint), motion = folder.write("motion.csv", back_and_forth());
    const auto calibration = folder / "calibration.json", out = folder / "out";
    REQUIRE(stickslip("simulate " + file + " --reference " + motion + " --seed 3 --set load.constant=0.2 -o " + out)
                .exit_code == 0);
    const auto record = out + "/record.csv";
    const auto question = "diagnose " + file + " " + record + " --no-report -o " + out + " --guarantee 0.95";

    const auto without = stickslip(question);
    CHECK(without.exit_code == 2);
    CHECK(says(without, "59 answered cases"));

    const auto make = "calibrate " + file + " " + record + " --cases 4 --seed 5 -o " + calibration;
    const auto made = stickslip(make + " --shard 1/2");
    CAPTURE(made.output);
    REQUIRE(made.exit_code == 0);
    CHECK(says(made, "min of computing"));
    CHECK(says(made, "59 are needed"));
    // the same command goes on where it was, and case n does not depend on the shard that answers it
    const auto begun = Json::parse(program::read(calibration));
    const auto again = stickslip(make);
    CHECK(again.exit_code == 0);
    const auto few = Json::parse(program::read(calibration));
    REQUIRE(few["cases"].size() >= begun["cases"].size());
    for (const auto& one : begun["cases"]) CHECK(std::count(few["cases"].begin(), few["cases"].end(), one) == 1);
    REQUIRE(!few["cases"].empty());

    const auto asked = [&](const Json& cases) {
        return stickslip(question + " --calibration " + folder.write("asked.json", cases.dump()));
    };
    const auto too_few = asked(few);
    CHECK(too_few.exit_code == 2);
    CHECK(says(too_few, "cases promise nothing at 95 %"));

    // 59 answers as they would come of a cluster, of two causes: each got 0.25 at least
    Json enough = few;
    enough["cases"] = Json::array();
    for (int i = 0; i < 59; ++i) {
        Json one = few["cases"][0];
        one["name"] = "case-" + std::to_string(i);
        const std::string cause = i % 2 ? "constant-load" : "gravity";
        one["truth"] = Json::object(
            {{"verdict", "gap"}, {"effects", Json::array({cause})}, {"equivalent", Json::array()}, {"dirty", true}});
        one["answer"] = Json::object({{"verdict", "gap"},
                                      {"effects", Json::array({Json::array({cause}), Json::array({"inertia"})})},
                                      {"probabilities", Json::array({i == 5 ? 0.25 : 0.9, 0.05})}});
        enough["cases"].push_back(one);
    }
    const auto given = asked(enough);
    CAPTURE(given.output);
    REQUIRE(given.exit_code == 0);
    const auto answer = Json::parse(program::read(out + "/diagnosis.json"));
    REQUIRE(answer.contains("set"));
    const auto& set = answer["set"];
    CAPTURE(set.dump());
    CHECK(set["coverage"] == 0.95);
    CHECK(set["cases"] == 59);
    CHECK(set["holds"] == "population");
    CHECK(!set["population"].get<std::string>().empty());
    // a load of 0.2 N m: by its name, and by that of the very same motion
    CHECK(std::count(set["names"].begin(), set["names"].end(), Json::array({"constant-load"})) == 1);
    CHECK(set["names"].size() <= 3);
    CHECK(std::count(set["uncalibrated"].begin(), set["uncalibrated"].end(), "backlash") == 1);
    CHECK(says(given, "right for at least 95 of 100 such joints"));

    Json other = enough;
    other["method"] = "0";
    CHECK(says(asked(other), "other sources"));
    other = enough;
    for (auto& one : other["cases"]) one["joint"]["columns"] = {"position"};
    const auto columns = asked(other);
    CHECK(columns.exit_code == 2);
    CHECK(says(columns, "no records with these columns"));
    other = enough;
    for (auto& one : other["cases"]) one["joint"]["duration"] = 300;
    CHECK(says(asked(other), "duration of all records"));
    CHECK(stickslip("diagnose " + file + " " + record + " --calibration " + calibration).exit_code == 2);
}
