// Work that ends when a stop is requested.
#pragma once
#include "analysis/base/parallel_for.h"

#include <atomic>
#include <functional>

namespace stickslip {

/// A stop was requested.
struct Stopped {};

/// The same tasks, until a stop is requested: those not yet begun are then left out, and a Stop is thrown.
template <class Stop = Stopped>
ParallelFor until_interrupted(const std::atomic<bool>& interrupted, ParallelFor run)
{
    return [&interrupted, run = std::move(run)](std::size_t n, const std::function<void(std::size_t)>& task) {
        run(n, [&](std::size_t i) {
            if (!interrupted) task(i);
        });
        if (interrupted) throw Stop();
    };
}

}  // namespace stickslip
