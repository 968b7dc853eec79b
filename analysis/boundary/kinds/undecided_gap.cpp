#include "analysis/boundary/kinds/undecided_gap.h"

#include <algorithm>
#include <cmath>

namespace stickslip {

SideGap closed_in(const std::function<double(double)>& side, SideGap gap, double side_of_low,
                  const std::function<double(double)>& width, int most)
{
    constexpr double share = 0.1;  // of what has no verdict
    constexpr int evaluations_at_most = 200;
    int without = 0;
    while (gap.evaluations < evaluations_at_most && without < most) {
        const bool open = gap.open_low == gap.open_low;
        const double below = (open ? gap.open_low : gap.high) - gap.low;
        const double above = gap.high - (open ? gap.open_high : gap.low);
        const double least = width(std::max(std::abs(gap.low), std::abs(gap.high)));
        if (gap.high - gap.low <= least) break;
        if (open && std::max(below, above) <= std::max(least, share * (gap.open_high - gap.open_low))) break;
        const double at = below >= above ? gap.low + 0.5 * below : gap.high - 0.5 * above;
        const double found = side(at);
        ++gap.evaluations;
        if (std::isnan(found)) {
            ++without;
            gap.open_low = open ? std::min(gap.open_low, at) : at;
            gap.open_high = open ? std::max(gap.open_high, at) : at;
            continue;
        }
        ((found < 0) == (side_of_low < 0) ? gap.low : gap.high) = at;
        // a change on one side of what has no verdict lies outside it
        if (open && (gap.low >= gap.open_high || gap.high <= gap.open_low)) gap.open_low = gap.open_high = missing;
    }
    return gap;
}

}  // namespace stickslip
