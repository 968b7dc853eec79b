#include "tests/sweep/files/record_texts.h"

#include <cmath>
#include <random>

using namespace record_texts;
using Catch::Contains;
using Catch::StartsWith;

TEST_CASE("a plain record, its gaps and its columns that nobody reads")
{
    const auto [record, warnings, suspicions, missing, guesses, no_position] = read(
        "\xef\xbb\xbf# a comment\r\n\r\n \"time\" , position,effort_command,postion2\r\n"
        "0,1.5e-3,-2,x\r\n0.5, +2 ,,y\r\n\r\n1.25,nan,3,z\r\n");
    CHECK(record.name == "run.csv");
    CHECK(record.time == std::vector<double>{0, 0.5, 1.25});
    REQUIRE(record.position.size() == 3);
    CHECK(record.position[0] == 1.5e-3);
    CHECK(record.position[1] == 2);
    CHECK(std::isnan(record.position[2]));
    CHECK(std::isnan(record.effort_command[1]));
    CHECK(record.effort_command[2] == 3);
    CHECK(record.velocity.empty());
    CHECK_FALSE(record.at_rest_at_start.has_value());
    REQUIRE(warnings.size() == 3);
    CHECK(warnings[0] == "columns that are not read: postion2");
    CHECK(warnings[1] == "position: 1 of 3 cells are missing");
    CHECK(warnings[2] == "effort_command: 1 of 3 cells are missing");
}

TEST_CASE("gzip, semicolons and tabs, other line ends, no end of the last line")
{
    CHECK(read(gzipped("time,position\n0,1\n1,2")).record.position == std::vector<double>{1, 2});
    CHECK(read("time;position\n0;1\n1;2\n").record.position == std::vector<double>{1, 2});
    CHECK(read("time\tposition\n0\t1\n1\t2\n").record.position == std::vector<double>{1, 2});
    // of an old Mac, plain and packed: a line ends in \r alone
    CHECK(read("time,position\r0,1\r1,2\r").record.position == std::vector<double>{1, 2});
    CHECK(read("# rig 7\r\rtime,position\r0,1\r1,2").record.position == std::vector<double>{1, 2});
    CHECK(read(gzipped("time,position\r0,1\r1,2\r")).record.position == std::vector<double>{1, 2});
    const auto hint = read("time,position,velocty\n0,1,2\n").warnings;
    CHECK(hint.at(0) == "columns that are not read: velocty (did you mean \"velocity\"?)");
}

TEST_CASE("foreign names, units, constants, and what holds for one file")
{
    const Joint joint = joint_of("revolute");
    const auto layout = read_record_layout_text(R"([record]
at_rest_at_start = false
[record.columns]
time = { name = "t_ms", unit = "ms" }
position = { name = "angle_deg", unit = "deg", scale = -1, offset = "0.5 rad" }
velocity = { unit = "rpm" }
normal_load = { name = "stress_MPa", unit = "MPa" }
temperature = { name = "T", unit = "K" }
[record.constants]
supply_voltage = "12 V"
[record.files."run*"]
k_p = 100
friction.coulomb = "250 mN·m"
[record.files."other*"]
control.k_p = 7
[record.files."run.cs?"]
control.k_p = 200
constants.supply_voltage = 24
)",
                                                "record.toml", joint);
    const auto [record, warnings, suspicions, missing, guesses, no_position] = read_record(
        file("t_ms,angle_deg,velocity,stress_MPa,T\n0,180,60,20,293.15\n2.5,90,30,21,300\n"), joint, layout);
    const double pi = 3.14159265358979323846;
    CHECK(record.time == std::vector<double>{0, 2.5e-3});
    CHECK(record.position[0] == Approx(0.5 - pi).epsilon(1e-15));
    CHECK(record.velocity[0] == Approx(2 * pi).epsilon(1e-15));
    CHECK(record.normal_load == std::vector<double>{20e6, 21e6});
    CHECK(record.temperature[0] == Approx(20).epsilon(1e-14));
    CHECK(record.supply_voltage == std::vector<double>{24, 24});
    CHECK(record.overrides ==
          std::vector<std::pair<std::string, double>>{{"control.k_p", 200}, {"friction.coulomb", 0.25}});
    CHECK(record.at_rest_at_start == false);
    CHECK(warnings == std::vector<std::string>{});
}

TEST_CASE("a unit may stand in the header behind the name, as in tables of outcomes")
{
    const auto r = read(
                       "time [ms],position [deg],velocity [rad/s],effort_measured [kN·m],temperature\n"
                       "0,90,1,2,20\n10,-180,3,4,21\n",
                       "", "revolute")
                       .record;
    CHECK(r.time == std::vector<double>{0, 0.01});
    CHECK(r.position == std::vector<double>{90 * (M_PI / 180), -180 * (M_PI / 180)});
    CHECK(r.velocity == std::vector<double>{1, 3});
    CHECK(r.effort_measured == std::vector<double>{2000, 4000});
    CHECK(read("time (ms),position (deg),position (old)\n0,90,1\n10,-180,2\n", "", "revolute").record.position ==
          r.position);
    CHECK_THAT(only_error("time,position [deg],effort_measured\n0,1,2\n"),
               Contains("run.csv:1:1: column \"position [deg]\"") && Contains("expected") && Contains("m"));
    CHECK_THAT(only_error("time,position [furlong],effort_measured\n0,1,2\n"), Contains("furlong"));
    CHECK_THAT(only_error("time,position,position [mm]\n0,1,2\n"), Contains("position appears twice"));
    // the layout names what the column means, whatever stands behind it
    CHECK(read("time,position [counts]\n0,5\n0.01,6\n",
               "[columns]\nposition = { name = \"position [counts]\", scale = 0.5 }\n")
              .record.position == std::vector<double>{2.5, 3});
}

TEST_CASE("a layout stands in the joint file, a sidecar beside the record wins")
{
    const auto joint_file = file(
        joint_text(joint_of("prismatic")) + "[record]\ncolumns = { position = \"x\", time = \"t\" }\n", "joint.toml");
    const Joint joint = read_joint(joint_file);
    const auto run = file("t,x,y\n0,1,2\n1,2,3\n");
    CHECK(read_record(run, joint, record_layout_for(run, joint_file, joint)).record.position ==
          std::vector<double>{1, 2});
    const auto sidecar = file("columns.position = \"y\"\n", "record.toml");
    CHECK(read_record(run, joint, record_layout_for(run, joint_file, joint)).record.position ==
          std::vector<double>{2, 3});
    std::filesystem::remove(sidecar);
    const auto bare = file(joint_text(joint), "joint.toml");
    CHECK(record_layout_for(run, bare, joint).rules.empty());
}

TEST_CASE("the drive signal is the one that the actuator takes")
{
    const std::string both = "time,position,drive_voltage,duty\n0,1,5,0.5\n1,2,6,0.6\n";
    CHECK(read(both).record.drive == std::vector<double>{5, 6});
    Joint joint = joint_of("revolute");
    apply_settings(joint, {"actuator.kind=dc-motor", "actuator.k_t=1", "actuator.k_e=1", "actuator.resistance=1",
                           "actuator.signal=duty", "actuator.supply_voltage=12"});
    const auto reading = read_record(file(both), joint);
    CHECK(reading.record.drive == std::vector<double>{0.5, 0.6});
    CHECK(reading.warnings.at(0) == "columns that are not read: drive_voltage");
}

TEST_CASE("rows with the motor off are kept and counted")
{
    const auto [record, warnings, suspicions, missing, guesses, no_position] =
        read("time,position,torque_enable\n0,1,1\n1e-3,2,0\n2e-3,3,0\n");
    CHECK(record.rows() == 3);
    CHECK(warnings.empty());
    REQUIRE(suspicions.size() == 1);
    CHECK(suspicions[0] == Note{.code = Note::Code::motor_off, .values = {2, 3}});
    CHECK_FALSE(contradicts(suspicions[0]));
    CHECK(only_error("time,position,torque_enable\n0,1,2\n") == "run.csv:2:5: torque_enable: is 2, expected 0 and 1");
}

TEST_CASE("units that look wrong are suspected, never corrected")
{
    const auto sine = [](double position_scale, double velocity_scale, double time_scale) {
        std::string text = "time,reference_position,position,velocity\n";
        for (int k = 0; k < 1000; ++k) {
            const double t = 1e-3 * k;
            text += std::to_string(t * time_scale) + "," + std::to_string(std::sin(7 * t)) + "," +
                    std::to_string(position_scale * std::sin(7 * t)) + "," +
                    std::to_string(velocity_scale * 7 * std::cos(7 * t)) + "\n";
        }
        return text;
    };
    const double deg = 57.29577951308232;
    using Code = Note::Code;
    CHECK(read(sine(1, 1, 1), "", "revolute").sentences().empty());
    const auto degrees = read(sine(deg, deg, 1), "", "revolute");
    CHECK(degrees.warnings.empty());
    REQUIRE(degrees.suspicions.size() == 1);
    const auto& found = degrees.suspicions[0];
    CHECK(found.code == Code::unit_between_signals);
    CHECK(found.names == std::vector<std::string>{"degrees", "position", "reference_position"});
    CHECK(found.values.at(0) == Approx(deg).epsilon(1e-3));
    CHECK(contradicts(found));
    CHECK_THAT(degrees.sentences().at(0),
               StartsWith("suspected degrees: position moves 57.3 times as far as reference_position"));
    CHECK(degrees.record.position[500] == Approx(deg * std::sin(3.5)).epsilon(1e-5));
    const auto first = [&](const std::string& text, const char* motion = "prismatic") {
        const auto reading = read(text, "", motion);
        REQUIRE(!reading.suspicions.empty());
        CHECK(contradicts(reading.suspicions[0]));
        return reading.suspicions[0];
    };
    CHECK(first(sine(1, deg, 1), "revolute").names == std::vector<std::string>{"degrees", "velocity", "position_rate"});
    CHECK(first(sine(1000, 1000, 1)).names.at(0) == "millimetres");
    CHECK(first(sine(1, 1e-3, 1000)) ==
          Note{.code = Code::unit_of_clock, .names = {"milliseconds"}, .values = {1, 1e-3}});
    CHECK(first("time,position\n0,0\n1e-3,90\n", "revolute") ==
          Note{.code = Code::unit_by_travel, .names = {"degrees", "deg", "rad"}, .values = {90}});
    CHECK_THAT(read("time,position_mm\n0,0\n1e-3,1\n", "columns.position = \"position_mm\"\n").warnings.at(0),
               StartsWith("suspected unit: column \"position_mm\" is read as m, its name says mm"));
    CHECK(read("time,motor position\n0,0\n1e-3,1\n", "columns.position = \"motor position\"\n").warnings.empty());
}

TEST_CASE("random tables come back bit for bit")
{
    const unsigned seed = 977;
    std::mt19937_64 random(seed);
    for (int round = 0; round < 20; ++round) {
        const std::size_t rows = 1 + random() % 3000;
        std::vector<double> position, effort;
        std::string text = "effort_measured,time,position\n";
        for (std::size_t k = 0; k < rows; ++k) {
            const auto value = [&] {
                return std::ldexp(static_cast<double>(static_cast<std::int64_t>(random())),
                                  -static_cast<int>(random() % 100));
            };
            position.push_back(value());
            effort.push_back(value());
            char line[120];
            std::snprintf(line, sizeof line, "%.17g,%zu,%.17g\n", effort.back(), k, position.back());
            text += line;
        }
        INFO("seed " << seed << ", round " << round);
        const auto record = read(round % 2 ? gzipped(text) : text).record;
        REQUIRE(record.position == position);
        REQUIRE(record.effort_measured == effort);
        REQUIRE(record.time.back() == static_cast<double>(rows - 1));
    }
}

// The measured data of three other groups; not part of this repository (analysis on them has its own tests).
TEST_CASE("measured records of others read with a few lines of layout")
{
    const char* folder = std::getenv("STICKSLIP_DATA");
    if (!folder) {
        WARN("skipped: STICKSLIP_DATA names no folder with measured records");
        return;
    }
    const std::filesystem::path data = folder;
    SECTION("a ball-screw drive: own names, nothing to say")
    {
        const auto [record, warnings, suspicions, missing, guesses, no_position] =
            read_record(data / "emps" / "run.csv.gz", joint_of("prismatic"));
        CHECK(record.rows() == 24841);
        CHECK(record.drive[0] == 2.53863);
        CHECK(record.position[1] == 1.43e-5);
        CHECK(warnings.empty());
        CHECK(suspicions.empty());
    }
    SECTION("a servo with a pendulum: gains by file name")
    {
        const Joint joint = joint_of("revolute");
        const auto layout = read_record_layout_text(
            "[record.files.\"kp100-*\"]\nk_p = 100\n[record.files.\"kp400-*\"]\nk_p = 400\n", "record.toml", joint);
        int files = 0;
        for (const auto& entry : std::filesystem::directory_iterator(data / "xl330")) {
            if (entry.path().extension() != ".gz") continue;
            const auto [record, warnings, suspicions, missing, guesses, no_position] =
                read_record(entry.path(), joint, layout);
            INFO(entry.path());
            CHECK(record.rows() > 1000);
            CHECK(record.temperature.size() == record.rows());
            const double k_p = entry.path().filename().string().starts_with("kp100") ? 100 : 400;
            CHECK(record.overrides == std::vector<std::pair<std::string, double>>{{"control.k_p", k_p}});
            const bool drop = entry.path().string().find("lift-and-drop") != std::string::npos;  // let go on purpose
            CHECK(warnings.empty());
            REQUIRE(suspicions.size() == (drop ? 1 : 0));
            if (drop)
                CHECK(suspicions[0].values ==
                      (k_p == 100 ? std::vector<double>{1138, 1510} : std::vector<double>{1133, 1499}));
            ++files;
        }
        CHECK(files == 8);
    }
    SECTION("a rock under load: foreign names and units")
    {
        const Joint joint = joint_of("prismatic");
        const auto layout = read_record_layout_text(R"([record.columns]
reference_position = { name = "load_point_displacement_um", unit = "um" }
effort_measured = "friction_coefficient"
normal_load = { name = "normal_stress_MPa", unit = "MPa" }
)",
                                                    "record.toml", joint);
        const auto [record, warnings, suspicions, missing, guesses, no_position] =
            read_record(data / "basalt" / "velocity-step.csv.gz", joint, layout);
        CHECK(record.rows() == 5849);
        CHECK(record.reference_position[0] == 8503.602e-6);
        CHECK(record.effort_measured[0] == 0.607016);
        CHECK(record.normal_load[0] == Approx(19.969273e6).epsilon(1e-15));
        for (const auto& warning : warnings) UNSCOPED_INFO(warning);
        CHECK(warnings.empty());
        CHECK(suspicions.empty());
    }
}
