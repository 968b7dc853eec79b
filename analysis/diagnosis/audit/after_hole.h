// Rows behind a hole in a log, or at the start of one that starts in motion, in which a filter of the readings still
// remembers what nobody saw.
#pragma once
#include "analysis/diagnosis/records/ticks.h"

#include <algorithm>

namespace stickslip::gap {

class AfterHole {
  public:
    /// A logged velocity knows what was in the hole.
    AfterHole(const Ticks& ticks, const Control& control)
        : ticks_(ticks),
          matters_(ticks.lost && !ticks.has_velocity),
          memory_(forgotten * control.velocity_estimate.tau + (control.velocity_estimate.average + 1) * ticks.step[0])
    {
        if (!ticks.at_rest && !ticks.velocity_believed())
            until_ = ticks.time.front() + std::min(memory_, most_of_record * ticks.duration());
    }

    /// Whether the estimate of the velocity at tick k goes back to a reading that was not logged; evaluated tick by
    /// tick.
    bool holds(std::size_t k)
    {
        if (matters_ && ticks_.of_a_row(k) && !ticks_.logged[k]) until_ = ticks_.time[k] + memory_;
        return ticks_.time[k] <= until_;
    }

  private:
    static constexpr double forgotten = 15;         // numerical: time constants: e⁻¹⁵ of a reading is left
    static constexpr double most_of_record = 0.25;  // numerical: for the start: slower filters are looked at, too
    const Ticks& ticks_;
    bool matters_;
    double memory_, until_ = -infinity;
};

}  // namespace stickslip::gap
