// Loops with delays as matrices that hold what is on its way at Chebyshev nodes.
#include <algorithm>
#include <cmath>

#include "analysis/loop/delay_nodes.h"
#include "analysis/loop/delayed_loop.h"
#include "analysis/loop/discrete_search.h"

namespace stickslip {
namespace {

using Complex = std::complex<double>;

void add_lines(const std::vector<DelayedFriction>& friction, std::vector<DelayLine>& lines)
{
    for (const auto& f : friction)
        for (const auto& d : f.delays) lines.push_back({d.weight * f.push, f.speed, d.time});
}

Eigen::RowVectorXd widened(const Eigen::RowVectorXd& row, Eigen::Index size)
{
    Eigen::RowVectorXd all = Eigen::RowVectorXd::Zero(size);
    all.head(row.size()) = row;
    return all;
}

}  // namespace

Eigen::MatrixXd delayed_matrix(const DelayedLoop& loop, double gain, int nodes)
{
    std::vector<DelayLine> lines{{loop.input, loop.held - gain * loop.output, loop.delay}};
    add_lines(loop.friction, lines);
    return with_nodes(loop.A, std::move(lines), nodes);
}

std::vector<Complex> rough_roots(const DelayedLoop& loop, double gain)
{
    constexpr double most_ticks = 20, most_memory = 12;  // ticks, of dead time and of friction
    constexpr int fewest_nodes = 6;
    constexpr std::size_t most_roots = 8;
    std::vector<Complex> found;
    if (!loop.ticked) return found;
    const auto& [plant, timing, base, turned] = *loop.ticked;
    double memory = 0;
    for (const auto& f : loop.friction) {
        if (!f.only_delays) return found;
        memory = std::max(memory, f.memory);
    }
    const double ticks = memory / timing.period;
    if (timing.delay > most_ticks * timing.period || ticks > most_memory) return found;
    // the fastest motion that ticks see turns by π a tick; as many nodes resolve it
    const int nodes = fewest_nodes + static_cast<int>(std::ceil(ticks));
    std::vector<DelayLine> lines;
    add_lines(loop.friction, lines);
    LoopPlant wide;
    wide.A = with_nodes(plant.A, std::move(lines), nodes);
    wide.B = widened(plant.B.transpose(), wide.A.rows()).transpose();
    wide.C = widened(plant.C, wide.A.rows());
    wide.C_v = widened(plant.C_v, wide.A.rows());
    const auto ticked = discrete_loop(wide, timing, base, turned);
    if (!ticked.closed(gain).allFinite()) return found;
    for (const Complex& z : multipliers(ticked, gain)) {
        const Complex s = std::log(z) / timing.period;
        if (found.size() == most_roots || !std::isfinite(std::abs(s))) break;
        if (s.imag() >= 0) found.push_back(s);
    }
    return found;
}

}  // namespace stickslip
