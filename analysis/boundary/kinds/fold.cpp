#include "analysis/boundary/kinds/fold.h"

#include "analysis/boundary/kinds/coexistence.h"
#include "analysis/boundary/kinds/fold_by_sides.h"
#include "analysis/boundary/kinds/fold_chart.h"
#include "analysis/boundary/kinds/fold_seed.h"
#include "analysis/boundary/trace/paths.h"
#include "analysis/joint/parameters.h"

#include <algorithm>

namespace stickslip {
namespace {

constexpr double same_place = 2e-3;  ///< relative: two seeds that led to one place of a chart
constexpr int hopf_samples = 24;     ///< points of a linear boundary at which its criticality is evaluated

/// Folds over a chart: seeds from the linear boundary and from the guarding grid.
class FoldSearch {
  public:
    FoldSearch(const Joint& joint, const Axis& x, const Axis& y, const BoundaryRequest& request)
        : joint_(joint), request_(request), chart_(joint, ends(x), ends(y))
    {
        result_.kind = BoundaryKind::fold;
        result_.x = ends(x), result_.y = ends(y);
    }

    FollowedBoundary run()
    {
        from_linear_boundary();
        from_grid();
        result_.evaluations = turns_ + chart_.turns() + result_.guard.evaluations;
        return std::move(result_);
    }

  private:
    static Axis ends(Axis axis)
    {
        axis.values = {axis.values.front(), axis.values.back()};
        return axis;
    }
    const Axis& axis(bool along_y) const { return along_y ? result_.y : result_.x; }

    /// Runs a search for a seed along one axis through a point of the chart, and follows what it finds.
    template <class Search>
    bool follow_from(UnitPoint p, bool along_y, Search&& search)
    {
        const UnitAxis x(result_.x), y(result_.y);
        Joint joint = joint_;
        number_at(joint, result_.x.path) = x.value(p.u);
        number_at(joint, result_.y.path) = y.value(p.v);
        const OrbitSystem along(joint, {axis(along_y)});
        const std::optional<FoldSeed> seed = search(along, along_y ? p.v : p.u);
        turns_ += along.turns();
        if (!seed) return false;
        Eigen::VectorXd guess(chart_.section() + 2);
        guess << seed->w, (along_y ? p.u : seed->q), (along_y ? seed->q : p.v);
        const auto fold = chart_.solve(guess, along_y ? 0 : 1);
        if (!fold || !chart_.place(*fold).inside()) return false;
        if (paths_.pass(chart_.place(*fold), same_place)) return true;
        std::vector<UnitPoint> path;
        result_.pieces.push_back(chart_.follow(*fold, request_.following, request_.precision, path));
        paths_.add(std::move(path));
        return true;
    }

    void from_linear_boundary()
    {
        BoundaryRequest linear = request_;
        linear.kind = BoundaryKind::state_variable;
        linear.precision = not_set;
        linear.following.guard = 0;
        const auto boundary = follow_boundaries(joint_, result_.x, result_.y, linear);
        const UnitAxis x(result_.x), y(result_.y);
        for (const auto& piece : boundary.pieces) {
            const std::size_t n = piece.points.size(), stride = std::max<std::size_t>(1, n / hopf_samples);
            bool done = false;  // with this run of subcritical points
            for (std::size_t i = stride / 2; i < n; i += stride) {
                const auto& p = piece.points[i];
                const UnitPoint place{x.unit(p.x), y.unit(p.y)};
                Joint joint = joint_;
                number_at(joint, result_.x.path) = p.x;
                number_at(joint, result_.y.path) = p.y;
                if (!is_subcritical(joint)) {
                    done = false;
                    continue;
                }
                done = done || follow_from(place, p.along_y, fold_beyond_hopf);
            }
        }
    }

    void from_grid()
    {
        const int cells = request_.following.guard;
        std::vector<UnitPoint> nodes;
        std::vector<Joint> joints;
        const UnitAxis x(result_.x), y(result_.y);
        for (int j = 0; j <= cells; ++j)
            for (int i = 0; i <= cells; ++i) {
                nodes.push_back({static_cast<double>(i) / cells, static_cast<double>(j) / cells});
                joints.push_back(joint_);
                number_at(joints.back(), result_.x.path) = x.value(nodes.back().u);
                number_at(joints.back(), result_.y.path) = y.value(nodes.back().v);
            }
        const auto sides = coexistence(joints, request_.parallel);
        auto& guard = result_.guard;
        guard.nodes = guard.evaluations = static_cast<int>(nodes.size());
        guard.cell = 1.0 / cells;
        for (const double s : sides) guard.undecided += std::isnan(s);
        const auto row = static_cast<std::size_t>(cells) + 1;
        for (std::size_t k = 0; k < nodes.size(); ++k)
            for (const bool up : {false, true}) {
                const std::size_t other = up ? k + row : k + 1;
                if (up ? other >= nodes.size() : other % row == 0) continue;
                if (!(sides[k] * sides[other] == 0 && sides[k] + sides[other] == -1)) continue;
                ++guard.changes;
                if (paths_.crossings(nodes[k], nodes[other]) % 2 == 1) continue;
                const bool from_k = sides[k] == 0;
                const auto search = [&](const OrbitSystem& along, double q) {
                    return fold_beyond_cycle(along, q, from_k ? 1 : -1);
                };
                const bool found = follow_from(nodes[from_k ? k : other], up, search);
                const bool beside = paths_.pass(0.5 * (nodes[k] + nodes[other]), 0.5 / cells);
                if (!(found && beside) && paths_.crossings(nodes[k], nodes[other]) % 2 == 0) ++guard.unexplained;
            }
    }

    const Joint& joint_;
    const BoundaryRequest& request_;
    FoldChart chart_;
    FollowedBoundary result_;
    FollowedPaths paths_;
    int turns_ = 0;
};

}  // namespace

FollowedBoundary follow_folds(const Joint& joint, const Axis& x, const Axis& y, const BoundaryRequest& request)
{
    if (!has_smooth_orbits(joint, {x, y})) return follow_folds_by_sides(joint, x, y, request);
    return FoldSearch(joint, x, y, request).run();
}

}  // namespace stickslip
