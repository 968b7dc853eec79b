#include "sweep/study/dense_chunks.h"

#include "analysis/simulation/dense/dense_points.h"
#include "sweep/engine/hyperslab.h"

#include <cmath>
#include <functional>
#include <numeric>

namespace stickslip {
namespace {

std::uint64_t product(std::span<const std::size_t> sizes)
{
    return std::accumulate(sizes.begin(), sizes.end(), std::uint64_t{1}, std::multiplies<>());
}

/// The coordinates in which motions vary evenly.
std::vector<double> coordinates(const Axis& axis, std::size_t start, std::size_t count)
{
    std::vector<double> values;
    for (std::size_t i = start; i < start + count; ++i)
        values.push_back(axis.log ? std::log(axis.values[i]) : axis.values[i]);
    return values;
}

/// The first of the last axes that a dense box may have.
std::size_t first_axis(const Hyperslab& slab)
{
    std::size_t first = slab.count.size(), wide = 0;
    while (first > 0 && (slab.count[first - 1] == 1 || wide < most_dense_axes)) wide += slab.count[--first] > 1;
    return first;
}

/// A box of the plan: one dense box for each place on the axes before the last ones.
void evaluate_slab(const Hyperslab& slab, const std::vector<Axis>& axes, const NonlinearOptions& options, double bound,
                   PointCursor& cursor, std::span<PointResult> rows)
{
    const std::size_t first = first_axis(slab), all = axes.size();
    const auto counts = std::span(slab.count);
    const std::uint64_t inside = product(counts.subspan(first));
    DenseBox box;
    for (std::size_t d = first; d < all; ++d)
        if (slab.count[d] > 1) box.coordinates.push_back(coordinates(axes[d], slab.start[d], slab.count[d]));
    std::uint64_t place = 0;
    box.joint = [&](std::size_t point) -> const Joint& {
        std::uint64_t left = place * inside + point, number = 0, stride = 1;
        for (std::size_t d = all; d-- > 0;) {
            number += stride * (slab.start[d] + left % slab.count[d]);
            left /= slab.count[d];
            stride *= axes[d].values.size();
        }
        cursor.seek(number);
        return cursor.joint();
    };
    for (; place * inside < rows.size(); ++place)
        dense_points(box, options, bound, rows.subspan(place * inside, inside));
}

}  // namespace

EvaluateChunk dense_evaluator(const NonlinearOptions& options, double bound, const std::vector<Axis>& axes)
{
    std::vector<std::size_t> shape;
    for (const Axis& axis : axes) shape.push_back(axis.values.size());
    return [options, bound, &axes, shape](PointCursor& cursor, std::span<PointResult> rows) {
        for (const Hyperslab& slab : hyperslabs(shape, {cursor.point(), rows.size()})) {
            const std::uint64_t points = slab.points();
            evaluate_slab(slab, axes, options, bound, cursor, rows.first(points));
            rows = rows.subspan(points);
        }
    };
}

}  // namespace stickslip
