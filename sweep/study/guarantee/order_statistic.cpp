#include "sweep/study/guarantee/order_statistic.h"

#include "sweep/study/binomial.h"

#include <algorithm>
#include <limits>

namespace stickslip::guarantee {

int rank_that_covers(int n, double coverage, double confidence)
{
    // the chance falls with k: the first rank that is safe enough lies between these
    int falls_short = 0, covers = n + 1;
    while (covers - falls_short > 1) {
        const int middle = falls_short + (covers - falls_short) / 2;
        (blind::chance_of_at_least(middle, n, coverage) <= 1 - confidence ? covers : falls_short) = middle;
    }
    return covers <= n ? covers : 0;
}

int fewest_that_cover(double coverage, double confidence)
{
    int n = 1;
    while (rank_that_covers(n, coverage, confidence) == 0) ++n;
    return n;
}

double score_that_covers(std::vector<double> scores, double coverage, double confidence)
{
    const int rank = rank_that_covers(static_cast<int>(scores.size()), coverage, confidence);
    if (rank == 0) return std::numeric_limits<double>::infinity();
    const auto at = scores.begin() + rank - 1;
    std::nth_element(scores.begin(), at, scores.end());
    return *at;
}

}  // namespace stickslip::guarantee
