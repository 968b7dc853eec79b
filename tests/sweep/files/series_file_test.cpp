// Records of one quantity: which columns are taken, what is refused, and means over samples.
#include "sweep/files/series_file.h"

#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "sweep/files/bad_input.h"

using namespace stickslip;
using Catch::Matchers::Contains;

namespace {

/// A file of its own, removed at the end.
class TemporaryFile {
  public:
    explicit TemporaryFile(const std::string& text)
        : path(std::filesystem::temp_directory_path() / ("stickslip-series-" + std::to_string(getpid()) + ".csv"))
    {
        std::ofstream(path) << text;
    }
    ~TemporaryFile() { std::filesystem::remove(path); }
    TemporaryFile(const TemporaryFile&) = delete;

    const std::filesystem::path path;
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

TEST_CASE("a series that does not fit is refused at its place", "[files]")
{
    const auto refuse = [&](const char* text, const char* says) {
        const TemporaryFile file(text);
        CHECK_THROWS_WITH(read_series(file.path, "force"), Contains(says));
    };
    refuse("time,load,position\n0,1,2\n1,2,3\n", ".csv:1:1: has no column \"force\"");
    refuse("0,1\n1,2\n1,3\n", ".csv:3:1: time does not rise");
    refuse("0,1\n1,two\n", ".csv:2:1: is no row of two numbers");
    refuse("0,1\n1,nan\n", ".csv:2:1");
    refuse("0,1\n", "fewer than two rows");
}

TEST_CASE("samples are means of the straight lines, the last value behind them", "[files]")
{
    const Series s{{3, 4, 6}, {0, 2, -2}};
    // ∫ from the first row: t² up to 1, then 1 + 2(t − 1) − (t − 1)² up to 3, then −2 a second
    const auto means = s.sampled(0.8, 5);
    const auto integral = [](double t) {
        return t <= 1 ? t * t : t <= 3 ? 1 + 2 * (t - 1) - (t - 1) * (t - 1) : 1 - 2 * (t - 3);
    };
    for (int k = 0; k < 5; ++k)
        CHECK(means[k] == Approx((integral(0.8 * (k + 1)) - integral(0.8 * k)) / 0.8).margin(1e-12));
}
