#include "sweep/engine/hyperslab.h"

#include <algorithm>

namespace stickslip {

std::uint64_t Hyperslab::points() const
{
    std::uint64_t product = 1;
    for (const std::size_t n : count) product *= n;
    return product;
}

std::vector<Hyperslab> hyperslabs(std::span<const std::size_t> shape, PointRange range)
{
    std::vector<Hyperslab> slabs;
    std::uint64_t at = range.first, left = range.count;
    while (left > 0) {
        // The widest box that starts here: go up while the position is the first of its block and the block fits in.
        std::uint64_t block = 1;
        std::size_t axis = shape.size();
        while (axis > 0 && at % (block * shape[axis - 1]) == 0 && block * shape[axis - 1] <= left)
            block *= shape[--axis];

        Hyperslab slab{std::vector<std::size_t>(shape.size(), 0), std::vector<std::size_t>(shape.size(), 1)};
        std::copy(shape.begin() + static_cast<std::ptrdiff_t>(axis), shape.end(),
                  slab.count.begin() + static_cast<std::ptrdiff_t>(axis));
        std::uint64_t rest = at / block;
        for (std::size_t i = axis; i-- > 0;) {
            slab.start[i] = rest % shape[i];
            rest /= shape[i];
        }
        if (axis > 0) {
            // Several such blocks side by side along the next slower axis.
            const std::uint64_t room = shape[axis - 1] - slab.start[axis - 1];
            slab.count[axis - 1] = std::min<std::uint64_t>(room, left / block);
        }
        at += slab.points();
        left -= slab.points();
        slabs.push_back(std::move(slab));
    }
    return slabs;
}

}  // namespace stickslip
