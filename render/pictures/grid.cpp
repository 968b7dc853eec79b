#include "render/pictures/grid.h"

#include <algorithm>
#include <stdexcept>

namespace stickslip::drawing {
namespace {

std::vector<double> positions(const Axis& axis, const Scale& scale)
{
    std::vector<double> list;
    for (const double value : axis.values) list.push_back(scale.at(value));
    if (!std::is_sorted(list.begin(), list.end(), std::less_equal<>()))
        throw std::invalid_argument("the values of axis " + axis.path + " do not ascend");
    return list;
}

struct Between {
    std::size_t low = 0, high = 0;
    double share = 0;
};

Between between(const std::vector<double>& list, double position)
{
    if (list.size() < 2 || position <= list.front()) return {0, 0, 0};
    if (position >= list.back()) return {list.size() - 1, list.size() - 1, 0};
    const auto high = static_cast<std::size_t>(std::upper_bound(list.begin(), list.end(), position) - list.begin());
    return {high - 1, high, (position - list[high - 1]) / (list[high] - list[high - 1])};
}

}  // namespace

Grid::Grid(const Axis& x, const Scale& x_scale, const Axis& y, const Scale& y_scale)
    : columns_(positions(x, x_scale)), rows_(positions(y, y_scale))
{
}

std::size_t Grid::Place::nearest() const
{
    return node[static_cast<std::size_t>(std::max_element(weight.begin(), weight.end()) - weight.begin())];
}

Grid::Place Grid::at(double across, double up) const
{
    const Between c = between(columns_, across), r = between(rows_, up);
    const std::size_t low = r.low * columns_.size(), high = r.high * columns_.size();
    return {{low + c.low, low + c.high, high + c.low, high + c.high},
            {(1 - r.share) * (1 - c.share), (1 - r.share) * c.share, r.share * (1 - c.share), r.share * c.share}};
}

}  // namespace stickslip::drawing
