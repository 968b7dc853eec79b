// results.nc holds what was computed under names that tools understand.
#include "sweep/engine/results_file.h"

#include <catch2/catch.hpp>
#include <cstdlib>
#include <set>

#include "sample_sweep.h"
#include "sweep/engine/results_layout.h"

using namespace sample;

TEST_CASE("dimensions are called by the last part of their path, made unique")
{
    const auto names = [](const std::vector<std::string>& paths) {
        std::vector<Axis> swept;
        for (const auto& path : paths) swept.push_back(axis(path, 1, 1, 1));
        return dimension_names(swept);
    };
    using Names = std::vector<std::string>;
    CHECK(names({"control.k_p", "control.V0"}) == Names{"k_p", "V0"});
    CHECK(names({"friction.L"}) == Names{"L"});
    CHECK(names({"friction.L.0", "friction.L.1"}) == Names{"L_0", "L_1"});
    CHECK(names({"friction.motor.A", "friction.link.A"}) == Names{"motor_A", "link_A"});
    CHECK(names({"control.period"}) == Names{"control_period"});  // "period" is a column
    CHECK(names({"a.b.c", "b.c", "c"}) == Names{"a_b_c", "b_c", "c"});
    CHECK(names({"a.b_c", "a_b.c", "a_b_c"}).size() == 3);
    const auto odd = names({"a.b_c", "a_b.c", "a_b_c"});
    CHECK(std::set<std::string>(odd.begin(), odd.end()).size() == 3);
}

TEST_CASE("planes and lines come out of the file as they were computed, whichever axis is slower")
{
    TemporaryDirectory directory;
    const Plan p = plan({4, 5, 6, 3}, 7);
    run(p, directory / "a");
    const ResultsFile results(directory / "a/results.nc");
    REQUIRE(results.axes().size() == 4);
    CHECK(results.axes()[1].values == p.axes[1].values);
    CHECK(results.axes()[1].path == "control.k_v");
    CHECK(results.axes()[0].quantity == Quantity::stiffness);

    const std::vector<std::size_t> at{3, 1, 2, 0};
    PointCursor cursor(joint(), p.axes);
    const std::size_t shape[] = {4, 5, 6, 3};
    for (std::size_t x = 0; x < 4; ++x)
        for (std::size_t y = 0; y < 4; ++y) {
            if (x == y) continue;
            const auto plane = results.plane("omega", x, y, at);
            const auto codes = results.code_plane("region", x, y, at);
            REQUIRE(plane.size() == shape[x] * shape[y]);
            for (std::size_t ix = 0; ix < shape[x]; ++ix)
                for (std::size_t iy = 0; iy < shape[y]; ++iy) {
                    auto index = at;
                    index[x] = ix;
                    index[y] = iy;
                    cursor.seek(((index[0] * 5 + index[1]) * 6 + index[2]) * 3 + index[3]);
                    REQUIRE(plane[iy * shape[x] + ix] == toy_point(cursor.joint()).omega);
                    REQUIRE(codes[iy * shape[x] + ix] == static_cast<std::uint8_t>(toy_point(cursor.joint()).region));
                }
        }
    CHECK(results.line("omega", 2, at)[1] == results.plane("omega", 2, 0, at)[3 * 6 + 1]);
}

TEST_CASE("codes are counted alike by merge, by the reader and by hand")
{
    TemporaryDirectory directory;
    const Plan p = plan({30, 20, 10}, 64);
    const RunReport report = run(p, directory / "a");
    std::vector<std::uint64_t> expected(256);
    PointCursor cursor(joint(), p.axes);
    for (std::uint64_t k = 0; k < p.points; ++k, cursor.advance())
        ++expected[static_cast<std::size_t>(toy_point(cursor.joint()).region)];
    CHECK(ResultsFile(directory / "a/results.nc").count_codes("region") == expected);
    REQUIRE(report.merged);
    REQUIRE(report.merged->codes.front().column == "region");
    CHECK(std::equal(expected.begin(), expected.end(), report.merged->codes.front().count.begin()));
}

TEST_CASE("the nearest index goes by ratio on a log axis")
{
    Axis a{"x", "x", "x", Quantity::number, false, {1, 10, 100}};
    CHECK(nearest_index(a, 40) == 1);
    CHECK(nearest_index(a, 60) == 2);
    a.log = true;
    CHECK(nearest_index(a, 40) == 2);
    CHECK(nearest_index(a, 3) == 0);
    CHECK(nearest_index(a, 1e9) == 2);
}

TEST_CASE("a file that is no results file is refused")
{
    TemporaryDirectory directory;
    set_bytes(directory / "x.nc", "not a NetCDF file");
    CHECK_THROWS_AS(ResultsFile(directory / "x.nc"), NetcdfError);
    CHECK_THROWS_AS(ResultsFile(directory / "missing.nc"), NetcdfError);
    run(plan({3}), directory / "a");
    const ResultsFile results(directory / "a/results.nc");
    CHECK_FALSE(results.has("amplitude"));
    CHECK_THROWS_WITH(results.numbers("amplitude"), Catch::Contains("amplitude"));
}

TEST_CASE("results.nc opens in xarray with names, units and flags in place", "[slow]")
{
    constexpr char python[] = "/usr/bin/python3";
    if (std::system((std::string(python) + " -c 'import xarray, netCDF4' 2>/dev/null").c_str()) != 0) {
        WARN("skipped: python3-xarray or python3-netcdf4 is not installed");
        return;
    }
    TemporaryDirectory directory;
    run(plan({4, 3, 2}), directory / "a");
    set_bytes(directory / "check.py", R"(
import sys, xarray, numpy
d = xarray.open_dataset(sys.argv[1])
assert dict(d.sizes) == {"k_p": 4, "k_v": 3, "V0": 2}, d.sizes
assert d.k_cr.dims == ("k_p", "k_v", "V0")
assert d.k_p.attrs["units"] == "N/m" and d.k_v.attrs["units"] == "N·s/m" and d.V0.attrs["units"] == "m/s"
assert d.k_p.attrs["path"] == "control.k_p" and d.k_p.attrs["long_name"]
assert d.k_cr.attrs["units"] == "N/m" and d.omega.attrs["units"] == "rad/s"
assert d.region.dtype == numpy.int8
assert d.region.attrs["flag_meanings"].split()[:2] == ["stable", "memory_only"]
assert list(d.region.attrs["flag_values"]) == [0, 1, 2, 3, 4, 5, 6]
assert d.attrs["Conventions"] == "CF-1.10" and d.attrs["title"] == "sample" and len(d.attrs["plan_id"]) == 32
assert float(d.k_v_min.sel(k_p=1e5, k_v=50, V0=1e-4)) == 1e5 * 0.5 + 50
assert numpy.isnan(d.k_cr.sel(k_v=0)).all() and not numpy.isnan(d.k_cr.sel(k_v=50)).any()
)");
    const std::string command =
        std::string(python) + " " + (directory / "check.py").string() + " " + (directory / "a/results.nc").string();
    CHECK(std::system(command.c_str()) == 0);
}
