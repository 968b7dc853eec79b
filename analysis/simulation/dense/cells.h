// A box of a map cut into cells, until in each all motions are of one kind and a polynomial runs through their numbers
// to within a bound that computed points check. Internal to analysis/simulation/dense.
#pragma once
#include "analysis/simulation/dense/survey.h"

#include <utility>
#include <vector>

namespace stickslip::dense {

class Cells {
  public:
    /// `bound`: of `difference`.
    Cells(Survey& survey, double bound);

    /// Fills all rows.
    void run();

  private:
    /// What looking at a cell came to.
    enum class Look { waits, closed };

    Look look(std::size_t number);
    Look refine(std::size_t number, const Interpolant& interpolant, bool missed);
    Look accept(std::size_t number, const Interpolant& interpolant, const Sheet& sheet, const Kind& kind, double error);
    Look split(std::size_t number, Axes axes);
    Look compute_all(std::size_t number);
    std::pair<Sheet, Interpolant> best_fit(const Cell& cell, const Kind& kind) const;
    bool pays(const Cell& cell) const;

    bool doubt_borders();
    void open_contradicted();
    void open_again(std::size_t number);

    Survey& survey_;
    double bound_;
    std::vector<Cell> cells_;
    std::vector<std::size_t> pending_;
    std::vector<std::uint32_t> owner_;                          ///< the cell that an interpolated point belongs to
    std::vector<std::pair<std::size_t, PointResult>> doubted_;  ///< interpolated rows that are to be computed, too
};

}  // namespace stickslip::dense
