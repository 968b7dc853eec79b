#include "sweep/files/records/record_layout.h"

#include "sweep/files/toml/joint_file.h"
#include "tests/sweep/files/messages.h"

#include <catch2/catch.hpp>
#include <string>

using namespace stickslip;
using Catch::EndsWith;
using Catch::StartsWith;

namespace {

const std::string text_of_joint = R"(joint.inertia = 1
control.k_p = 1
friction = { law = "coulomb-viscous", coulomb = 1, viscous = 1 }
)";

}  // namespace

TEST_CASE("layouts that are wrong")
{
    const auto error = [](const std::string& text) {
        const Joint joint = read_joint_text(text_of_joint, "joint.toml");
        const auto all = messages_of([&] { read_record_layout_text(text, "record.toml", joint); });
        INFO(text);
        REQUIRE(all.size() == 1);
        return all.front();
    };
    CHECK(error("record = 3\n") == "record.toml:1:10: record: is 3, expected a table");
    CHECK(error("[record]\ncolums = {}\n") ==
          "record.toml:2:1: record.colums: unknown key, expected columns, constants, at_rest_at_start, files; "
          "did you mean \"columns\"?");
    CHECK_THAT(error("columns.positon = \"x\"\n"),
               StartsWith("record.toml:1:9: record.columns.positon: is not a signal of a record") &&
                   EndsWith("\"position\"?"));
    CHECK(error("columns.q_des = \"reference_position\"\n") ==
          "record.toml:1:17: record.columns.q_des: is not a signal of a record, reference_position is: expected "
          "reference_position = \"q_des\"");
    CHECK_THAT(error("columns.position = 3\n"),
               StartsWith("record.toml:1:20: record.columns.position: is 3, expected the name of a column"));
    CHECK_THAT(error("columns.position = { nam = \"x\" }\n"),
               StartsWith("record.toml:1:22: record.columns.position.nam: unknown key") && EndsWith("\"name\"?"));
    CHECK(error("columns.position = { unit = \"deg\" }\n") ==
          "record.toml:1:29: record.columns.position.unit: \"deg\" is not a unit of this quantity, expected m");
    CHECK_THAT(error("columns.position = { scale = 0 }\n"),
               StartsWith("record.toml:1:30: record.columns.position.scale: is 0"));
    CHECK_THAT(error("columns.position = { offset = \"1 N\" }\n"),
               StartsWith("record.toml:1:31: record.columns.position.offset: ") && EndsWith("expected m"));
    CHECK_THAT(error("constants.time = 1\n"),
               StartsWith("record.toml:1:18: record.constants.time: cannot be constant"));
    CHECK_THAT(error("constants.current = \"1 V\"\n"), EndsWith("expected A"));
    CHECK_THAT(error("at_rest_at_start = 1\n"),
               StartsWith("record.toml:1:20: record.at_rest_at_start: is 1, expected true, false"));
    CHECK_THAT(error("files.\"a*\" = 3\n"), StartsWith("record.toml:1:14: record.files.a*: is 3, expected a table"));
    CHECK_THAT(
        error("[record.files.\"a*\"]\nkp = 3\n"),
        StartsWith(
            "record.toml:2:1: record.files.a*.kp: is not a parameter of this joint; did you mean \"control.k_p\"?"));
    CHECK_THAT(error("[record.files.\"a*\"]\nphase = 3\n"),
               StartsWith("record.toml:2:1: record.files.a*.phase: is not a parameter of this joint"));
    CHECK_THAT(error("[record.files.\"a*\"]\ncontrol.k_p = true\n"),
               StartsWith("record.toml:2:15: record.files.a*.control.k_p: is true"));
}

TEST_CASE("later rules win, signal by signal")
{
    const Joint joint = read_joint_text(text_of_joint, "joint.toml");
    const auto layout = read_record_layout_text(R"(columns = { position = "x", velocity = "v" }
constants.current = 1
[files."run-?"]
columns.position = "y"
at_rest_at_start = false
[files."run-2"]
constants.current = "2 mA"
)",
                                                "record.toml", joint);
    const auto other = layout.rule_for("walk");
    REQUIRE(other.columns.size() == 2);
    CHECK(layout.rule_for("run-10").columns.size() == 2);
    const auto first = layout.rule_for("run-1"), second = layout.rule_for("run-2");
    const auto name_of_signal = [](const RecordLayout::Rule& rule, const std::string& signal) {
        for (const auto& column : rule.columns)
            if (column.signal == signal) return column.name;
        return std::string();
    };
    CHECK(name_of_signal(other, "position") == "x");
    CHECK(name_of_signal(first, "position") == "y");
    CHECK(name_of_signal(first, "velocity") == "v");
    CHECK_FALSE(other.at_rest_at_start.has_value());
    CHECK(first.at_rest_at_start == false);
    CHECK(first.constants == std::vector<std::pair<std::string, double>>{{"current", 1}});
    CHECK(second.constants == std::vector<std::pair<std::string, double>>{{"current", 2e-3}});
}
