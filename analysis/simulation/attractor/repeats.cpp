#include "analysis/simulation/attractor/repeats.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

constexpr double slowest_closing = 0.999;  ///< largest ratio of successive gaps that still counts as closing
constexpr double clear_ratio = 0.5;        ///< of successive gaps: a few of them suffice below it
constexpr double lasting = 0.9;            ///< gap of neighbours, per the same some rounds before
constexpr double distinct = 10;            ///< of neighbours that differ, per what closed turns may
constexpr double wandering = 2;            ///< gaps that many rounds of mere noise add up to at most
constexpr int most_rounds = 16;
constexpr double least_turn = 0.1;  ///< range of position, per largest, of a turn that counts
constexpr double as_long = 0.5;     ///< per the shortest of those: a smaller turn that takes as long is none that rings

/// Turns that are to differ keep their difference, in every part of their repeat; those that close in alternating lose
/// it.
bool repeats_no_sooner(int m, int count, const std::function<double(int, int)>& gap, double allowed)
{
    for (int part = 1; part < m; ++part) {
        if (m % part != 0) continue;
        const int repeats = std::clamp((count - 1 - part) / m, 1, std::max(1, most_rounds / m));
        const int before = count - 1 - repeats * m;
        const double differ = gap(count - 1, count - 1 - part);
        if (!(differ > lasting * gap(before, before - part) && differ > distinct * allowed)) return false;
    }
    return true;
}

}  // namespace

int turns_to_repeat(int count, const std::function<double(int, int)>& gap, double allowed)
{
    for (int m = 1; m <= longest_repeat && 2 * m < count; ++m) {
        double largest = 0;
        for (int i = 0; i < m; ++i) largest = std::max(largest, gap(count - 1 - i, count - 1 - i - m));
        // over several rounds, as a single ratio of gaps that creep is mostly noise
        const int rounds = std::min(most_rounds, (count - 1) / m - 1);
        const double before = gap(count - 1 - rounds * m, count - 1 - (rounds + 1) * m);
        double ratio = largest > 0 ? std::min(std::pow(largest / before, 1.0 / rounds), slowest_closing) : 0;
        const bool few = rounds < most_rounds / 2;
        if (ratio > clear_ratio && few) ratio = slowest_closing;
        // gaps that do not add up are the integrator's own: they will not shrink, and nothing is to come of them
        const double moved = gap(count - 1, count - 1 - rounds * m);
        const bool noise = !few && moved < wandering * largest;
        const double rest = noise ? std::max(largest, moved) : m > 1 && few ? largest : largest / (1 - ratio);
        if (rest <= allowed && repeats_no_sooner(m, count, gap, allowed)) return m;
    }
    return 0;
}

int turns_to_repeat_nearly(int count, const std::function<double(int, int)>& gap, double size)
{
    for (const double share : {1e-5, 1e-4, 1e-3})
        if (const int m = turns_to_repeat(count, gap, share * size); m > 0) return m;
    return 0;
}

int nearest_return(int count, const std::function<double(int, int)>& gap, double allowed)
{
    for (int m = 1; m <= longest_repeat && m < count; ++m)
        if (gap(count - 1, count - 1 - m) < allowed) return m;
    return 0;
}

Turn merged(const std::deque<Turn>& turns, int newest)
{
    Turn all = turns.back();
    all.rest_time = 0;
    for (int i = 0; i < newest; ++i) {
        const Turn& t = turns[turns.size() - 1 - static_cast<std::size_t>(i)];
        all.t0 = t.t0;
        all.velocity_min = std::min(all.velocity_min, t.velocity_min);
        all.velocity_max = std::max(all.velocity_max, t.velocity_max);
        all.position_min = std::min(all.position_min, t.position_min);
        all.position_max = std::max(all.position_max, t.position_max);
        all.rest_time += t.rest_time;
        all.reversed = all.reversed || t.reversed;
    }
    return all;
}

int full_turns(const std::deque<Turn>& turns, int newest)
{
    const Turn all = merged(turns, newest);
    const double least = least_turn * (all.position_max - all.position_min);
    const auto large = [&](const Turn& t) { return t.position_max - t.position_min > least; };
    double shortest = infinity;
    for (auto t = turns.end() - newest; t != turns.end(); ++t)
        if (large(*t)) shortest = std::min(shortest, t->period());
    return static_cast<int>(std::count_if(turns.end() - newest, turns.end(),
                                          [&](const Turn& t) { return large(t) || t.period() > as_long * shortest; }));
}

bool grows_and_shrinks(const std::vector<double>& sizes)
{
    int grew = 0, shrank = 0;
    for (std::size_t i = 1; i < sizes.size(); ++i) ++(sizes[i] > sizes[i - 1] ? grew : shrank);
    return grew > 0 && shrank > 0;
}

}  // namespace stickslip
