// Records and tables that do not do, as a user would hand them in: a clear answer, never a cause.
#include "tests/program/run.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <functional>
#include <numbers>
#include <sstream>
#include <tuple>

using Catch::Matchers::Contains;
using program::Folder;
using program::stickslip;

namespace {

const std::string joint =
    "[joint]\nmotion = \"revolute\"\ninertia = 0.01\n[control]\nk_p = 4.0\nk_v = 0.0\nperiod = 1e-3\n"
    "[friction]\nlaw = \"coulomb-viscous\"\ncoulomb = 0.1\nviscous = 0.01\n[sensor]\nposition_noise = 1e-5\n";

struct Row {
    double time, reference, position, velocity, command;
};

/// A lagging sine with the command of k_p = 4, each row changed by `change`.
std::string record(
    const std::function<void(Row&)>& change = [](Row&) {}, int rows = 400)
{
    std::string text = "time,reference_position,position,velocity,effort_command\n";
    for (int k = 0; k < rows; ++k) {
        const double t = 1e-3 * k, w = 20;
        Row r{t, 0.3 * std::sin(w * t), 0.3 * std::sin(w * t - 0.1), 0.3 * w * std::cos(w * t - 0.1), 0};
        r.command = 4 * (r.reference - r.position);
        change(r);
        std::array<char, 200> line;
        std::snprintf(line.data(), line.size(), "%.9g,%.9g,%.9g,%.9g,%.9g\n", r.time, r.reference, r.position,
                      r.velocity, r.command);
        text += line.data();
    }
    return text;
}

constexpr double degrees = 57.29577951308232;

/// The same with one more column, made of this many times a column that is there.
std::string with_column(const std::string& name, std::size_t like, double factor)
{
    std::istringstream rows(record());
    std::string text, line;
    std::getline(rows, line);
    text = line + "," + name + "\n";
    while (std::getline(rows, line)) {
        std::istringstream cells(line);
        std::string cell;
        for (std::size_t i = 0; i <= like; ++i) std::getline(cells, cell, ',');
        text += line + "," + std::to_string(factor * std::stod(cell)) + "\n";
    }
    return text;
}

std::string measured(double factor)
{
    return with_column("effort_measured", 4, factor);
}

/// The logged velocity lags the reference by 0.1 rad: near enough.
std::string reference_rate(double factor)
{
    return with_column("reference_velocity", 3, factor);
}

program::Run diagnose(const Folder& folder, const std::string& text)
{
    const auto spec = folder.write("joint.toml", joint), file = folder.write("run.csv", text);
    return stickslip("diagnose '" + spec + "' '" + file + "' --no-report -o '" + (folder / "out") + "'");
}

}  // namespace

TEST_CASE("a record at rest has no direction that could be the wrong one", "[program][diagnose]")
{
    Folder folder;
    const auto run = diagnose(folder, record([](Row& r) {
                                  r.reference = 0.1, r.position = 0.09999, r.velocity = 0;
                                  r.command = 4 * (r.reference - r.position);
                              }));
    INFO(run.output);
    CHECK_THAT(run.output, !Contains("suspected"));
}

TEST_CASE("a record in a foreign unit is suspected and not explained by a cause", "[program][diagnose][slow]")
{
    const std::pair<std::string, std::string> cases[] = {
        {record([](Row& r) { r.position *= degrees; }), "suspected degrees: position moves"},
        {record([](Row& r) { r.position *= degrees, r.reference *= degrees; }),
         "suspected degrees: the rate of position"},
        {record([](Row& r) { r.position *= degrees, r.reference *= degrees, r.velocity *= degrees; }),
         "suspected degrees: with the gains of the joint"},
        {record([](Row& r) { r.time *= 1e3; }), "run.csv: suspected milliseconds"},
        {record([](Row& r) { r.time *= 1e9; }), "suspected nanoseconds"},
        {record([](Row& r) { r.time *= 2e4; }), "suspected another unit of time"},
        {record([](Row& r) { r.velocity *= -1; }), "suspected sign: velocity runs against the rate of position"},
        {record([](Row& r) { r.velocity *= 30 / std::numbers::pi; }), "suspected unit: velocity is 9.5 times"},
        {record([](Row& r) { r.velocity *= 0.1; }), "suspected unit: velocity is 10 times less than"},
        {measured(-1), "suspected sign: effort_measured runs against effort_command"},
        {measured(1000), "suspected unit: effort_measured varies by 1000 times"},
        {measured(0.125), "suspected unit: effort_measured varies by"},
        {reference_rate(degrees), "suspected unit: reference_velocity is 5"},
        {reference_rate(-1), "suspected sign: reference_velocity runs against"},
        {record([](Row& r) { r.command *= -1; }), "suspected sign: with the gains of the joint"},
        {record([](Row& r) { r.position *= -1, r.velocity *= -1; }), "suspected sign: position runs against"},
        {record([](Row& r) { r.command *= 7; }), "suspected record of another joint"},
        {record([](Row& r) { r.command = 0; }), "effort_command stays at 0 while position moves"},
        {record([](Row& r) { r.velocity = 2; }), "velocity stays at 2 while position moves"},
    };
    for (const auto& [text, says] : cases) {
        Folder folder;
        const auto run = diagnose(folder, text);
        INFO(run.output);
        CHECK(run.exit_code == 2);
        CHECK_THAT(run.output, Contains(says));
        CHECK_THAT(program::read(folder / "out/diagnosis.json"), Contains("\"verdict\": \"insufficient-data\""));
    }
}

TEST_CASE("what no record of this joint can hold is a contradiction and no cause", "[program][diagnose]")
{
    const std::string limited =
        joint.substr(0, joint.find("period")) + "effort_limit = 0.05\n" + joint.substr(joint.find("period"));
    const auto wrapped = [] {  // a command of −0.12 … 0.12 in counts of 1/1000, read as 16 bits without a sign
        return record([](Row& r) {
            const double counts = std::round(1e3 * r.command);
            r.command = counts < 0 ? 65536 + counts : counts;
        });
    };
    const auto timeless = [] {
        std::string text = joint;
        return text.erase(text.find("period = 1e-3\n"), 14);
    };
    const std::tuple<std::string, std::string, std::string> cases[] = {
        {limited, record(), "the logged command reaches 0."},
        {joint, wrapped(), "two's complement of 16 bits"},
        {timeless(), record([](Row& r) { r.time *= 1e3; }), "suspected milliseconds: rows are 1 s apart"},
    };
    for (const auto& [spec_text, text, says] : cases) {
        Folder folder;
        const auto spec = folder.write("joint.toml", spec_text), file = folder.write("run.csv", text);
        const auto run = stickslip("diagnose '" + spec + "' '" + file + "' --no-report -o '" + (folder / "out") + "'");
        INFO(run.output);
        CHECK(run.exit_code == 2);
        CHECK_THAT(run.output, Contains(says));
    }
}

TEST_CASE("a row that a logger held is left away and said to be", "[program][diagnose][slow]")
{
    std::string text = record();
    const auto line = text.find("\n0.1,") + 1;
    text.insert(line, text.substr(line, text.find('\n', line) - line + 1));
    Folder folder;
    const auto run = diagnose(folder, text);
    INFO(run.output);
    CHECK(run.exit_code != 2);
    CHECK_THAT(program::read(folder / "out/diagnosis.json"), Contains("1 rows repeat the row before"));
}

TEST_CASE("a record without a position is refused with its columns and its joints", "[program][diagnose]")
{
    const auto with_header = [](const std::string& header) {
        const std::string text = record();
        return header + text.substr(text.find('\n'));
    };
    const std::pair<std::string, std::string> cases[] = {
        {"time,reference_position,posiiton,velocity,effort_command",
         "run.csv:1:1: has no column position; its columns are time, reference_position, posiiton (did you mean "
         "\"position\"?), velocity, effort_command"},
        {"time,elbow_reference_position,elbow_position,wrist_velocity,effort_command",
         "they name the joints elbow, wrist: diagnose --joint elbow reads its columns"},
    };
    for (const auto& [header, says] : cases) {
        Folder folder;
        const auto run = diagnose(folder, with_header(header));
        INFO(run.output);
        CHECK(run.exit_code == 2);
        CHECK_THAT(run.output, Contains(says));
    }
}

TEST_CASE("gains that held in one record are no sign of another joint", "[program][diagnose][slow]")
{
    Folder folder;
    const std::string fed_harder = record([](Row& r) { r.command *= 7; });
    const auto spec =
                   folder.write("joint.toml", std::string(joint) + "\n[record.files.\"run.csv\"]\ncontrol.k_p = 28\n"),
               file = folder.write("run.csv", fed_harder);
    const auto run = stickslip("diagnose '" + spec + "' '" + file + "' --no-report -o '" + (folder / "out") + "'");
    INFO(run.output);
    CHECK(run.exit_code == 0);
    CHECK_THAT(run.output, !Contains("suspected"));
}

TEST_CASE("long travel is suspected where nothing confirms the unit, and believed where it is named",
          "[program][diagnose][slow]")
{
    // 100 rad and no reference to compare the command with: a wheel, or degrees
    std::string text = "time,position,effort_command\n";
    for (int k = 0; k < 400; ++k)
        text += std::to_string(1e-3 * k) + "," + std::to_string(50 * std::sin(0.02 * k)) + "," +
                std::to_string(std::cos(0.02 * k)) + "\n";
    Folder folder;
    const auto run = diagnose(folder, text);
    INFO(run.output);
    CHECK(run.exit_code == 2);
    CHECK_THAT(run.output, Contains("suspected degrees: position travels 100 rad"));
    CHECK_THAT(program::read(folder / "out/diagnosis.json"), Contains("\"verdict\": \"insufficient-data\""));
    folder.write("record.toml", "[columns]\nposition = { unit = \"rad\" }\n");
    const auto named = diagnose(folder, text);
    INFO(named.output);
    CHECK(named.exit_code != 2);
    CHECK_THAT(named.output, !Contains("suspected degrees"));
}

TEST_CASE("an effort that varies while the command is constant is in no other unit", "[program][diagnose][slow]")
{
    // what a controller makes of 0.9 in single precision, and a drive's noise about it
    std::string text = "time,position,effort_command,effort_measured\n";
    for (int k = 0; k < 400; ++k)
        text += std::to_string(1e-3 * k) + "," + std::to_string(1e-5 * k * k) + "," + (k % 2 ? "0.9" : "0.90000001") +
                "," + std::to_string(0.9 + 0.05 * std::sin(0.3 * k)) + "\n";
    Folder folder;
    const auto run = diagnose(folder, text);
    INFO(run.output);
    CHECK(run.exit_code != 2);
    CHECK_THAT(run.output, !Contains("suspected"));
}

TEST_CASE("an encoder on the motor turns as many times farther as the reduction says", "[program][diagnose][slow]")
{
    const std::string geared =
        "[joint]\nmotion = \"revolute\"\nmodel = \"two-mass\"\nmotor_inertia = 1e-5\nlink_inertia = 0.05\n"
        "transmission = { stiffness = 500, damping = 0.1, ratio = 100 }\n[control]\nk_p = 4e-4\nperiod = 1e-3\n"
        "[friction.motor]\nlaw = \"coulomb-viscous\"\ncoulomb = 1e-3\nviscous = 1e-6\n[friction.link]\n"
        "law = \"coulomb-viscous\"\ncoulomb = 0.01\nviscous = 0.01\n[sensor]\nposition_noise = 1e-3\n";
    std::string text = "time,position,effort_command\n";
    for (int k = 0; k < 400; ++k)
        text += std::to_string(1e-3 * k) + "," + std::to_string(50 * std::sin(0.02 * k)) + "," +
                std::to_string(0.01 * std::cos(0.02 * k)) + "\n";
    Folder folder;
    const auto spec = folder.write("joint.toml", geared), file = folder.write("run.csv", text);
    const auto run = stickslip("diagnose '" + spec + "' '" + file + "' --no-report -o '" + (folder / "out") + "'");
    INFO(run.output);
    CHECK(run.exit_code != 2);
    CHECK_THAT(run.output, !Contains("suspected"));
}

TEST_CASE("line ends, separators, marks and remarks do not change the answer", "[program][diagnose][slow]")
{
    const auto replaced = [](std::string text, const std::string& a, const std::string& b) {
        for (std::size_t i = 0; (i = text.find(a, i)) != std::string::npos; i += b.size()) text.replace(i, a.size(), b);
        return text;
    };
    const std::string plain = record();
    std::string answer;
    std::string remark = plain;
    remark.insert(remark.find("\n0.1,") + 1, "# the lamp went on here\n\n");
    for (const auto& text : {plain, replaced(plain, "\n", "\r\n"), replaced(plain, "\n", "\r"),
                             replaced(plain, ",", ";"), replaced(plain, ",", "\t"), "# rig 7\n\n" + plain,
                             "\xef\xbb\xbf" + plain, remark, replaced(plain, ",", " , ")}) {
        Folder folder;
        const auto run = diagnose(folder, text);
        INFO(text.substr(0, 80) << run.output);
        CHECK(run.exit_code == 0);
        const auto json = program::read(folder / "out/diagnosis.json");
        if (answer.empty()) answer = json;
        CHECK(json == answer);
    }
}

TEST_CASE("the answer does not depend on the number of threads", "[program][diagnose][slow]")
{
    Folder folder;
    const auto spec = folder.write("joint.toml", joint), file = folder.write("run.csv", record());
    std::string answer;
    for (const char* threads : {"1", "2", "7"}) {
        const auto run = stickslip("diagnose '" + spec + "' '" + file + "' --no-report --threads " + threads + " -o '" +
                                   (folder / "out") + "'");
        INFO(run.output);
        CHECK(run.exit_code == 0);
        const auto json = program::read(folder / "out/diagnosis.json");
        CHECK_THAT(json, !Contains("insufficient-data"));
        if (answer.empty()) answer = json;
        CHECK(json == answer);
    }
}

TEST_CASE("records that say nothing, and files that are none", "[program][diagnose][slow]")
{
    struct Case {
        std::string text;
        int exit_code;
        std::string says;
    };
    std::string gap = record();
    gap.replace(gap.find("0.001,"), 6, "0.001,nan,nan,nan,nan\n0.0015,");
    const Case cases[] = {
        {record([](Row& r) { r.position = 0.5, r.velocity = 0; }), 4, "the position does not change"},
        {record([](Row&) {}, 10), 4, "10 rows"},
        {gap, 2, "run.csv:3:7: reference_position: is missing"},
        {"", 2, "is empty"},
        {"time,position\n", 2, "has a header and no rows"},
        {"time;position\n0,001;1,5\n", 2, "run.csv:2:1: time: is \"0,001\""},
        {"t,q\n0,1\n", 2, "run.csv:1:1: has no column time"},
        {std::string("\x7f"
                     "ELF\0\0\1",
                     7),
         2, "is not text"},
        {"time,position\n0,1\n0,2\n", 2, "run.csv:3:1: time: is 0, the same"},
        {"time,position\n1,1\n0,2\n", 2, "run.csv:3:1: time: is 0, earlier"},
    };
    for (const auto& c : cases) {
        Folder folder;
        const auto run = diagnose(folder, c.text);
        INFO(run.output);
        CHECK(run.exit_code == c.exit_code);
        CHECK_THAT(run.output, Contains(c.says));
    }
}

TEST_CASE("records are told apart, and where the answer goes is tried first", "[program][diagnose]")
{
    Folder folder;
    const auto spec = folder.write("joint.toml", joint), file = folder.write("run.csv", record());
    const auto run = [&](const std::string& records, const std::string& out) {
        return stickslip("diagnose '" + spec + "' " + records + " --no-report -o '" + out + "'");
    };
    const auto twice = run("'" + file + "' '" + (folder / ".") + "/run.csv'", folder / "out");
    CHECK(twice.exit_code == 2);
    CHECK_THAT(twice.output, Contains("is given twice"));
    std::filesystem::create_directory(folder / "b");
    const auto other = folder.write("b/run.csv", record([](Row& r) { r.position *= -1, r.velocity *= -1; }));
    const auto named = run("'" + file + "' '" + other + "'", folder / "out");
    INFO(named.output);
    CHECK(named.exit_code == 2);
    CHECK_THAT(named.output, Contains("b/run.csv: suspected sign"));
    const auto nowhere = run("'" + file + "'", file);
    CHECK(nowhere.exit_code == 2);
    CHECK_THAT(nowhere.output, Contains("run.csv"));
    CHECK(run("'" + file + "'", "").exit_code == 2);
    folder.write("out/report.html", "an earlier page");
    CHECK(run("'" + other + "'", folder / "out").exit_code == 2);
    CHECK_FALSE(std::filesystem::exists(folder / "out/report.html"));
}

TEST_CASE("a table of outcomes is diagnosed alone, and too few rows are said to be", "[program][diagnose]")
{
    Folder folder;
    const auto spec = folder.write("joint.toml", joint);
    const auto rows = folder.write("rows.csv", "k_p,V0 [mrad/s],outcome\n2,1,stick-slip\n4,1,stable\n");
    const auto alone = stickslip("diagnose '" + spec + "' '" + rows + "' -o '" + (folder / "out") + "'");
    INFO(alone.output);
    CHECK(alone.exit_code == 4);
    CHECK_THAT(alone.output, Contains("do not determine") && Contains("at least 8 rows"));
    CHECK(std::filesystem::exists(folder / "out/report.html"));
    const auto both = stickslip("diagnose '" + spec + "' '" + rows + "' '" + folder.write("run.csv", record()) + "'");
    CHECK(both.exit_code == 2);
    CHECK_THAT(both.output, Contains("is diagnosed alone"));
}

TEST_CASE("a person at a terminal sees what a diagnosis is busy with, a pipe does not", "[program][diagnose][slow]")
{
    if (program::shell("command -v script >/dev/null").exit_code != 0) {
        WARN("skipped: script is not installed here");
        return;
    }
    Folder folder;
    const auto spec = folder.write("joint.toml", joint), file = folder.write("run.csv", record([](Row&) {}, 8000));
    const std::string command = "diagnose '" + spec + "' '" + file + "' --no-report -o '" + (folder / "out") + "'";
    const auto seen = program::shell("TERM=xterm script -qec \"'" + std::string(STICKSLIP) + "' " + command +
                                     "\" /dev/null </dev/null");
    CHECK(seen.exit_code == 0);
    CHECK_THAT(seen.output, Contains("fitting single effects") && Contains("\r\x1b[K"));
    const auto piped = stickslip(command);
    CHECK(piped.exit_code == 0);
    // how often a pipe hears of the stage depends on the clock, and is nothing to test
    CHECK_THAT(piped.output, !Contains("\x1b") && !Contains("\r"));
}
