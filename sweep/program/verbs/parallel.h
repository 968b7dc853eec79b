// The cores of this machine for analyses that want work done side by side.
#pragma once
#include <cstddef>
#include <functional>
#include <memory>

namespace stickslip {

/// task(0) … task(n − 1) on all cores that the running ThreadLimit allows, begun in this order.
void parallel_for_each(std::size_t n, const std::function<void(std::size_t)>& task);

/// While it lives, at most so many threads work; 0: all cores.
class ThreadLimit {
  public:
    explicit ThreadLimit(int threads);
    ~ThreadLimit();

  private:
    struct Hidden;
    std::unique_ptr<Hidden> hidden_;
};

}  // namespace stickslip
