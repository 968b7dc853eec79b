#include "analysis/simulation/sampled/cycles/panes.h"

namespace stickslip {

void Panes::complete()
{
    for (std::size_t k = 0; runs_[k].size() % 2 == 0; ++k) {
        if (k + 1 == runs_.size()) runs_.emplace_back();
        Stretch pair = runs_[k].end()[-2];
        pair.add(runs_[k].back());
        runs_[k + 1].push_back(pair);
    }
}

Stretch Panes::sum(std::size_t first, std::size_t last) const
{
    Stretch sum;
    while (first < last) {
        // the longest run that begins here and ends in time
        std::size_t k = 0;
        while (k + 1 < runs_.size() && (first >> k) % 2 == 0 && first + (std::size_t{2} << k) <= last) ++k;
        sum.add(runs_[k][first >> k]);
        first += std::size_t{1} << k;
    }
    return sum;
}

}  // namespace stickslip
