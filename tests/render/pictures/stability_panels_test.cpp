#include "render/render.h"
#include "tests/render/example_report.h"
#include "tests/render/well_formed.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <stdexcept>

using namespace stickslip;

namespace {

StabilityPanels panels(std::size_t across, std::size_t up)
{
    const StabilityMap map = example::map(9, 7);
    StabilityPanels p;
    p.title = "The same map along V_{0}";
    p.x = map.x;
    p.y = map.y;
    p.across = {"control.V0", "V_{0}", "commanded velocity", Quantity::velocity, true, {}};
    for (std::size_t i = 0; i < across; ++i) p.across.values.push_back(1e-3 * double(i + 1));
    if (up > 0) p.up = {"friction.L", "L", "slip distance", Quantity::position, true, {}};
    for (std::size_t i = 0; i < up; ++i) p.up.values.push_back(1e-5 * double(i + 1));
    for (std::size_t i = 0; i < across * std::max<std::size_t>(1, up); ++i)
        p.panels.push_back(
            {p.across.values[i % across], up ? p.up.values[i / across] : 0, map.abscissa, map.region, map.curves});
    p.design = map.design;
    p.has_design = true;
    return p;
}

}  // namespace

TEST_CASE("small multiples give each panel a place of its own, and a line of numbers to each node", "[panels]")
{
    for (const auto& [across, up] : {std::pair<std::size_t, std::size_t>{2, 0}, {5, 0}, {6, 0}, {4, 3}, {3, 2}}) {
        CAPTURE(across, up);
        const Figure figure{"panels", panels(across, up), "caption", "a finding in words"};
        const auto drawn = render(figure);
        REQUIRE(drawn.missing.empty());
        CHECK(oracle::fault_in_markup(drawn.svg) == "");
        const std::size_t count = across * std::max<std::size_t>(1, up);
        REQUIRE(drawn.panels.size() == count);
        for (std::size_t i = 0; i < count; ++i) {
            const auto& a = drawn.panels[i];
            CHECK(a.width > 100);
            CHECK(a.left >= 0);
            CHECK(a.left + a.width < drawn.width);
            CHECK(a.top + a.height < drawn.height);
            for (std::size_t k = 0; k < i; ++k) {
                const auto& b = drawn.panels[k];
                const bool apart = a.left >= b.left + b.width || b.left >= a.left + a.width ||
                                   a.top >= b.top + b.height || b.top >= a.top + a.height;
                CHECK(apart);
            }
        }
        CHECK(std::size_t(std::count(drawn.csv.begin(), drawn.csv.end(), '\n')) == 1 + count * 9 * 7);
    }
}

TEST_CASE("small multiples with a missing panel are refused", "[panels]")
{
    StabilityPanels p = panels(4, 3);
    p.panels.pop_back();
    CHECK_THROWS_AS(render({"panels", p, "", "a finding"}), std::invalid_argument);
    StabilityPanels torn = panels(3, 0);
    torn.panels[1].region.pop_back();
    CHECK_THROWS_AS(render({"panels", torn, "", "a finding"}), std::invalid_argument);
}
