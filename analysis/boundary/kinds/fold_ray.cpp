#include "analysis/boundary/kinds/coexistence.h"
#include "analysis/boundary/kinds/fold.h"
#include "analysis/boundary/kinds/fold_by_sides.h"
#include "analysis/boundary/kinds/fold_chart.h"
#include "analysis/boundary/kinds/fold_seed.h"
#include "analysis/joint/parameters.h"

#include <algorithm>
#include <utility>

namespace stickslip {
namespace {

constexpr double same_fold = 1e-6;  ///< relative: two seeds that led to one point

/// An axis of the joint beside the given one, to be held: folds are solved over two.
Axis held_axis(const Joint& joint, const Axis& axis)
{
    Axis held;
    for (const char* path : {"control.k_p", "joint.inertia", "joint.motor_inertia", "joint.link_inertia"}) {
        const double* number = find_parameter(joint, path);
        if (!number || number == find_parameter(joint, axis.path) || !(*number > 0)) continue;
        held.path = path;
        held.log = true;
        held.values = {*number / 2, *number * 2};
        return held;
    }
    return held;
}

/// Folds along an axis of a joint whose closed orbits can be solved for.
class Branches {
  public:
    Branches(const Joint& joint, const Axis& axis, const Axis& held, const BoundaryRequest& request)
        : joint_(joint),
          axis_(axis),
          held_(held),
          request_(request),
          unit_(axis),
          along_(joint, {axis}),
          chart_(joint, axis, held)
    {
    }

    const OrbitSystem& along() const { return along_; }
    const std::vector<BoundaryPoint>& points() const { return points_; }
    int turns() const { return chart_.turns() + along_.turns(); }

    /// Whether the seed leads to a fold; one on the axis is kept.
    bool keep(const std::optional<FoldSeed>& seed) { return keep_on(chart_, seed); }

    /// From a subcritical linear boundary.
    bool follow_from(double linear_boundary)
    {
        if (keep(fold_beyond_hopf(along_, unit_.unit(linear_boundary)))) return true;
        // a branch that turns back close to its Hopf point is too short for the steps of a wide axis
        for (const double reach : {2.0, 1.1, 1.01}) {
            const double inner = linear_boundary / reach, outer = linear_boundary * reach;
            Axis near = axis_;
            near.log = linear_boundary > 0;
            near.values = near.log ? std::vector{inner, outer} : std::vector{outer, inner};
            const OrbitSystem along_near(joint_, {near});
            const FoldChart chart_near(joint_, near, held_);
            if (keep_on(chart_near, fold_beyond_hopf(along_near, UnitAxis(near).unit(linear_boundary)))) return true;
        }
        return false;
    }

  private:
    bool keep_on(const FoldChart& on, const std::optional<FoldSeed>& seed)
    {
        if (!seed) return false;
        Eigen::VectorXd guess(on.section() + 2);
        guess << seed->w, seed->q, 0.5;
        const auto fold = on.solve(guess, 1);
        if (!fold || !on.place(*fold).inside() || fold->z.head(on.section()).norm() < least_orbit) return false;
        const int before = on.turns() + along_.turns();
        auto point = on.located(*fold, false, request_.precision).at;
        if (!(unit_.unit(point.value) >= 0 && unit_.unit(point.value) <= 1)) return true;  // found, but off the axis
        point.evaluations += before;
        for (const auto& known : points_)
            if (std::abs(known.value - point.value) <= same_fold * std::abs(point.value)) return true;
        points_.push_back(point);
        return true;
    }

    const Joint& joint_;
    const Axis& axis_;
    const Axis& held_;
    const BoundaryRequest& request_;
    UnitAxis unit_;
    OrbitSystem along_;
    FoldChart chart_;
    std::vector<BoundaryPoint> points_;
};

std::vector<BoundaryPoint> linear_boundaries(const Joint& joint, const Axis& axis, BoundaryRequest request)
{
    request.kind = BoundaryKind::state_variable;
    request.precision = not_set;
    request.scan = 0;
    return locate_boundaries(joint, axis, request).points;
}

/// The linear boundary between two nodes that lies nearest to the stable one.
std::optional<double> nearest_to(const SideAt& stable, const SideAt& other, const std::vector<BoundaryPoint>& linear)
{
    std::optional<double> nearest;
    for (const auto& p : linear) {
        if ((p.value - stable.value) * (p.value - other.value) > 0) continue;
        if (!nearest || std::abs(p.value - stable.value) < std::abs(*nearest - stable.value)) nearest = p.value;
    }
    return nearest;
}

}  // namespace

LocatedRay locate_folds(const Joint& joint, const Axis& axis, const BoundaryRequest& request)
{
    LocatedRay ray;
    ray.kind = BoundaryKind::fold;
    ray.axis = axis;
    ray.axis.values = {axis.values.front(), axis.values.back()};
    const auto linear = linear_boundaries(joint, ray.axis, request);
    const UnitAxis unit(ray.axis);
    const Axis held = held_axis(joint, ray.axis);
    std::optional<Branches> branches;
    if (!held.path.empty() && has_smooth_orbits(joint, {ray.axis})) branches.emplace(joint, ray.axis, held, request);
    if (branches)
        for (const auto& crossing : linear) {
            const auto at = branches->along().joint_at(Eigen::VectorXd::Constant(1, unit.unit(crossing.value)));
            if (is_subcritical(at) && !branches->follow_from(crossing.value)) ++ray.undecided;
        }
    FoldBySides sides(joint, ray.axis, request);
    const auto nodes = sides.scan(request.scan);
    std::vector<BoundaryPoint> between;
    int stable = 0;
    const SideAt* last = nullptr;  // with a verdict
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        stable += nodes[i].side < 0;
        if (std::isnan(nodes[i].side)) {
            ++ray.undecided;
            continue;
        }
        const SideAt *before = std::exchange(last, &nodes[i]), &here = nodes[i];
        if (!before || (before->side < 0) == (here.side < 0)) continue;
        const bool rising = here.side >= 0;
        const SideAt &cycle = rising ? here : *before, &none = rising ? *before : here;
        const auto known = [&] {
            const auto within = [&](const BoundaryPoint& p) {
                return (p.value - cycle.value) * (p.value - none.value) <= 0;
            };
            return branches && std::any_of(branches->points().begin(), branches->points().end(), within);
        };
        std::optional<BoundaryPoint> fold;
        if (cycle.side == 0) {
            // cycles that only a large disturbance reaches
            if (branches && !known())
                branches->keep(fold_beyond_cycle(branches->along(), unit.unit(cycle.value), rising ? -1 : 1));
            if (!known()) fold = sides.between(cycle, none);
        } else if (!branches) {
            if (const auto boundary = nearest_to(none, cycle, linear)) fold = sides.beside(*boundary, none);
        }
        if (fold) between.push_back(*fold);
    }
    if (branches) ray.points = branches->points();
    ray.points.insert(ray.points.end(), between.begin(), between.end());
    ray.nodes = static_cast<int>(nodes.size());
    ray.undecided += sides.undecided();
    ray.stable_share = static_cast<double>(stable) / static_cast<double>(nodes.size());
    ray.evaluations = sides.evaluations() + (branches ? branches->turns() : 0);
    if (!branches) ray.narrowest_strip = narrowest_strip / request.scan;
    std::sort(ray.points.begin(), ray.points.end(),
              [](const BoundaryPoint& a, const BoundaryPoint& b) { return a.value < b.value; });
    return ray;
}

}  // namespace stickslip
