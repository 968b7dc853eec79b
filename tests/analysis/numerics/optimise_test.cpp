// What the searches do with functions that end early.
#include "analysis/numerics/optimise.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <stdexcept>

using namespace stickslip;

TEST_CASE("what an objective throws reaches whoever asked for its minimum")
{
    struct Enough : std::exception {};
    int calls = 0;
    const Objective objective = [&](const std::vector<double>& x) -> double {
        if (++calls == 7) throw Enough();
        return x[0] * x[0];
    };
    CHECK_THROWS_AS(local_minimum(objective, {{-1}, {2}}, {1.5}, 0.1, 100), Enough);
    CHECK(calls == 7);
}

TEST_CASE("a run that is asked for its next point point by point goes where it goes in one go")
{
    const Objective valley = [](const std::vector<double>& x) {
        return 100 * std::pow(x[1] - x[0] * x[0], 2) + std::pow(1 - x[0], 2);
    };
    for (const auto method : {SearchMethod::simplex, SearchMethod::subplex}) {
        Minimisation search{method, {{-2, -2}, {2, 2}}, {0.3, 0.2}, 90};
        search.ftol_rel = 1e-4;
        const std::vector<double> start{-1.2, 1};
        std::vector<std::vector<double>> points;
        minimum(
            search, [&](const std::vector<double>& x) { return points.push_back(x), valley(x); }, start);
        std::vector<double> values;
        for (const auto& point : points) {
            const auto next = next_point(search, start, values);
            REQUIRE(next);
            CHECK(*next == point);
            values.push_back(valley(point));
        }
        CHECK(points.size() > 30);
        CHECK_FALSE(next_point(search, start, values));
    }
}
