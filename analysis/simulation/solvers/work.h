// What one verdict may compute, counted in steps of its solvers: the same joint gets the same answer on every machine.
#pragma once
#include <cmath>

namespace stickslip {

/// Of all motions of one verdict together. A unit is 0.3 µs of a core of 2023 at 3 GHz, measured over random joints of
/// every model (tests/reliability/times.cpp).
class Work {
  public:
    explicit Work(double effort) : left_(usual * effort) {}
    void spend(double units) { left_ -= units; }
    bool spent() const { return left_ <= 0; }
    double left() const { return left_; }

    /// Of the usual, for loops that are followed tick by tick. Reason: a tick is a step at least, however slowly the
    /// loop moves, and noise leaves no turn that could be computed in place of being waited for. Evidence: on maps of
    /// four joints of 99 points each, 23 points were undecided at 1, of these 8 with fewer windows, and none at 4.
    static constexpr double for_ticks = 4;

    static constexpr double of_step(int equations) { return 2 + equations; }  ///< of CVODE or Rodas5P
    static constexpr double of_delayed_step(int equations) { return 2 * of_step(equations); }
    /// Within a tick: 0.45 µs of two equations, 2.4 µs of six, 4.4 µs of nine.
    static double of_driven_step(int equations) { return 0.55 * equations * std::sqrt(equations); }

  private:
    static constexpr double usual = 2e6;
    double left_;
};

}  // namespace stickslip
