#include "sweep/program/verbs/still_searching.h"

#include "sweep/program/verbs/say.h"

namespace stickslip {

StillSearching::StillSearching(std::string less, std::chrono::milliseconds patience) : less_(std::move(less))
{
    clock_ = std::thread([this, patience] {
        std::unique_lock lock(mutex_);
        while (!end_) {
            ended_.wait_until(lock, stage_.empty() ? Clock::now() + patience : begun_ + patience);
            if (end_ || stage_.empty() || Clock::now() < begun_ + patience) continue;
            say("still searching: {} ({})\n", stage_, less_);
            std::fflush(stderr);
            stage_.clear();
        }
    });
}

StillSearching::~StillSearching()
{
    {
        const std::lock_guard lock(mutex_);
        end_ = true;
    }
    ended_.notify_all();
    clock_.join();
}

void StillSearching::stage(std::string what)
{
    const std::lock_guard lock(mutex_);
    stage_ = std::move(what);
    begun_ = Clock::now();
}

}  // namespace stickslip
