#include "sweep/files/text/header_row.h"

#include "sweep/files/records/table_columns.h"
#include "tests/temporary_directory.h"

#include <catch2/catch.hpp>

#include <fstream>

using namespace stickslip;

namespace {

std::vector<std::string> columns(const std::string& content)
{
    const auto file = shared_directory() / "table.csv";
    std::ofstream(file, std::ios::binary) << content;
    return table_columns(file.string());
}

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("The header row of a table stands behind comments, empty lines and a byte order mark")
{
    CHECK(columns("elbow_position,time\n1,2\n") == Names{"elbow_position", "time"});
    CHECK(columns("\xef\xbb\xbf"
                  "elbow_position,time\n1,2\n") == Names{"elbow_position", "time"});
    CHECK(columns("\xef\xbb\xbf# rig 7\n\n \"elbow_position\" ; time\n1;2\n") == Names{"elbow_position", "time"});
    CHECK(columns("# rig 7\n").empty());
}

TEST_CASE("The separator of a table is a comma where its header has one")
{
    CHECK(files::separator_of("time,position;x") == ',');
    CHECK(files::separator_of("time;position\tx") == ';');
    CHECK(files::separator_of("time\tposition") == '\t');
}

TEST_CASE("A column's unit is in brackets after its name")
{
    using Parts = std::pair<std::string, std::string>;
    CHECK(files::name_and_unit("position [mm/s]") == Parts{"position", "mm/s"});
    CHECK(files::name_and_unit("position") == Parts{"position", ""});
    CHECK(files::name_and_unit("a[0] x") == Parts{"a[0] x", ""});
    CHECK(files::name_and_unit("position (rad)") == Parts{"position", "rad"});
    CHECK(files::name_and_unit("k_v(N/(m/s))") == Parts{"k_v", "N/(m/s)"});
    for (const auto* name : {"position (link)", "position (2)", "position ()", "f(x) (N)", "a(m) x"})
        CHECK(files::name_and_unit(name) == Parts{name, ""});
}
