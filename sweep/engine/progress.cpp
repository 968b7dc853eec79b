#include "sweep/engine/progress.h"

#include <limits>

namespace stickslip {

void ProgressMeter::add(std::uint64_t points)
{
    added_.fetch_add(points, std::memory_order_relaxed);
    if (!tell_) return;
    const std::unique_lock lock(mutex_, std::try_to_lock);  // a thread that comes while another reports need not wait
    if (!lock || seconds() < next_) return;
    next_ = seconds() + pause_;
    tell();
}

void ProgressMeter::end()
{
    if (!tell_) return;
    const std::scoped_lock lock(mutex_);
    tell();
}

void ProgressMeter::tell()
{
    Progress progress{workload_.done + added(), workload_.total, 0, std::numeric_limits<double>::infinity(), stage_};
    const double elapsed = seconds();
    if (elapsed > 0) progress.rate = static_cast<double>(added()) / elapsed;
    if (progress.rate > 0) progress.seconds_left = static_cast<double>(progress.total - progress.done) / progress.rate;
    tell_(progress);
}

}  // namespace stickslip
