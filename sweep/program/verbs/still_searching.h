// What an answer that takes longer than a second is busy with.
#pragma once
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace stickslip {

/// Says to standard error what is searched for, once a stage has lasted longer than `patience`.
class StillSearching {
  public:
    /// `less`: how the search is cut short, as "--effort 0.1 searches less".
    explicit StillSearching(std::string less, std::chrono::milliseconds patience = std::chrono::seconds(1));
    ~StillSearching();
    StillSearching(const StillSearching&) = delete;
    StillSearching& operator=(const StillSearching&) = delete;

    void stage(std::string what);

  private:
    using Clock = std::chrono::steady_clock;

    std::string less_;
    std::mutex mutex_;
    std::condition_variable ended_;
    bool end_ = false;
    std::string stage_;  ///< empty where it is told already
    Clock::time_point begun_;
    std::thread clock_;
};

}  // namespace stickslip
