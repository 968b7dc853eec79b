#include "analysis/diagnosis/fit/moment.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace stickslip::gap {
namespace {

constexpr std::size_t moment = 5, enough = 4 * moment;  // blocks

double sum_of(const std::vector<double>& blocks, std::size_t from, std::size_t to)
{
    const auto begin = blocks.begin();
    return std::accumulate(begin + static_cast<std::ptrdiff_t>(from), begin + static_cast<std::ptrdiff_t>(to), 0.0);
}

/// What the log ratio of both mean squares loses without the moment in which the rival is worst beside the other.
double loss(const std::vector<double>& better, const std::vector<double>& rival, double least)
{
    if (better.size() != rival.size() || better.size() <= enough) return 0;
    const std::size_t n = better.size() - 1;  // the last block is a shorter one
    const auto log_ratio = [&](double r, double b, std::size_t blocks) {
        const auto count = static_cast<double>(blocks);
        return std::log(std::max(least, r / count)) - std::log(std::max(least, b / count));
    };
    const double all_better = sum_of(better, 0, n), all_rival = sum_of(rival, 0, n);
    double loudest = 0, moment_better = 0, moment_rival = 0;
    for (std::size_t first = 0; first + moment <= n; ++first) {
        const double b = sum_of(better, first, first + moment), r = sum_of(rival, first, first + moment);
        if (r - b > loudest) loudest = r - b, moment_better = b, moment_rival = r;
    }
    const double with = log_ratio(all_rival, all_better, n);
    const double without = log_ratio(all_rival - moment_rival, all_better - moment_better, n - moment);
    return std::clamp(with - without, 0.0, std::max(0.0, with));
}

}  // namespace

double hangs_on_a_moment(const std::array<Evaluation, levels.size()>& better,
                         const std::array<Evaluation, levels.size()>& rival, double least)
{
    double sum = 0, n = 0;
    for (std::size_t l = 0; l < levels.size(); ++l) {
        const auto &b = better[l].records, &r = rival[l].records;
        for (std::size_t i = 0; i < std::min(b.size(), r.size()); ++i) {
            sum += loss(b[i].position_blocks, r[i].position_blocks, least), n += 1;
            if (l == 0) sum += loss(b[i].effort_blocks, r[i].effort_blocks, least), n += 1;
        }
    }
    return n > 0 ? sum / n : 0;
}

}  // namespace stickslip::gap
