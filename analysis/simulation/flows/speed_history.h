// The velocity of a body over the last moments, as the solver's own continuous steps.
#pragma once
#include <array>
#include <complex>
#include <deque>

namespace stickslip {

class SpeedHistory {
  public:
    /// A step from `from` to `to`: the velocity at both ends and at its quarters. Exact for methods whose continuous
    /// output has degree 4.
    struct Step {
        double from, to;
        std::array<double, 5> velocity;
    };
    /// Forgets everything and starts after motion at this velocity for ever.
    void start(double velocity_before) { before_ = velocity_before, steps_.clear(); }
    void append(const Step& step, double forget_before);
    /// All velocities become before + by (V − before).
    void scale(double by);

    struct Speed {
        double value, slope;
    };
    /// At an instant, out of the steps that have begun by `pick`: where the velocity has a kink, an instant beside it
    /// says from which side it is meant.
    Speed at(double instant, double pick) const;
    double velocity_before() const { return before_; }

    /// ∫ e^{−s(ξ + τ − now)} (V(ξ) − V_before) dξ over now − τ … now: what the last lag τ adds to the projection of a
    /// motion on the mode s.
    std::complex<double> memory(std::complex<double> s, double lag, double now) const;

  private:
    double before_ = 0;
    std::deque<Step> steps_;
};

}  // namespace stickslip
