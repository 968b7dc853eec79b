#include "sweep/files/records/outcome_file.h"

#include "sweep/files/toml/joint_file.h"
#include "tests/sweep/files/messages.h"
#include "tests/temporary_directory.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>

using namespace stickslip;
using Catch::Contains;

namespace {

std::filesystem::path file(const std::string& content)
{
    std::ofstream(shared_directory() / "rows.csv", std::ios::binary) << content;
    return shared_directory() / "rows.csv";
}

const Joint joint = read_joint_text(
    "joint = { inertia = 1 }\ncontrol = { k_p = 1e4, V0 = 1e-3 }\n"
    "friction = { law = \"coulomb-viscous\", coulomb = 1, viscous = 1 }\n",
    "joint.toml");

std::string only_error(const std::string& content)
{
    std::vector<std::string> warnings;
    const auto path = file(content);
    auto all = messages_of([&] { read_outcomes(path, joint, warnings); });
    for (const auto& message : all) UNSCOPED_INFO(message);
    REQUIRE(all.size() == 1);
    return all[0].substr(shared_directory().path().string().size() + 1);
}

}  // namespace

TEST_CASE("a table of outcomes with units, comments, gaps and words")
{
    std::vector<std::string> warnings;
    const auto table =
        read_outcomes(file("\xef\xbb\xbf# PUMA, joint 1\r\nk_p [kN/m];V0 [mm/s];outcome;amplitude [µm];operator\r\n"
                           "20;1;stick-slip;150;A\r\n\r\n60; 2.5 ;stable;;B\r\n80;1;0;;B\r\n"),
                      joint, warnings);
    CHECK(table.name == "rows.csv");
    CHECK(table.paths == std::vector<std::string>{"control.k_p", "control.V0"});
    REQUIRE(table.rows.size() == 3);
    CHECK(table.rows[0].settings == std::vector<double>{2e4, 1e-3});
    CHECK(table.rows[0].stick_slip);
    CHECK(table.rows[0].amplitude == 150e-6);
    CHECK(table.rows[1].line == 5);
    CHECK(table.rows[1].settings[1] == 2.5e-3);
    CHECK_FALSE(table.rows[1].stick_slip);
    CHECK(std::isnan(table.rows[1].amplitude));
    CHECK_FALSE(table.rows[2].stick_slip);
    CHECK(warnings == std::vector<std::string>{"columns that are not read: operator"});
}

TEST_CASE("remarks and empty lines may stand between the rows of outcomes")
{
    std::vector<std::string> warnings;
    const auto table = read_outcomes(file("k_p,outcome\n1e4,1\n# oiled\n\n2e4,0\n"), joint, warnings);
    REQUIRE(table.rows.size() == 2);
    CHECK(table.rows[1].line == 5);
}

TEST_CASE("a table of outcomes is told from a record by its header")
{
    CHECK(is_outcome_file(file("# rows\nk_p,V0,outcome\n1,2,stable\n")));
    CHECK_FALSE(is_outcome_file(file("time,position,outcome\n0,1,2\n")));
    CHECK_FALSE(is_outcome_file(file("time,position\n0,1\n")));
    CHECK_FALSE(is_outcome_file(file("")));
}

TEST_CASE("rows of outcomes that do not do are refused at their place")
{
    CHECK_THAT(only_error("k_p,V0,outcome\n1e4,1e-3,sticky\n"),
               Contains("rows.csv:2:10: outcome: is \"sticky\", expected stable"));
    CHECK_THAT(only_error("k_p,V0,outcome\n1e4,,stable\n"), Contains("rows.csv:2:5: V0: is missing"));
    CHECK_THAT(only_error("k_p,V0,outcome\n1e4,fast,stable\n"), Contains("rows.csv:2:5: V0: is \"fast\""));
    CHECK_THAT(only_error("k_p,V0 [mm],outcome\n1e4,1,stable\n"), Contains("rows.csv:1:5: V0: "));
    CHECK_THAT(only_error("inertia,outcome\n-1,stable\n"), Contains("rows.csv:2:1: inertia: is -1, expected > 0"));
    CHECK_THAT(only_error("k_p,V0,outcome\n1e4,1e-3\n"), Contains("rows.csv:2:1: has 2 cells, the header has 3"));
    CHECK_THAT(only_error("k_p,V0,outcome\n1,5e4,1,0e-3,0,1\n"), Contains("decimal commas"));
    CHECK_THAT(only_error("k_p,outcome,amplitude\n1e4,1,-2\n"), Contains("amplitude: is -2, expected ≥ 0"));
    CHECK_THAT(only_error("speed,outcome\n1,1\n"), Contains("has no setting of the joint"));
    CHECK_THAT(only_error("k_p,k_p,outcome\n1,1,1\n"), Contains("appears twice"));
    CHECK_THAT(only_error("k_p,outcome\n"), Contains("has a header and no rows"));
}
