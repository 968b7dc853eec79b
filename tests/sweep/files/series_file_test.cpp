// Records of one quantity: which columns are taken, what is refused.
#include "sweep/files/text/series_file.h"

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "sweep/files/text/bad_input.h"
#include "tests/temporary_directory.h"

using namespace stickslip;
using Catch::Matchers::Contains;

namespace {

struct TemporaryFile {
    explicit TemporaryFile(const std::string& text) { std::ofstream(path) << text; }

    const TemporaryDirectory directory;
    const std::filesystem::path path = directory / "series.csv";
};

}  // namespace

TEST_CASE("a series is two columns, or the named one of more", "[files]")
{
    const auto two = read_series(TemporaryFile("# a rig\n0,1\n0.5;2\n2\t4\n").path, "force");
    CHECK(two.time == std::vector<double>{0, 0.5, 2});
    CHECK(two.value == std::vector<double>{1, 2, 4});
    CHECK(two.duration() == 2);
    const auto named =
        read_series(TemporaryFile("normal_load [N],position,\"time [s]\"\n250,7,10\n300,8,10.5\n").path, "normal_load");
    CHECK(named.time == std::vector<double>{10, 10.5});
    CHECK(named.value == std::vector<double>{250, 300});
}

TEST_CASE("units in the header of a series are converted, in either order of the columns", "[files]")
{
    const SeriesQuantity stiffness{Quantity::stiffness, {}};
    const auto kernel = read_series(TemporaryFile("time [ms],g [kN/m]\n0,100\n10,50\n").path, "g", stiffness);
    CHECK(kernel.time == std::vector<double>{0, 0.01});
    CHECK(kernel.value == std::vector<double>{1e5, 5e4});
    const auto round = read_series(TemporaryFile("time (ms),g (kN/m)\n0,100\n10,50\n").path, "g", stiffness);
    CHECK(round.time == kernel.time);
    CHECK(round.value == kernel.value);
    const auto swapped = read_series(TemporaryFile("g,time\n100,0\n50,0.01\n").path, "g", stiffness);
    CHECK(swapped.time == kernel.time);
    CHECK(swapped.value == std::vector<double>{100, 50});
    // a normal load stays in the record's unit, its time does not
    const auto load = read_series(TemporaryFile("time [min],normal_load [kN]\n0,1\n2,3\n").path, "normal_load");
    CHECK(load.time == std::vector<double>{0, 120});
    CHECK(load.value == std::vector<double>{1, 3});
}

TEST_CASE("a series that does not fit is refused at its place", "[files]")
{
    const auto refuse = [&](const char* text, const char* says) {
        const TemporaryFile file(text);
        CHECK_THROWS_WITH(read_series(file.path, "force"), Contains(says));
    };
    refuse("time,load,position\n0,1,2\n1,2,3\n", ".csv:1:1: has no column \"force\"");
    refuse("0,1\n1,2\n1,3\n", ".csv:3:1: time does not rise");
    refuse("0,1\n1,two\n", ".csv:2:1: is not a row of two numbers");
    refuse("0,1\n1,nan\n", ".csv:2:1");
    refuse("0,1\n", "fewer than two rows");
    refuse("0;1\n0,5;2\n", ".csv:2:1: has 3 cells, the rows above have 2; numbers need a decimal point");
    const TemporaryFile wrong("time [m],force\n0,1\n1,2\n");
    CHECK_THROWS_WITH(read_series(wrong.path, "force", SeriesQuantity{Quantity::effort, {}}),
                      Contains(".csv:1:1: column time [m]") && Contains("not a unit of this quantity"));
}
