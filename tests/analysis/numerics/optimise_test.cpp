// What the searches do with functions that end early.
#include "analysis/numerics/optimise.h"

#include <catch2/catch.hpp>

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
