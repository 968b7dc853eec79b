// The controller of a loop, tick by tick, as the joint describes it. It counts positions in the frame of the motion, so
// that a joint that slides steadily is at rest in it.
#pragma once
#include "analysis/joint/joint.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace stickslip {

class LoopController {
  public:
    /// `frame` is the frame's velocity as the encoder reads it. Without a period the loop is continuous, and ticks are
    /// steps of its integration: the velocity is the true one behind the filter, by the trapezoidal rule, and the
    /// output is that of the middle of the step, extrapolated, so that both are right to second order.
    LoopController(const Control& control, double frame);

    /// All that it remembers from tick to tick.
    struct State {
        std::vector<double> window;  ///< the last readings, oldest first
        double velocity = 0, reading = 0;
        double before = 0, output = 0;  ///< continuous loop: the velocity and the output of the tick before
        bool fresh = true;  ///< has read nothing yet
    };
    State state;

    /// As after reading this position for ever in the moving frame.
    void begin(double reading, double output);
    /// A new reading, `step` after the last. `exact` is the true velocity, used where the estimate is exact.
    void read(double reading, double step, double exact);
    /// The output for a reference in the frame; `rate` is its velocity, not counted in the frame, `added` a feed-forward.
    double command(double reference, double rate, double added);
    bool continuous() const { return !is_set(control_.period); }
    /// The reading in the frame, with the reference at 0, at which it gives this output in steady sliding.
    double steady_reading(double output) const;

  private:
    double mean() const
    {
        double sum = 0;
        for (double x : state.window) sum += x;
        return sum / static_cast<double>(state.window.size());
    }
    const Control control_;
    double frame_;
};

}  // namespace stickslip
