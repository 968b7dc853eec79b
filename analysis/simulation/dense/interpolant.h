// Polynomials in several variables through points of a grid: along each axis the grid's values nearest to Chebyshev's
// points carry one polynomial, so that every node is a point of the map. Internal to analysis/simulation/dense.
#pragma once
#include "analysis/simulation/dense/grid_box.h"

#include <span>

namespace stickslip::dense {

/// Nodes along one axis between two indices, ends included, and what they weigh.
struct LineNodes {
    int low = 0;                   ///< index of the first point
    std::vector<int> index;        ///< of the nodes, ascending
    std::vector<double> cardinal;  ///< row by row, one a point from the first to the last node: weight of each node
    std::vector<std::vector<double>> coarse;  ///< of the nodes of the level below, at each node between them

    std::size_t count() const { return index.size(); }
    std::span<const double> weights(int i) const { return {cardinal.data() + (i - low) * count(), count()}; }
    bool is_node(int i) const;
};

/// 2^level + 1 nodes; all points where there are no more. Nodes of a level are nodes of the next.
LineNodes line_nodes(std::span<const double> coordinate, int low, int high, int level);

/// Whether a level has more nodes than the one below, as far apart as Chebyshev's points need.
bool resolves(int points, int level);

/// Values of several quantities at the nodes of a box, and everywhere between.
class Interpolant {
  public:
    Interpolant(const Grid& grid, const Box& box, const std::array<int, dimensions>& level, std::size_t quantities);

    const LineNodes& line(int axis) const { return line_[axis]; }
    bool is_node(const Index& i) const;

    /// Calls visit(index) for each node, in the order of the grid.
    template <class Visit>
    void for_each_node(Visit visit) const
    {
        for (const int a : line_[0].index)
            for (const int b : line_[1].index)
                for (const int c : line_[2].index) visit(Index{a, b, c});
    }

    /// Calls fill(index, quantities) for each node, to be given there.
    template <class Fill>
    void fill(Fill fill)
    {
        std::size_t at = 0;
        for_each_node([&](const Index& i) {
            fill(i, std::span<double>(value_.data() + at, quantities_));
            at += quantities_;
        });
    }

    /// Calls visit(index, quantities) for every point of the box, in the order of the grid.
    template <class Visit>
    void for_each_point(Visit visit) const
    {
        std::vector<double> plane(line_[1].count() * line_[2].count() * quantities_);
        std::vector<double> row(line_[2].count() * quantities_), point(quantities_);
        Index i;
        for (i[0] = box_.low[0]; i[0] <= box_.high[0]; ++i[0]) {
            contract(line_[0].weights(i[0]), value_, plane);
            for (i[1] = box_.low[1]; i[1] <= box_.high[1]; ++i[1]) {
                contract(line_[1].weights(i[1]), plane, row);
                for (i[2] = box_.low[2]; i[2] <= box_.high[2]; ++i[2]) {
                    contract(line_[2].weights(i[2]), row, point);
                    visit(i, std::span<const double>(point));
                }
            }
        }
    }

    /// The quantities at one point of the box.
    void at(const Index& i, std::span<double> point) const;

    /// How far, at most, the polynomial through every other node along an axis misses the nodes between; 0 for an axis
    /// without such nodes. The polynomial through all nodes misses by about the square of it.
    double coarse_miss(int axis) const;

  private:
    static void contract(std::span<const double> weights, std::span<const double> from, std::span<double> to);

    Box box_;
    std::size_t quantities_;
    std::array<LineNodes, dimensions> line_;
    std::vector<double> value_;
};

}  // namespace stickslip::dense
