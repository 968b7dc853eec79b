#include "sweep/study/root_locus.h"

#include "analysis/boundary/trace/locate.h"
#include "analysis/stability/frequency_search.h"
#include "analysis/stability/linear_joint.h"
#include "analysis/stability/real_response.h"
#include "analysis/stability/steady.h"
#include "analysis/stability/study.h"
#include "sweep/study/samples.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

constexpr int locus_gains = 400, delayed_gains = 120;  // where roots have no end, each gain costs a search

/// Where a root lies that decides stability: those far to the left would squeeze the rest into a line.
double reach(const std::vector<std::vector<std::complex<double>>>& rows)
{
    double size = 0;
    for (const auto& row : rows) {
        const auto slowest =
            *std::max_element(row.begin(), row.end(), [](const auto& a, const auto& b) { return a.real() < b.real(); });
        size = std::max(size, std::abs(slowest));
    }
    return size;
}

// the longest step of a smooth line, per |s| of what is drawn
constexpr double longest = 0.004, longest_late = 0.02;

/// Of roots without end the rightmost are known, now more now less: as many as every row has.
std::size_t cut_to_shortest(RootLocus& locus)
{
    std::size_t least = locus.roots.front().size();
    for (const auto& row : locus.roots) least = std::min(least, row.size());
    for (auto& row : locus.roots) row.resize(least);
    return least;
}

/// Gains close enough that no visible branch is drawn with corners: where two roots meet they run apart like a square
/// root of the gain. False where no root is known.
bool sample(RootLocus& locus, const Joint& joint)
{
    const int rounds = locus.rational ? 10 : 3;
    const double step = locus.rational ? longest : longest_late;
    for (int round = 0;; ++round) {
        locus.roots = root_locus(joint, locus.gains);
        if (locus.roots.empty() || cut_to_shortest(locus) == 0) return false;
        if (round == 0) locus.limit = 1.2 * reach(locus.roots);
        std::vector<double> finer{locus.gains.front()};
        for (std::size_t i = 1; i < locus.gains.size(); ++i) {
            bool jumps = false;
            for (std::size_t k = 0; k < locus.roots[i].size(); ++k) {
                const auto a = locus.roots[i - 1][k], b = locus.roots[i][k];
                jumps =
                    jumps || (std::min(std::abs(a), std::abs(b)) < locus.limit && std::abs(a - b) > step * locus.limit);
            }
            if (jumps) finer.push_back(std::sqrt(locus.gains[i - 1] * locus.gains[i]));
            finer.push_back(locus.gains[i]);
        }
        if (round == rounds || finer.size() == locus.gains.size()) return true;
        locus.gains = std::move(finer);
    }
}

}  // namespace

std::optional<RootLocus> sampled_root_locus(const Joint& joint, double low, double high)
{
    const auto steady = steady_sliding(joint);
    if (steady.reason != Reason::none || !(low > 0)) return std::nullopt;
    RootLocus locus;
    locus.rational = loop_kind(joint) == LoopKind::sampled ||
                     (joint.dead_time() == 0 && linear_joint(joint, steady.slides_at).rational());
    locus.gains = log_steps(low, high, locus.rational ? locus_gains : delayed_gains);
    if (!sample(locus, joint)) return std::nullopt;
    locus.own_gain = joint.control.k_p;
    locus.own = root_locus(joint, {joint.control.k_p}).front();
    locus.crossings = locate_on_ray(joint, "control.k_p", low, high, true, Curve::Kind::state_variable);
    return locus;
}

std::vector<GainRoots> coarse_root_locus(const Joint& joint)
{
    const bool finite = (loop_kind(joint) == LoopKind::sampled && !many_dead_ticks(joint)) ||
                        (joint.dead_time() == 0 && linear_joint(joint, sliding_velocity(joint)).rational());
    // where roots have no end, each gain costs a search
    const int steps = finite ? 48 : search_effort() < 1 ? 2 : 8;
    std::vector<double> gains;
    for (int i = 0; i <= steps; ++i) gains.push_back(joint.control.k_p * std::pow(10, 4.0 * i / steps - 2));
    const auto rows = root_locus(joint, gains);
    if (rows.empty()) return {};
    std::vector<GainRoots> locus;
    for (std::size_t i = 0; i < gains.size(); ++i) locus.push_back({gains[i], rows[i]});
    return locus;
}

}  // namespace stickslip
