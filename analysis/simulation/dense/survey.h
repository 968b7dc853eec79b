// What is known of the points of a map, and what a cell of it shows. Internal to analysis/simulation/dense.
#pragma once
#include "analysis/simulation/dense/interpolant.h"
#include "analysis/simulation/dense/sheet.h"

#include <functional>
#include <span>
#include <vector>

namespace stickslip::dense {

/// Fills the rows of these points, whose linear fields stand.
using ComputeRows = std::function<void(std::span<const std::size_t> points)>;

/// A box and the level of its nodes along each axis.
struct Cell {
    Box box;
    std::array<int, dimensions> level{};
    bool closed = false;  ///< its rows are filled, or other cells have them
};

using Axes = std::array<bool, dimensions>;

class Survey {
  public:
    enum class State : std::uint8_t { open, wanted, computed, interpolated };

    /// `rows`: all points of the grid, linear fields filled.
    Survey(const Grid& grid, std::span<const Place> places, std::span<PointResult> rows, const ComputeRows& compute);

    const Grid& grid() const { return grid_; }
    State state(std::size_t point) const { return state_[point]; }
    const PointResult& row(std::size_t point) const { return rows_[point]; }
    const Place& place(std::size_t point) const { return places_[point]; }

    /// Whether a point is not computed yet; it will be.
    bool want(const Index& i);
    bool want_nodes(const Interpolant& nodes);
    bool want_checks(const Box& box, const Interpolant& interpolant);
    void compute_wanted();

    /// Fills an open point from a cell's functions; its row.
    const PointResult& interpolate(std::size_t point, const Sheet& sheet, std::span<const double> quantity,
                                   double error);
    void open_again(std::size_t point);

    /// Axes along which neighbours differ in what the linear theory says.
    Axes linear_borders(const Box& box) const;
    /// Axes along which neighbouring nodes differ in kind; all where only points between nodes differ.
    Axes kind_borders(const Interpolant& nodes) const;
    /// Whether all computed points of a box are of that kind.
    bool one_kind(const Box& box, const Kind& kind) const;

    Interpolant fit(const Cell& cell, const Sheet& sheet) const;
    /// The largest difference at all computed points of the box that are no nodes.
    double error_of(const Box& box, const Interpolant& interpolant, const Sheet& sheet) const;
    /// Whether a polynomial through the nodes has the linear theory's growth everywhere: where another mode becomes the
    /// slowest, or two meet, what follows from it has a kink that no check might meet.
    bool smooth_growth(const Cell& cell, double bound) const;

  private:
    const Grid& grid_;
    std::span<const Place> places_;
    std::span<PointResult> rows_;
    const ComputeRows& compute_;
    std::vector<State> state_;
    std::vector<Region> region_;  ///< of the linear theories
    std::vector<std::size_t> wanted_;
};

/// How many checks along an axis of so many points.
int checks(int points);

}  // namespace stickslip::dense
