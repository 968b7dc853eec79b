// What a long answer is busy with: stage, how many of its tasks are done, seconds, and about how many are left. On a
// terminal one line that changes, in a pipe or a log a new line every 30 s.
#pragma once
#include "analysis/base/field.h"
#include "analysis/diagnosis/search/attribute.h"
#include "analysis/results/diagnosis_stage.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace stickslip {

/// How to have an answer sooner than with this effort.
std::string searches_less(double effort);

class StageLine {
  public:
    using Interval = std::chrono::milliseconds;

    /// Nothing is said before `patience`, where not set half a second at a terminal and 30 s elsewhere. `shorter` is
    /// how to have an answer sooner, as "--effort 0.1 searches less".
    explicit StageLine(std::string shorter = "", std::optional<Interval> patience = {});
    ~StageLine();
    StageLine(const StageLine&) = delete;
    StageLine& operator=(const StageLine&) = delete;

    /// `done`: the part of the whole that lies behind, where that is known.
    void stage(std::string what, double done = not_set);
    /// The same of a diagnosis, its stages in words behind `about`. It must not be called once the line is gone.
    StageProgress listener(std::string about = "");
    /// The same tasks, counted.
    ParallelFor counted(ParallelFor run);

  private:
    void draw();

    std::string shorter_;
    bool terminal_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    std::chrono::steady_clock::time_point began_ = start_;  ///< the work that `done_` is a part of
    std::mutex mutex_;
    std::condition_variable ended_;
    bool end_ = false, drawn_ = false;
    std::string stage_;
    double done_ = not_set;
    std::atomic<std::size_t> tasks_{0}, finished_{0};
    std::thread clock_;
};

}  // namespace stickslip
