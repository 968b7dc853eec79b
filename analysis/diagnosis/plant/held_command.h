// The held command as the actuator sees it after the dead time, averaged over a substep.
#pragma once
#include "analysis/diagnosis/records/ticks.h"

#include <span>

namespace stickslip::gap {

class HeldCommand {
  public:
    HeldCommand() = default;
    /// From this tick on.
    HeldCommand(const Ticks& ticks, std::span<const double> command, double dead_time, std::size_t tick)
        : time_(ticks.time.data()),
          size_(ticks.time.size()),
          command_(command.data()),
          dead_time_(dead_time),
          straight_(ticks.straight_command),
          moves_(!ticks.at_rest)
    {
        if (dead_time_ == 0 && !straight_) return;
        const double from = time_[tick] - dead_time_;
        for (next_ = tick + 1; next_ > 0 && time_[next_ - 1] > from;) --next_;
    }

    /// Mean over [t, t + h]; before the first tick the command was zero, or, of a record that begins in motion, what it
    /// is at the first. `now` is the tick that holds t.
    double mean(double t, double h, std::size_t now)
    {
        if (straight_) return at(t - dead_time_ + 0.5 * h);
        if (dead_time_ == 0) return command_[now];
        const double from = t - dead_time_, to = from + h;
        while (next_ < size_ && next_ <= now && time_[next_] <= from) ++next_;
        const double held = next_ > 0 ? command_[next_ - 1] : before();
        if (next_ > now || time_[next_] >= to) return held;
        const double share = (time_[next_] - from) / h;
        return share * held + (1 - share) * command_[next_];
    }

  private:
    double before() const { return moves_ ? command_[0] : 0; }
    /// Straight from tick to tick.
    double at(double t)
    {
        while (next_ < size_ && time_[next_] <= t) ++next_;
        if (next_ == 0) return before();
        if (next_ == size_) return command_[size_ - 1];
        const double share = (t - time_[next_ - 1]) / (time_[next_] - time_[next_ - 1]);
        return command_[next_ - 1] + share * (command_[next_] - command_[next_ - 1]);
    }

    const double* time_ = nullptr;
    std::size_t size_ = 0;
    const double* command_ = nullptr;
    double dead_time_ = 0;
    bool straight_ = false, moves_ = false;
    std::size_t next_ = 0;  ///< first tick whose command has not yet reached the actuator
};

}  // namespace stickslip::gap
