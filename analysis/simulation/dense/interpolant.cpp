#include "analysis/simulation/dense/interpolant.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stickslip::dense {
namespace {

/// Weights of the nodes at x: Lagrange's polynomials by the barycentric formula, exact at the nodes.
void cardinal_at(double x, std::span<const double> node, std::span<const double> weight, double* result)
{
    double sum = 0;
    for (std::size_t k = 0; k < node.size(); ++k) {
        if (x == node[k]) {
            std::fill_n(result, node.size(), 0.0);
            result[k] = 1;
            return;
        }
        sum += result[k] = weight[k] / (x - node[k]);
    }
    for (std::size_t k = 0; k < node.size(); ++k) result[k] /= sum;
}

/// Scaled by a quarter of their width, for which products over Chebyshev's points neither grow nor vanish.
std::vector<double> barycentric_weights(std::span<const double> node)
{
    const double scale = 4 / (node.back() - node.front());
    std::vector<double> weight(node.size(), 1.0);
    for (std::size_t k = 0; k < node.size(); ++k)
        for (std::size_t j = 0; j < node.size(); ++j)
            if (j != k) weight[k] /= scale * (node[k] - node[j]);
    return weight;
}

std::vector<int> node_indices(std::span<const double> coordinate, int low, int high, int level)
{
    const int intervals = 1 << level;
    std::vector<int> index;
    if (high - low <= intervals) {
        for (int i = low; i <= high; ++i) index.push_back(i);
        return index;
    }
    const double middle = 0.5 * (coordinate[low] + coordinate[high]), half = 0.5 * (coordinate[high] - coordinate[low]);
    for (int k = 0; k <= intervals; ++k) {
        const double wanted = middle - half * std::cos(std::numbers::pi * k / intervals);
        const auto next = std::lower_bound(coordinate.begin() + low, coordinate.begin() + high, wanted);
        int i = static_cast<int>(next - coordinate.begin());
        if (i > low && wanted - coordinate[i - 1] < coordinate[i] - wanted) --i;
        if (k == 0) i = low;
        if (k == intervals) i = high;
        if (index.empty() || i > index.back()) index.push_back(i);
    }
    return index;
}

}  // namespace

bool LineNodes::is_node(int i) const
{
    return std::binary_search(index.begin(), index.end(), i);
}

bool resolves(int points, int level)
{
    constexpr double rounding = 1e-9;
    const int intervals = 1 << level;
    return (points - 1) * (1 - std::cos(std::numbers::pi / intervals)) / 2 > 1 - rounding;
}

LineNodes line_nodes(std::span<const double> coordinate, int low, int high, int level)
{
    LineNodes line{low, node_indices(coordinate, low, high, level), {}, {}};
    std::vector<double> node;
    for (const int i : line.index) node.push_back(coordinate[i]);
    const auto weight = barycentric_weights(node);
    line.cardinal.resize(static_cast<std::size_t>(high - low + 1) * node.size());
    for (int i = low; i <= high; ++i)
        cardinal_at(coordinate[i], node, weight, line.cardinal.data() + (i - low) * node.size());
    if (level == 0 || node.size() != (std::size_t{1} << level) + 1) return line;
    std::vector<double> every_other;
    for (std::size_t k = 0; k < node.size(); k += 2) every_other.push_back(node[k]);
    const auto fewer = barycentric_weights(every_other);
    for (std::size_t k = 1; k < node.size(); k += 2) {
        line.coarse.emplace_back(every_other.size());
        cardinal_at(node[k], every_other, fewer, line.coarse.back().data());
    }
    return line;
}

Interpolant::Interpolant(const Grid& grid, const Box& box, const std::array<int, dimensions>& level,
                         std::size_t quantities)
    : box_(box), quantities_(quantities)
{
    std::size_t nodes = 1;
    for (int d = 0; d < dimensions; ++d) {
        line_[d] = line_nodes(grid.coordinate[d], box.low[d], box.high[d], level[d]);
        nodes *= line_[d].count();
    }
    value_.resize(nodes * quantities);
}

bool Interpolant::is_node(const Index& i) const
{
    return line_[0].is_node(i[0]) && line_[1].is_node(i[1]) && line_[2].is_node(i[2]);
}

void Interpolant::contract(std::span<const double> weights, std::span<const double> from, std::span<double> to)
{
    const std::size_t size = to.size();
    for (std::size_t j = 0; j < size; ++j) to[j] = weights[0] * from[j];
    for (std::size_t k = 1; k < weights.size(); ++k)
        for (std::size_t j = 0; j < size; ++j) to[j] += weights[k] * from[k * size + j];
}

void Interpolant::at(const Index& i, std::span<double> point) const
{
    std::vector<double> plane(line_[1].count() * line_[2].count() * quantities_);
    std::vector<double> row(line_[2].count() * quantities_);
    contract(line_[0].weights(i[0]), value_, plane);
    contract(line_[1].weights(i[1]), plane, row);
    contract(line_[2].weights(i[2]), row, point);
}

double Interpolant::coarse_miss(int axis) const
{
    const auto& coarse = line_[axis].coarse;
    const std::size_t count = line_[axis].count();
    std::size_t inner = quantities_, outer = 1;  // the axes behind this one, and those before
    for (int d = axis + 1; d < dimensions; ++d) inner *= line_[d].count();
    for (int d = 0; d < axis; ++d) outer *= line_[d].count();
    double miss = 0;
    for (std::size_t between = 0; between < coarse.size(); ++between)
        for (std::size_t o = 0; o < outer; ++o)
            for (std::size_t j = 0; j < inner; ++j) {
                const double* column = value_.data() + o * count * inner + j;
                double value = -column[(2 * between + 1) * inner];
                for (std::size_t c = 0; c < coarse[between].size(); ++c)
                    value += coarse[between][c] * column[2 * c * inner];
                miss = std::max(miss, std::abs(value));
            }
    return miss;
}

}  // namespace stickslip::dense
