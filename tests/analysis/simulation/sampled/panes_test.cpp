// Sums over runs of panes, against additions one by one.
#include <catch2/catch.hpp>

#include "analysis/simulation/sampled/cycles/panes.h"

#include <random>

using namespace stickslip;

TEST_CASE("panes: the sum of any run is that of its panes, one after another", "[sampled]")
{
    constexpr std::size_t count = 45;
    std::mt19937_64 random(3);
    std::uniform_int_distribution<int> whole(-50, 50);  // sums of whole numbers are exact in any order
    Panes panes;
    std::vector<Stretch> each;
    for (std::size_t i = 0; i < count; ++i) {
        Stretch s;
        s.outer.position_min = whole(random), s.outer.position_max = s.outer.position_min + 3;
        s.outer.velocity_max = whole(random), s.outer.velocity_min = s.outer.velocity_max - 1;
        s.outer.rest_time = i % 3, s.outer.reversed = i % 11 == 0;
        s.ticks = whole(random), s.rests = whole(random), s.rounds = static_cast<int>(i % 2);
        s.sizes = whole(random), s.squares = whole(random), s.changes = whole(random);
        if (s.rounds > 0) s.first_round = s.last_round = static_cast<double>(i);
        each.push_back(s);
        panes.begin();
        panes.newest().add(s);
        panes.complete();
        for (std::size_t first = 0; first < each.size(); ++first) {
            Stretch sum;
            for (std::size_t k = first; k < each.size(); ++k) sum.add(each[k]);
            const Stretch fast = panes.sum(first, each.size());
            CAPTURE(first, each.size());
            REQUIRE(fast.outer.position_min == sum.outer.position_min);
            REQUIRE(fast.outer.position_max == sum.outer.position_max);
            REQUIRE(fast.outer.velocity_min == sum.outer.velocity_min);
            REQUIRE(fast.outer.velocity_max == sum.outer.velocity_max);
            REQUIRE(fast.outer.rest_time == sum.outer.rest_time);
            REQUIRE(fast.outer.reversed == sum.outer.reversed);
            REQUIRE(fast.ticks == sum.ticks);
            REQUIRE(fast.rests == sum.rests);
            REQUIRE(fast.rounds == sum.rounds);
            REQUIRE(fast.sizes == sum.sizes);
            REQUIRE(fast.squares == sum.squares);
            REQUIRE(fast.changes == sum.changes);
            REQUIRE((fast.first_round == sum.first_round || fast.rounds == 0));
            REQUIRE((fast.last_round == sum.last_round || fast.rounds == 0));
        }
    }
    CHECK(panes.size() == count);
}
