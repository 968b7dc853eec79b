// A rectangular grid of results laid over a chart: which nodes surround a place, and with what weight.
#pragma once
#include "render/axes/scale.h"

#include <array>
#include <utility>
#include <vector>

namespace stickslip::drawing {

class Grid {
  public:
    /// Throws std::invalid_argument unless both axes hold ascending values that fit their scales.
    Grid(const Axis& x, const Scale& x_scale, const Axis& y, const Scale& y_scale);

    struct Place {
        std::array<std::size_t, 4> node;  ///< lower left, lower right, upper left, upper right
        std::array<double, 4> weight;     ///< bilinear in chart positions, sums to 1
        std::size_t nearest() const;
    };
    /// `across` and `up` in [0, 1] from the lower left corner of the chart.
    Place at(double across, double up) const;

    /// Where a node lies, as `at` takes it.
    std::pair<double, double> position(std::size_t node) const
    {
        return {columns_[node % columns_.size()], rows_[node / columns_.size()]};
    }

    std::size_t size() const { return columns_.size() * rows_.size(); }

  private:
    std::vector<double> columns_, rows_;  // chart positions of the nodes
};

}  // namespace stickslip::drawing
