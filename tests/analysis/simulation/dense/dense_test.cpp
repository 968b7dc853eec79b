// Maps that compute few points against the same maps with every point computed.
#include "analysis/simulation/dense/dense_points.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "analysis/simulation/dense/interpolant.h"
#include "tests/analysis/simulation/dense/dense_map.h"
#include "tests/analysis/simulation/joints.h"

using namespace stickslip;

namespace {

constexpr double bound = 1e-4;

void check(Map map, double largest_share, const NonlinearOptions& options = {})
{
    map.prepare();
    const auto found = compare(dense_rows(map, options, bound), computed_rows(map, options));
    CAPTURE(map.axes.front().path, map.axes.back().path, found.computed, map.points());
    CHECK(found.other_verdict == 0);
    CHECK(found.other_bits == 0);
    CHECK(found.worst < bound);
    CHECK(found.told < bound);
    CHECK(found.told_of_computed == 0);
    CHECK(found.share_at_rest < 2 * bound);  // that of computed points is right to about 1e-4
    CHECK(static_cast<double>(found.computed) < largest_share * static_cast<double>(map.points()));
}

}  // namespace

TEST_CASE("polynomials through the values of an axis nearest to Chebyshev's points", "[dense]")
{
    dense::Grid grid;
    grid.coordinate = {std::vector<double>{0}, {}, {}};
    for (int i = 0; i < 60; ++i) grid.coordinate[1].push_back(std::log(1 + 0.1 * i));
    for (int i = 0; i < 40; ++i) grid.coordinate[2].push_back(0.05 * i);
    const dense::Box box{{0, 5, 0}, {0, 59, 39}};
    const auto value = [&](const dense::Index& i) {
        const double x = grid.coordinate[1][i[1]], y = grid.coordinate[2][i[2]];
        return 1 + x * x * x * x - 2 * x * y + y * y * y;
    };
    dense::Interpolant through(grid, box, {0, 2, 3}, 1);
    CHECK(through.line(1).count() == 5);
    CHECK(through.line(2).count() == 9);
    through.fill([&](const dense::Index& i, std::span<double> q) { q[0] = value(i); });
    double worst = 0;
    through.for_each_point([&](const dense::Index& i, std::span<const double> q) {
        worst = std::max(worst, std::abs(q[0] - value(i)));
        double again = 0;
        through.at(i, {&again, 1});
        CHECK(again == q[0]);
    });
    CHECK(worst < 1e-12);  // a polynomial of the fourth degree in x and the third in y
    CHECK(through.coarse_miss(0) == 0);
    CHECK(through.coarse_miss(1) > 1e-3);  // three nodes carry no fourth power
    CHECK(through.coarse_miss(2) < 1e-12);
    // nodes of a level are nodes of the next
    const auto few = dense::line_nodes(grid.coordinate[1], 5, 59, 2),
               more = dense::line_nodes(grid.coordinate[1], 5, 59, 3);
    for (const int i : few.index) CHECK(more.is_node(i));
}

TEST_CASE("a dense map of the slip law over k_v and k_p", "[dense][slow]")
{
    check({example_joint(6e4, 10, 1e-3), {{"control.k_v", 1, 1e4, 200, true}, {"control.k_p", 1e3, 1e6, 200, true}}},
          0.2);
}

TEST_CASE("a dense map of the slip law over V0 and k_p", "[dense][slow]")
{
    check({example_joint(6e4, 10, 1e-3), {{"control.V0", 1e-5, 1e-2, 200, true}, {"control.k_p", 1e3, 1e6, 200, true}}},
          0.4);
}

TEST_CASE("a dense map of the bistable strip", "[dense][slow]")
{
    check({example_joint(2.2e4, 47.5, 1e-2), {{"control.k_v", 40, 52, 80, false}, {"control.k_p", 5e3, 5e4, 80, true}}},
          0.5);
}

TEST_CASE("a dense map of Stribeck friction", "[dense]")
{
    check({stribeck_joint(2e4, 0, 1e-3), {{"control.V0", 2e-4, 2e-2, 160, true}, {"control.k_p", 1e3, 1e6, 160, true}}},
          0.3);
}

TEST_CASE("a dense map over three axes", "[dense][slow]")
{
    check({example_joint(6e4, 10, 1e-3),
           {{"control.k_p", 1e4, 2e5, 24, true},
            {"control.k_v", 1, 100, 24, true},
            {"control.V0", 1e-3, 1e-2, 40, true}}},
          0.9);
}

TEST_CASE("a dense map of a stated disturbance", "[dense][slow]")
{
    NonlinearOptions options;
    options.disturbance = {DisturbanceKind::position, 1e-5};
    check(
        {example_joint(2.2e4, 47.5, 1e-2), {{"control.k_v", 44, 48, 60, false}, {"control.k_p", 1.5e4, 4e4, 60, true}}},
        0.7, options);
}

TEST_CASE("rows of a dense map depend on its box alone", "[dense]")
{
    Map map{example_joint(6e4, 10, 1e-3), {{"control.k_v", 1, 1e4, 60, true}, {"control.k_p", 1e3, 1e6, 60, true}}};
    map.prepare();
    std::vector<PointResult> once(map.points()), again(map.points());
    dense_points(map.box(), {}, bound, once);
    dense_points(map.box(), {}, bound, again);
    for (std::size_t i = 0; i < once.size(); ++i) {
        CHECK(once[i].path == again[i].path);
        CHECK((once[i].amplitude == again[i].amplitude || std::isnan(once[i].amplitude)));
    }
}

TEST_CASE("a dense line of an ageing contact", "[dense][slow]")
{
    check({with_ageing(example_joint(6e4, 0, 1e-3)), {{"control.k_p", 1e4, 1e5, 100, true}}}, 0.75);
}

TEST_CASE("a dense line of a contact with two states, which no lanes have", "[dense][slow]")
{
    Joint joint = example_joint(6e4, 0, 1e-3);
    auto& law = std::get<RateAndState>(joint.friction.law);
    law.B[0] = 1, law.B.push_back(0.84), law.L.push_back(law.L[0] / 0.048);
    check({joint, {{"control.k_p", 1e4, 1e5, 100, true}}}, 0.75);
}
