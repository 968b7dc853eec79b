// A delayed loop opened at its command, at any s: what every search over it asks.
#pragma once
#include "analysis/loop/delayed_loop.h"
#include "analysis/loop/resolvent.h"
#include "analysis/loop/ticked_share.h"

namespace stickslip {

class OpenedLoop {
  public:
    using Complex = std::complex<double>;
    explicit OpenedLoop(const DelayedLoop& loop);

    /// output (…)⁻¹ input and held (…)⁻¹ input, without dead time.
    std::pair<Complex, Complex> prompt(Complex s) const;
    Complex delayed(Complex s) const { return std::exp(-s * delay_); }
    /// 1 + L(s) and its derivative, all gains closed.
    Response closing(double gain, Complex s) const;
    /// −T of the turned gain, the base closed: a positive real number where a positive gain puts a root at s.
    Complex towards(Complex s) const;

    /// What one place costs, per one of a loop without delayed friction.
    double cost() const { return ticked_share_ ? ticked_share_->cost() : 1; }

    /// Up to where the imaginary axis is looked at: half the sampling rate, or without end.
    double end() const { return end_; }
    /// Over which the phase turns by one radian without anything else in the loop.
    double turns_in() const { return turns_in_; }
    /// The poles of what is no delayed friction.
    const std::vector<Complex>& poles() const { return poles_; }
    /// Those that are poles of the whole opened loop, too.
    const std::vector<Complex>& exact_poles() const { return exact_poles_; }
    /// How many poles of the opened loop lie right of Re s = σ. Those at 0, within rounding, count as `at_zero`.
    struct Right {
        int poles = 0;
        bool at_zero = false;
        double size = 0;
    };
    std::optional<Right> right_of(double sigma) const;
    /// How far s is from the nearest pole: no wider step sees what happens there.
    double room(Complex s) const;

  private:
    Complex variable(Complex s) const;
    std::pair<Complex, Complex> delayed_share(Complex s) const;
    bool has_delayed_friction() const { return share_ || ticked_share_; }

    double delay_, period_, end_, turns_in_;
    Resolvent responses_;
    std::vector<Complex> poles_, exact_poles_;
    std::function<std::optional<int>(double)> mechanism_right_of_;
    std::vector<double> other_poles_;
    std::optional<DelayedShare> share_;        ///< of a continuous loop
    std::optional<TickedShare> ticked_share_;  ///< of a sampled one
};

}  // namespace stickslip
