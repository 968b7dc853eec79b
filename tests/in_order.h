// A ParallelFor for tests: one task after the other, on this thread.
#pragma once
#include "analysis/base/parallel_for.h"

#include <cstddef>
#include <functional>

namespace stickslip::test {

/// An object and no function: some answers keep a reference to what they were given.
inline const ParallelFor in_order = [](std::size_t count, const std::function<void(std::size_t)>& task) {
    for (std::size_t i = 0; i < count; ++i) task(i);
};

}  // namespace stickslip::test
