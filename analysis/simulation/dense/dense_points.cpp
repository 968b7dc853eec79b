#include "analysis/simulation/dense/dense_points.h"

#include "analysis/simulation/dense/cells.h"
#include "analysis/simulation/lanes/batch.h"
#include "analysis/simulation/points.h"
#include "analysis/stability/steady.h"
#include "analysis/stability/verdict.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

/// Joints that are followed together: enough to keep the lanes full, few enough for a core's memory.
constexpr std::size_t together = 4096;

dense::Grid grid_of(const DenseBox& box)
{
    dense::Grid grid;
    const std::size_t lacking = dense::dimensions - box.coordinates.size();
    for (std::size_t d = 0; d < dense::dimensions; ++d)
        grid.coordinate[d] = d < lacking ? std::vector<double>{0} : box.coordinates[d - lacking];
    return grid;
}

}  // namespace

void dense_points(const DenseBox& box, const NonlinearOptions& options, double bound, std::span<PointResult> points)
{
    std::vector<dense::Place> places(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Joint& joint = box.joint(i);
        points[i] = linear_point(joint);
        const auto steady = steady_sliding(joint);
        places[i] = {steady.slides_at, displaced(joint, steady), points[i].spectral_abscissa, missing};
        PointResult decay = points[i];
        if (decay.state_variable_stable == 1 && lanes::decay(joint, options, decay))
            places[i].growth = decay.growth_rate, places[i].peak = decay.overshoot;
    }
    std::vector<Joint> joints;
    std::vector<PointResult> rows;
    const auto compute = [&](std::span<const std::size_t> wanted) {
        for (std::size_t first = 0; first < wanted.size(); first += together) {
            const auto now = wanted.subspan(first, std::min(together, wanted.size() - first));
            joints.clear(), rows.clear();
            for (const auto i : now) {
                joints.push_back(box.joint(i));
                rows.push_back(linear_point(joints.back()));
            }
            nonlinear_points(joints, options, rows);
            for (std::size_t k = 0; k < now.size(); ++k) points[now[k]] = rows[k];
        }
    };
    const dense::Grid grid = grid_of(box);
    const dense::ComputeRows compute_rows = compute;
    dense::Survey survey(grid, places, points, compute_rows);
    dense::Cells(survey, bound).run();
}

}  // namespace stickslip
