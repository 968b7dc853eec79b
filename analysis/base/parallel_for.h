// Work in parallel: the caller of an analysis supplies the threads.
#pragma once
#include <cstddef>
#include <functional>

namespace stickslip {

/// Runs task(0) … task(n − 1) in any order, possibly in parallel; returns when all are done. Every task writes its own
/// slot, so that the answer is the same for any number of threads.
using ParallelFor = std::function<void(std::size_t n, const std::function<void(std::size_t)>& task)>;

}  // namespace stickslip
