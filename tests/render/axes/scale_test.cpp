#include "render/axes/scale.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <stdexcept>

using namespace stickslip;
using namespace stickslip::drawing;

namespace {

std::vector<std::string> labels(const Ticks& ticks)
{
    std::vector<std::string> list;
    for (const Tick& t : ticks.major) list.push_back(t.label);
    return list;
}

using Labels = std::vector<std::string>;

}  // namespace

TEST_CASE("a scale and its inverse agree", "[axes]")
{
    for (const Scale scale : {Scale{1e3, 1e6, true}, Scale{-2, 6, false}})
        for (const double u : {0.0, 0.25, 0.5, 1.0, 1.3}) CHECK(scale.at(scale.value(u)) == Approx(u).margin(1e-12));
    CHECK(Scale{1e3, 1e6, true}.at(1e5) == Approx(2.0 / 3));
}

TEST_CASE("a log axis has a label on each power of ten and eight minor ticks between", "[axes]")
{
    const Ticks t = ticks({1e3, 1e6, true}, 7);
    CHECK(labels(t) == Labels{"10^{3}", "10^{4}", "10^{5}", "10^{6}"});
    REQUIRE(t.minor.size() == 24);
    CHECK(t.minor[0] == Approx(2e3));
    CHECK(t.minor[7] == Approx(9e3));
    CHECK(t.minor[8] == Approx(2e4));
    CHECK(labels(ticks({1e-6, 1e-3, true}, 7)).front() == "10^{−6}");
}

TEST_CASE("many powers thin out, few are filled with 1, 2 and 5", "[axes]")
{
    CHECK(labels(ticks({1e-8, 1e8, true}, 6)) == Labels{"10^{−6}", "10^{−3}", "10^{0}", "10^{3}", "10^{6}"});
    CHECK(labels(ticks({3, 40, true}, 7)) == Labels{"5", "10", "20"});
    CHECK(labels(ticks({1, 100, true}, 7)).size() == 3);
    // beyond what reads well as a plain number all of them are powers
    CHECK(labels(ticks({2e4, 1e6, true}, 7)) ==
          Labels{"2×10^{4}", "5×10^{4}", "10^{5}", "2×10^{5}", "5×10^{5}", "10^{6}"});
    CHECK(labels(ticks({2e-5, 4e-4, true}, 7)) == Labels{"2×10^{−5}", "5×10^{−5}", "10^{−4}", "2×10^{−4}"});
}

TEST_CASE("a log axis of less than half a power has even steps: 1, 2 and 5 would leave it bare", "[axes]")
{
    CHECK(labels(ticks({32e3, 77e3, true}, 7)) == Labels{"40000", "50000", "60000", "70000"});
    const Ticks t = ticks({23e3, 39e3, true}, 7);
    CHECK(labels(t) == Labels{"25000", "30000", "35000"});
    CHECK(t.major[1].value == Approx(30e3));
}

TEST_CASE("a linear axis steps in 1, 2 or 5 and ends where the numbers end", "[axes]")
{
    CHECK(labels(ticks({0, 10, false}, 6)) == Labels{"0", "2", "4", "6", "8", "10"});
    CHECK(labels(ticks({-0.3, 0.3, false}, 6)) == Labels{"−0.3", "−0.2", "−0.1", "0", "0.1", "0.2", "0.3"});
    CHECK(labels(ticks({1000, 1001, false}, 5)) == Labels{"1000", "1000.2", "1000.4", "1000.6", "1000.8", "1001"});
    CHECK(labels(ticks({0, 60e3, false}, 6, 1e3)) == Labels{"0", "10", "20", "30", "40", "50", "60"});
    CHECK(ticks({0, 60e3, false}, 6, 1e3).major[1].value == Approx(10e3));
    const Ticks t = ticks({0, 10, false}, 6);
    CHECK(t.minor.size() == 15);  // three between neighbours that are 2 apart
}

TEST_CASE("no label repeats and none lies off the axis, for any range", "[axes]")
{
    for (const double size : {1e-7, 0.3, 1.0, 77.0, 4.2e5})
        for (const double offset : {0.0, 1.0, -3.7, 50.0}) {
            const Scale scale{offset * size, (offset + 1) * size, false};
            const Ticks t = ticks(scale, 6);
            INFO("from " << scale.low << " to " << scale.high);
            REQUIRE(t.major.size() >= 3);
            CHECK(t.major.size() <= 8);
            for (std::size_t i = 0; i < t.major.size(); ++i) {
                CHECK(scale.at(t.major[i].value) > -1e-6);
                CHECK(scale.at(t.major[i].value) < 1 + 1e-6);
                if (i) CHECK(t.major[i].label != t.major[i - 1].label);
            }
        }
}

TEST_CASE("axes carry name, symbol and a unit whose prefix suits the labels", "[axes]")
{
    const Units p;
    const AxisLabel linear = axis_label("position gain", "k_{p}", Quantity::stiffness, p, {0, 6e4, false});
    CHECK(linear.text == "position gain k_{p} [kN/m]");
    CHECK(linear.divisor == 1000);
    const AxisLabel log = axis_label("position gain", "k_{p}", Quantity::stiffness, p, {1e3, 1e6, true});
    CHECK(log.text == "position gain k_{p} [N/m]");
    CHECK(log.divisor == 1);
    CHECK(axis_label("slip distance", "L", Quantity::position, p, {0, 5e-5, false}).text == "slip distance L [µm]");
    CHECK(axis_label("", "n", Quantity::number, p, {0, 5, false}).text == "n");
}

TEST_CASE("a range is what the values span, and never empty", "[axes]")
{
    const Scale s = spanning({3, NAN, -1, INFINITY}, false);
    CHECK(s.low == -1);
    CHECK(s.high == 3);
    for (const bool log : {false, true}) {
        const Scale one = spanning({5}, log);
        CHECK(one.at(5) == Approx(0.5));
    }
    CHECK(spanning({0}, false).at(0) == Approx(0.5));
    CHECK_THROWS_AS(spanning({}, false), std::invalid_argument);
    CHECK_THROWS_AS(spanning({NAN}, false), std::invalid_argument);
    CHECK_THROWS_AS(spanning({0, 1}, true), std::invalid_argument);
}

TEST_CASE("a finished label takes the prefix on a linear axis only", "[axes]")
{
    const auto micro = axis_label(AxisName{"velocity V", "m/s"}, Scale{-1e-4, 2e-4, false});
    CHECK(micro.text == "velocity V [µm/s]");
    CHECK(micro.divisor == Approx(1e-6));
    CHECK(axis_label(AxisName{"velocity V", "m/s"}, Scale{1e-4, 2e-4, true}).text == "velocity V [m/s]");
    CHECK(axis_label(AxisName{"mass", "kg"}, Scale{0, 2e3, false}).text == "mass [kg]");
    CHECK(axis_label(AxisName{"share"}, Scale{0, 1e-3, false}).divisor == 1);
}
