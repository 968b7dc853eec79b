// A motion cut into panes of equal length, and the sum of any run of them in a few additions.
#pragma once
#include "analysis/simulation/sampled/cycles/stretch.h"

#include <cstddef>
#include <vector>

namespace stickslip {

/// A slow motion has ten thousand panes and asks after each of them about runs of all lengths: runs of 2, 4, 8, …
/// neighbours are summed once, when the last of them is complete.
class Panes {
  public:
    void begin() { runs_.front().emplace_back(); }
    /// The newest pane; its sum counts in `sum` from `complete` on where runs are concerned.
    Stretch& newest() { return runs_.front().back(); }
    /// The newest pane is complete.
    void complete();

    std::size_t size() const { return runs_.front().size(); }
    const Stretch& operator[](std::size_t i) const { return runs_.front()[i]; }
    /// Of the panes from `first` to before `last`. All but a run of one are complete.
    Stretch sum(std::size_t first, std::size_t last) const;

  private:
    /// runs_[k][i]: the panes from i 2ᵏ to before (i + 1) 2ᵏ.
    std::vector<std::vector<Stretch>> runs_{1};
};

}  // namespace stickslip
