#include "sweep/program/verbs/parallel.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <atomic>

namespace stickslip {

struct ThreadLimit::Hidden {
    tbb::global_control control;
};

void parallel_for_each(std::size_t n, const std::function<void(std::size_t)>& task)
{
    // oneTBB would give each thread a part of the row: then what was put first, because it takes longest, would all be
    // one thread's
    std::atomic<std::size_t> next{0};
    tbb::parallel_for(
        std::size_t{0}, n, [&](std::size_t) { task(next++); }, tbb::simple_partitioner());
}

ThreadLimit::ThreadLimit(int threads)
    : hidden_(threads > 0
                  ? new Hidden{{tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads)}}
                  : nullptr)
{
}

ThreadLimit::~ThreadLimit() = default;

}  // namespace stickslip
