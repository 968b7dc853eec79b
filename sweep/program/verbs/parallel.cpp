#include "sweep/program/verbs/parallel.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

namespace stickslip {

struct ThreadLimit::Hidden {
    tbb::global_control control;
};

void parallel_for_each(std::size_t n, const std::function<void(std::size_t)>& task)
{
    tbb::parallel_for(std::size_t{0}, n, task);
}

ThreadLimit::ThreadLimit(int threads)
    : hidden_(threads > 0
                  ? new Hidden{{tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads)}}
                  : nullptr)
{
}

ThreadLimit::~ThreadLimit() = default;

}  // namespace stickslip
