// As many threads as the machine has, for whatever asks for a stickslip::ParallelFor.
#pragma once
#include <stickslip/parallel_for.h>

#include <atomic>
#include <thread>
#include <vector>

inline void side_by_side(std::size_t n, const std::function<void(std::size_t)>& task)
{
    std::atomic<std::size_t> next = 0;
    std::vector<std::jthread> threads;
    for (unsigned i = 0; i < std::max(1u, std::thread::hardware_concurrency()); ++i)
        threads.emplace_back([&] {
            for (std::size_t k; (k = next++) < n;) task(k);
        });
}
