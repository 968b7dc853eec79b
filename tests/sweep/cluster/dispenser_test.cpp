#include "sweep/cluster/dispenser.h"

#include <catch2/catch.hpp>
#include <vector>

using namespace stickslip;

TEST_CASE("a cluster's chunks are handed out once each, in shrinking batches, and done ones are not counted")
{
    constexpr std::uint64_t chunks = 10'000;
    const IsDone every_third = [](std::uint64_t chunk) { return chunk % 3 == 0; };
    Dispenser dispenser(chunks, 4, every_third);
    std::vector<int> seen(chunks, 0);
    std::uint64_t claims = 0, last = 64;
    for (;;) {
        const ChunkRange range = claims % 5 == 0 ? dispenser.claim_one() : dispenser.claim();
        if (range.empty()) break;
        if (claims++ % 5 != 0) {
            CHECK(range.end - range.first <= last);
            last = range.end - range.first;
        }
        for (std::uint64_t chunk = range.first; chunk < range.end; ++chunk) ++seen.at(chunk);
    }
    std::uint64_t left_to_do = 0;
    for (std::uint64_t chunk = 0; chunk < chunks; ++chunk) {
        CHECK(seen[chunk] <= 1);
        if (!every_third(chunk)) {
            CHECK(seen[chunk] == 1);
            ++left_to_do;
        }
    }
    CHECK(dispenser.claimed() == left_to_do);
    CHECK(last == 1);
    CHECK(claims < 800);
}

TEST_CASE("a closed dispenser gives nothing")
{
    Dispenser dispenser(100, 2, [](std::uint64_t) { return false; });
    CHECK_FALSE(dispenser.claim_one().empty());
    dispenser.close();
    CHECK(dispenser.claim_one().empty());
    CHECK(dispenser.claim().empty());
    CHECK(dispenser.claimed() == 1);
}
