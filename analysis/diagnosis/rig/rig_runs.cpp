// From a rig's records to runs in one direction each.
#include "analysis/diagnosis/policy/outcomes_and_rigs.h"
#include "analysis/diagnosis/rig/rig_laws.h"

#include "analysis/joint/joint.h"
#include "analysis/numerics/statistics.h"

#include <algorithm>
#include <cmath>

namespace stickslip::gap {
namespace {

constexpr std::size_t fewest = 100;  // rows of a run that are worth a level of their own
constexpr std::size_t most_rows = 6000;

/// Where the load point goes one way: first row and the row behind the last.
using Stretch = std::pair<std::size_t, std::size_t>;

std::vector<Stretch> stretches(const std::vector<double>& x)
{
    const auto [low, high] = std::minmax_element(x.begin(), x.end());
    const auto turned = policy::turned_of_rig * (*high - *low);
    std::vector<Stretch> all;
    std::size_t from = 0, extreme = 0;
    double side = 0;
    for (std::size_t k = 1; k <= x.size(); ++k) {
        const bool over = k == x.size();
        if (!over && side == 0 && std::abs(x[k] - x[from]) > turned) side = x[k] > x[from] ? 1 : -1, extreme = k;
        if (!over && side != 0 && side * (x[k] - x[extreme]) > 0) extreme = k;
        if (!over && (side == 0 || side * (x[extreme] - x[k]) <= turned)) continue;
        all.emplace_back(from, over ? x.size() : extreme + 1);
        from = extreme, side = 0;
    }
    return all;
}

/// Behind a turn the spring unloads and loads again before anything slides: the row at which the friction has come to
/// its median in the new direction.
std::size_t sliding_from(const std::vector<double>& friction, Stretch s)
{
    const auto at = [&](std::size_t k) { return friction.begin() + static_cast<std::ptrdiff_t>(k); };
    const double settled = median({at(s.first), at(s.second)});
    const bool rises = friction[s.first] < settled;
    std::size_t k = s.first;
    while (k + 1 < s.second && (friction[k] < settled) == rises) ++k;
    return k;
}

RigRun run_of(const Record& r, const std::vector<double>& x, Stretch s, std::size_t stride)
{
    RigRun run;
    run.from = s.first, run.to = s.second;
    for (std::size_t k = s.first; k < s.second; k += stride) {
        run.time.push_back(r.time[k] - r.time[s.first]);
        run.displacement.push_back(x[k] - x[s.first]);
        run.friction.push_back(r.effort_measured[k]);
        if (!r.normal_load.empty()) run.normal.push_back(r.normal_load[k]);
    }
    // a force changes its sign with the direction, a coefficient may be logged without one
    if (median(run.friction) < 0)
        for (auto& f : run.friction) f = -f;
    const std::size_t first = std::min(run.time.size() - 1, std::max<std::size_t>(2, run.time.size() / 50));
    run.start_speed = std::abs(run.displacement[first] / run.time[first]);
    return run;
}

/// The longest stretch of a record, and all others that are long enough.
std::vector<Stretch> worth_judging(const Record& r, const std::vector<double>& x)
{
    auto all = stretches(x);
    for (auto& s : all)
        if (s.first > 0) s.first = sliding_from(r.effort_measured, s);
    const auto length = [](const Stretch& s) { return s.second - s.first; };
    const auto longest = *std::ranges::max_element(all, {}, length);
    std::erase_if(all, [&](const Stretch& s) { return s != longest && length(s) < fewest; });
    return all;
}

/// Whether the normal load tells two runs from each other.
bool loads_differ(const std::vector<RigRun>& runs)
{
    double low = std::abs(runs.front().normal.empty() ? 0 : median(runs.front().normal)), high = low;
    for (const auto& run : runs) {
        if (run.normal.empty()) return false;
        const double load = std::abs(median(run.normal));
        low = std::min(low, load), high = std::max(high, load);
    }
    return high - low > policy::loads_of_rig_differ * high;
}

}  // namespace

std::size_t Rig::rows() const
{
    std::size_t rows = 0;
    for (const auto& run : runs) rows += run.time.size();
    return rows;
}

Rig rig_of(const std::vector<Record>& records)
{
    Rig rig;
    std::size_t rows = 0;
    std::vector<std::vector<Stretch>> parts;
    for (const auto& r : records) {
        parts.push_back(worth_judging(r, r.position.empty() ? r.reference_position : r.position));
        for (const auto& [from, to] : parts.back()) rows += to - from;
    }
    const std::size_t stride = std::max<std::size_t>(1, rows / most_rows);
    for (std::size_t i = 0; i < records.size(); ++i) {
        const auto& x = records[i].position.empty() ? records[i].reference_position : records[i].position;
        for (const auto& stretch : parts[i]) {
            rig.runs.push_back(run_of(records[i], x, stretch, stride));
            rig.runs.back().record = i;
        }
    }
    const bool one_level = loads_differ(rig.runs);
    double low = infinity, high = -infinity;
    for (auto& run : rig.runs) {
        run.level = one_level ? (run.displacement.back() < 0 ? 1 : 0) : rig.levels++;
        rig.travel = std::max(rig.travel, std::abs(run.displacement.back()));
        rig.duration = std::max(rig.duration, run.time.back());
        const auto [least, most] = std::ranges::minmax(run.friction);
        low = std::min(low, least), high = std::max(high, most);
        rig.range = std::max(rig.range, most - least);
    }
    // what levels of their own differ by is nothing that a law has to explain
    if (one_level) rig.levels = 2, rig.range = high - low;
    rig.speed = rig.runs.front().start_speed;
    return rig;
}

double rig_noise(const Rig& rig)
{
    constexpr std::size_t block = 100;
    std::vector<double> squares;
    for (const auto& run : rig.runs)
        for (std::size_t b = 0; b == 0 || b + block <= run.time.size(); b += block) {
            const std::size_t n = std::min(block, run.time.size() - b);
            double t = 0, f = 0, tt = 0, tf = 0, ff = 0;
            for (std::size_t k = b; k < b + n; ++k)
                t += run.time[k] / static_cast<double>(n), f += run.friction[k] / static_cast<double>(n);
            for (std::size_t k = b; k < b + n; ++k) {
                const double dt = run.time[k] - t, df = run.friction[k] - f;
                tt += dt * dt, tf += dt * df, ff += df * df;
            }
            squares.push_back((ff - (tt > 0 ? tf * tf / tt : 0)) / static_cast<double>(n - 2));
        }
    return std::sqrt(std::max(0.0, median(squares)));
}

}  // namespace stickslip::gap
