// The sampled controller of a record, exactly as INTERFACE §2 writes it.
#pragma once
#include "analysis/joint/joint.h"

#include <algorithm>
#include <array>

namespace stickslip::gap {

class Controller {
  public:
    explicit Controller(const Control& control)
        : c_(control), taps_(std::clamp(static_cast<int>(control.velocity_estimate.average), 1, max_taps))
    {
    }

    /// Forgets what it has read.
    void restart() { count_ = 0, velocity_ = 0; }
    /// A new reading, one step after the last. `exact` is used where the estimate is the exact velocity.
    void read(double position, double step, double exact)
    {
        position_ = position;
        const double before = average();
        if (count_ == 0) window_.fill(position);
        window_[static_cast<std::size_t>(count_++ % taps_)] = position;
        if (c_.velocity_estimate.form == EstimateForm::exact)
            velocity_ = exact;
        else if (count_ > 1)
            velocity_ += step / (c_.velocity_estimate.tau + step) * ((average() - before) / step - velocity_);
    }
    /// Takes a logged estimate in place of the controller's own.
    void believe(double velocity) { velocity_ = velocity; }
    double velocity() const { return velocity_; }
    /// `added`: what the record says was added to the controller's own, a feed-forward.
    double unlimited(double reference, double reference_rate, double added = 0) const
    {
        const double rate_error = (c_.reference_velocity ? reference_rate : 0) - velocity_;
        return c_.k_p * (reference - position_) + (c_.k_v != 0 ? c_.k_v * rate_error : 0) + added;
    }
    double command(double reference, double reference_rate, double added = 0) const
    {
        return std::clamp(unlimited(reference, reference_rate, added), -c_.effort_limit, c_.effort_limit);
    }

  private:
    static constexpr int max_taps = 16;
    double average() const
    {
        double sum = 0;
        for (int i = 0; i < taps_; ++i) sum += window_[static_cast<std::size_t>(i)];
        return sum / taps_;
    }
    const Control& c_;
    int taps_, count_ = 0;
    std::array<double, max_taps> window_{};
    double position_ = 0, velocity_ = 0;
};

}  // namespace stickslip::gap
