#include "analysis/gap/moment.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace stickslip::gap {
namespace {

constexpr std::size_t moment = 5;  // blocks
constexpr double least = 1e-12;    // of the floor: what stood still has no logarithm

double log_ratio(double rival, double better)
{
    return std::log(std::max(least, rival)) - std::log(std::max(least, better));
}

/// What the log ratio of both sums loses without the moment in which the rival is worst beside the other.
double loss(const std::vector<double>& better, const std::vector<double>& rival)
{
    if (better.size() != rival.size() || better.size() <= moment) return 0;
    const double all_better = std::accumulate(better.begin(), better.end(), 0.0),
                 all_rival = std::accumulate(rival.begin(), rival.end(), 0.0);
    double loudest = 0, without_better = all_better, without_rival = all_rival;
    for (std::size_t first = 0; first + moment <= better.size(); ++first) {
        const auto sum = [&](const std::vector<double>& blocks) {
            const auto from = blocks.begin() + static_cast<std::ptrdiff_t>(first);
            return std::accumulate(from, from + moment, 0.0);
        };
        const double b = sum(better), r = sum(rival);
        if (r - b > loudest) loudest = r - b, without_better = all_better - b, without_rival = all_rival - r;
    }
    return std::max(0.0, log_ratio(all_rival, all_better) - log_ratio(without_rival, without_better));
}

}  // namespace

double hangs_on_a_moment(const std::array<Evaluation, levels.size()>& better,
                         const std::array<Evaluation, levels.size()>& rival)
{
    double sum = 0, n = 0;
    for (std::size_t l = 0; l < levels.size(); ++l) {
        const auto &b = better[l].records, &r = rival[l].records;
        for (std::size_t i = 0; i < std::min(b.size(), r.size()); ++i) {
            sum += loss(b[i].position_blocks, r[i].position_blocks), n += 1;
            if (l == 0) sum += loss(b[i].effort_blocks, r[i].effort_blocks), n += 1;
        }
    }
    return n > 0 ? sum / n : 0;
}

}  // namespace stickslip::gap
