#include "sweep/study/map_motions.h"

#include "analysis/joint/parameters.h"
#include "analysis/simulation/simulate.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace stickslip {
namespace {

constexpr std::size_t nodes_across = 6, nodes_up = 4, picture_points = 240;
constexpr double picture_tolerance = 1e-6;

/// The middle nodes of `count` equal stretches of an axis.
std::vector<double> spread(const Axis& axis, std::size_t count)
{
    std::vector<double> values;
    const std::size_t size = axis.values.size();
    for (std::size_t i = 0; i < count; ++i) {
        const double value = axis.values[(2 * i + 1) * size / (2 * count)];
        if (values.empty() || value != values.back()) values.push_back(value);
    }
    return values;
}

}  // namespace

MapMotion thinned(const std::vector<double>& time, const std::vector<double>& velocity, std::size_t points)
{
    MapMotion motion;
    const std::size_t stretches = std::max<std::size_t>(1, points / 2), size = time.size();
    const auto keep = [&](std::size_t i) {
        motion.time.push_back(time[i]);
        motion.velocity.push_back(velocity[i]);
    };
    if (size <= points) {
        motion.time = time;
        motion.velocity = velocity;
        return motion;
    }
    // Solvers take small steps where much happens: equal stretches of time, not of steps, and the extremes of each.
    std::size_t first = 0;
    for (std::size_t s = 0; s < stretches; ++s) {
        const double until = time.back() * static_cast<double>(s + 1) / static_cast<double>(stretches);
        std::size_t end = first;
        while (end < size && (time[end] <= until || s + 1 == stretches)) ++end;
        if (end == first) continue;
        const auto from = velocity.begin() + static_cast<std::ptrdiff_t>(first);
        const auto [low, high] = std::minmax_element(from, velocity.begin() + static_cast<std::ptrdiff_t>(end));
        const auto a = static_cast<std::size_t>(std::min(low, high) - velocity.begin());
        const auto b = static_cast<std::size_t>(std::max(low, high) - velocity.begin());
        keep(a);
        if (b != a) keep(b);
        first = end;
    }
    return motion;
}

std::vector<MapMotion> map_motions(const Joint& joint, const Slice& slice)
{
    const auto across = spread(slice.x, nodes_across), up = spread(slice.y, nodes_up);
    std::vector<MapMotion> found(across.size() * up.size());
    const Joint held = joint_at(joint, slice.held);
    tbb::parallel_for(std::size_t{0}, found.size(), [&](std::size_t i) {
        Joint node = held;
        const double x = across[i % across.size()], y = up[i / across.size()];
        number_at(node, slice.x.path) = x;
        number_at(node, slice.y.path) = y;
        SimulateOptions options;
        options.rtol = picture_tolerance;
        const auto t = simulate(node, options);
        found[i] = thinned(t.time, t.velocity, picture_points);
        found[i].x = x;
        found[i].y = y;
    });
    std::erase_if(found, [](const MapMotion& m) { return m.time.size() < 2; });
    return found;
}

}  // namespace stickslip
