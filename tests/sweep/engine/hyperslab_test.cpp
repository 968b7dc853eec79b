#include "sweep/engine/hyperslab.h"

#include <catch2/catch.hpp>
#include <random>

using namespace stickslip;

namespace {

/// The points of the boxes, one after the other, each box walked row-major.
std::vector<std::uint64_t> walk(const std::vector<std::size_t>& shape, const std::vector<Hyperslab>& slabs)
{
    std::vector<std::uint64_t> points;
    for (const Hyperslab& slab : slabs) {
        std::vector<std::size_t> at(shape.size(), 0);
        for (std::uint64_t n = 0; n < slab.points(); ++n) {
            std::uint64_t number = 0;
            for (std::size_t i = 0; i < shape.size(); ++i) {
                REQUIRE(slab.start[i] + at[i] < shape[i]);
                number = number * shape[i] + slab.start[i] + at[i];
            }
            points.push_back(number);
            for (std::size_t i = shape.size(); i-- > 0;) {
                if (++at[i] < slab.count[i]) break;
                at[i] = 0;
            }
        }
    }
    return points;
}

}  // namespace

TEST_CASE("any range of any grid is cut into boxes that hold its points in order")
{
    constexpr unsigned seed = 8;
    INFO("seed " << seed);
    std::mt19937 random(seed);
    for (int trial = 0; trial < 3000; ++trial) {
        std::vector<std::size_t> shape(random() % 6);
        std::uint64_t points = 1;
        for (auto& n : shape) points *= n = 1 + random() % 6;
        const std::uint64_t first = random() % points, count = 1 + random() % (points - first);
        const auto slabs = hyperslabs(shape, {first, count});
        const auto walked = walk(shape, slabs);
        REQUIRE(walked.size() == count);
        for (std::uint64_t i = 0; i < count; ++i) REQUIRE(walked[i] == first + i);
        REQUIRE(slabs.size() <= std::max<std::size_t>(1, 2 * shape.size() - (shape.empty() ? 0 : 1)));
    }
    CHECK(hyperslabs(std::vector<std::size_t>{4, 5}, {0, 0}).empty());
}
