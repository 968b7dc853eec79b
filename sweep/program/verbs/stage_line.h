// What a long answer is busy with: stage, how many of its tasks are done, seconds. On a terminal one line that changes,
// in a pipe or a log a new line every 30 s.
#pragma once
#include "analysis/diagnosis/search/attribute.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace stickslip {

class StageLine {
  public:
    StageLine();
    ~StageLine();
    StageLine(const StageLine&) = delete;
    StageLine& operator=(const StageLine&) = delete;

    /// Called at each stage. It must not be called once the line is gone.
    std::function<void(const std::string& stage, double done)> listener();
    /// The same tasks, counted.
    ParallelFor counted(ParallelFor run);

  private:
    void draw();

    bool terminal_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    std::mutex mutex_;
    std::condition_variable ended_;
    bool end_ = false;
    std::string stage_;
    double done_ = 0;
    std::atomic<std::size_t> tasks_{0}, finished_{0};
    std::thread clock_;
};

}  // namespace stickslip
