// How far a long piece of work has come, reported now and then.
#pragma once
#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <mutex>

namespace stickslip {

/// Points to do in all, and what of them a former run has done.
struct Workload {
    std::uint64_t total = 0, done = 0;
};

struct Progress {
    enum class Stage { computing, writing_results };
    std::uint64_t done = 0, total = 0;  ///< points of this process's share, resumed ones included
    double rate = 0;                    ///< points/s of this run
    double seconds_left = 0;            ///< infinite until something is known
    Stage stage = Stage::computing;
};

/// Called from any thread, never from two at once.
using TellProgress = std::function<void(const Progress&)>;

/// Counts points from any number of threads and reports at most every `seconds`; the end is always reported. Without a
/// function to tell it to, it only counts.
class ProgressMeter {
  public:
    ProgressMeter(Progress::Stage stage, Workload workload, TellProgress tell, double seconds)
        : stage_(stage), workload_(workload), tell_(std::move(tell)), pause_(seconds)
    {
    }

    void add(std::uint64_t points);
    void end();

    std::uint64_t added() const { return added_.load(std::memory_order_relaxed); }
    double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

  private:
    void tell();

    const Progress::Stage stage_;
    const Workload workload_;
    const TellProgress tell_;
    const double pause_;
    const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    std::atomic<std::uint64_t> added_{0};
    std::mutex mutex_;  ///< guards the time below and the calls
    double next_ = 0;
};

}  // namespace stickslip
