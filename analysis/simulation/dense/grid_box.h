// Points of a map by their indices, and boxes of them. Internal to analysis/simulation/dense.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

namespace stickslip::dense {

inline constexpr int dimensions = 3;  ///< of a box; axes that a map lacks have one value
using Index = std::array<int, dimensions>;

/// The coordinates of a map's axes, the last axis fastest: logarithms where points are spread by their logarithm.
struct Grid {
    std::array<std::vector<double>, dimensions> coordinate;

    int size(int axis) const { return static_cast<int>(coordinate[axis].size()); }
    std::size_t points() const { return std::size_t{1} * size(0) * size(1) * size(2); }
    std::size_t number(const Index& i) const
    {
        return (static_cast<std::size_t>(i[0]) * size(1) + i[1]) * size(2) + i[2];
    }
    Index index(std::size_t number) const
    {
        const std::size_t rows = number / size(2);
        return {static_cast<int>(rows / size(1)), static_cast<int>(rows % size(1)), static_cast<int>(number % size(2))};
    }
};

/// From `low` to `high`, both included: boxes that lie side by side share the points between them.
struct Box {
    Index low{}, high{};

    int size(int axis) const { return high[axis] - low[axis] + 1; }
    std::size_t points() const { return std::size_t{1} * size(0) * size(1) * size(2); }
    bool holds(const Index& i) const
    {
        for (int d = 0; d < dimensions; ++d)
            if (i[d] < low[d] || i[d] > high[d]) return false;
        return true;
    }
};

/// In the order of the grid.
template <class Visit>
void for_each_index(const Box& box, Visit visit)
{
    Index i;
    for (i[0] = box.low[0]; i[0] <= box.high[0]; ++i[0])
        for (i[1] = box.low[1]; i[1] <= box.high[1]; ++i[1])
            for (i[2] = box.low[2]; i[2] <= box.high[2]; ++i[2]) visit(i);
}

/// The points within one step of `i`, along the axes and across, itself included.
inline Box around(const Grid& grid, const Index& i)
{
    Box box;
    for (int d = 0; d < dimensions; ++d) {
        box.low[d] = i[d] > 0 ? i[d] - 1 : 0;
        box.high[d] = i[d] + 1 < grid.size(d) ? i[d] + 1 : i[d];
    }
    return box;
}

}  // namespace stickslip::dense
