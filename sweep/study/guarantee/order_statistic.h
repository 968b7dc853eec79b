// Split conformal prediction: the order statistic of calibration scores that covers a fresh score often enough, with a
// stated confidence. Vovk, "Conditional validity of inductive conformal predictors", Machine Learning 92, 2013.
#pragma once
#include <vector>

namespace stickslip::guarantee {

/// The smallest rank k, counted from 1, for which the k-th smallest of n exchangeable scores is at least as large as a
/// fresh one with probability `coverage`, with `confidence` over the draw of the n: the coverage of that rank has the
/// distribution Beta(k, n + 1 − k), so that the chance to fall short is P(Bin(n, coverage) ≥ k). 0 where even the
/// largest score is not enough. Ties only make it cover more; scores of strata with different distributions, drawn in
/// fixed shares, vary less than the binomial (Hoeffding 1956).
int rank_that_covers(int n, double coverage, double confidence);

/// The fewest scores for which there is such a rank: 59 for 0.95 with 0.95, since 0.95⁵⁹ ≤ 0.05 < 0.95⁵⁸.
int fewest_that_cover(double coverage, double confidence);

/// The score at that rank; infinite where there is none, so that nothing is excluded.
double score_that_covers(std::vector<double> scores, double coverage, double confidence);

}  // namespace stickslip::guarantee
