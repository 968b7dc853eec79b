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
        : time_(ticks.time.data()), size_(ticks.time.size()), command_(command.data()), dead_time_(dead_time)
    {
        if (dead_time_ == 0) return;
        const double from = time_[tick] - dead_time_;
        for (next_ = tick + 1; next_ > 0 && time_[next_ - 1] > from;) --next_;
    }

    /// Mean over [t, t + h]; before the first tick the command was zero. `now` is the tick that holds t.
    double mean(double t, double h, std::size_t now)
    {
        if (dead_time_ == 0) return command_[now];
        const double from = t - dead_time_, to = from + h;
        while (next_ < size_ && next_ <= now && time_[next_] <= from) ++next_;
        const double held = next_ == 0 ? 0 : command_[next_ - 1];
        if (next_ > now || time_[next_] >= to) return held;
        const double share = (time_[next_] - from) / h;
        return share * held + (1 - share) * command_[next_];
    }

  private:
    const double* time_ = nullptr;
    std::size_t size_ = 0;
    const double* command_ = nullptr;
    double dead_time_ = 0;
    std::size_t next_ = 0;  ///< first tick whose command has not yet reached the actuator
};

}  // namespace stickslip::gap
