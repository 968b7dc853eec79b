// Threads without a task of their own help with the predictions of those that have one: the last tasks of a round, and
// what is fitted between rounds, would else keep one core busy and leave the others idle.
#pragma once
#include "analysis/base/parallel_for.h"

#include <atomic>

namespace stickslip::gap {

/// Tasks of a round that have not begun. Where none is left, threads may be without work.
using Unbegun = std::atomic<std::size_t>;

/// While it lives, predictions of this thread may be shared with others, once no task is left to begin. What is
/// predicted does not depend on it.
class Helpers {
  public:
    /// Both have to outlive it; no counter: no task is waiting.
    explicit Helpers(const ParallelFor& run, const Unbegun* unbegun = nullptr);
    ~Helpers();
    Helpers(const Helpers&) = delete;
    Helpers& operator=(const Helpers&) = delete;

    /// What runs tasks for this thread, null where all others have work.
    static const ParallelFor* of_this_thread();

  private:
    const ParallelFor* run_;
    const Unbegun* unbegun_;
    const Helpers* before_;
};

}  // namespace stickslip::gap
