#include "analysis/boundary/trace/follow.h"

#include "analysis/base/require_valid.h"
#include "analysis/boundary/trace/climb.h"
#include "analysis/boundary/trace/paths.h"
#include "analysis/boundary/trace/tracer.h"

#include <algorithm>

namespace stickslip {
namespace {

constexpr double same_piece = 0.02;  ///< distance, per cell, at which a crossing belongs to a piece already followed

/// The coarse grid over the chart, and the pieces followed from its changes of side.
class Guard {
  public:
    Guard(const Sides& sides, Tracer& tracer, int cells) : sides_(sides), tracer_(tracer), cells_(cells)
    {
        for (int j = 0; j <= cells; ++j)
            for (int i = 0; i <= cells; ++i) nodes_.push_back({double(i) / cells, double(j) / cells});
        values_.resize(nodes_.size());
        if (sides.many) {
            std::vector<double> x, y;
            for (const auto& n : nodes_) x.push_back(tracer.x().value(n.u)), y.push_back(tracer.y().value(n.v));
            sides.many(x, y, values_);
            tracer.count(static_cast<int>(nodes_.size()));
        } else {
            std::transform(nodes_.begin(), nodes_.end(), values_.begin(), [&](UnitPoint n) { return tracer_.at(n); });
        }
    }

    FollowedBoundary run()
    {
        auto& guard = result_.guard;
        guard.nodes = static_cast<int>(nodes_.size());
        guard.cell = 1.0 / cells_;
        guard.undecided =
            static_cast<int>(std::count_if(values_.begin(), values_.end(), [](double v) { return std::isnan(v); }));
        guard.evaluations = tracer_.evaluations();
        for (int j = 0; j <= cells_; ++j)
            for (int i = 0; i <= cells_; ++i) {
                if (i < cells_) visit_edge(at(i, j), at(i + 1, j));
                if (j < cells_) visit_edge(at(i, j), at(i, j + 1));
            }
        if (sides_.continuous) climb_extrema();
        result_.evaluations = tracer_.evaluations();
        return std::move(result_);
    }

  private:
    std::size_t at(int i, int j) const
    {
        return static_cast<std::size_t>(j) * (static_cast<std::size_t>(cells_) + 1) + static_cast<std::size_t>(i);
    }
    bool differ(std::size_t a, std::size_t b) const
    {
        return !std::isnan(values_[a]) && !std::isnan(values_[b]) && (values_[a] < 0) != (values_[b] < 0);
    }

    /// Whether decay fades into an area of neutral sliding between the two nodes: its edge is no boundary.
    bool fades_out(std::size_t a, std::size_t b)
    {
        if (!sides_.continuous || (values_[a] != 0 && values_[b] != 0)) return false;
        constexpr double next_to_node = 1e-6;  ///< of a cell
        const auto [neutral, stable] = values_[a] == 0 ? std::pair(a, b) : std::pair(b, a);
        return tracer_.at(nodes_[neutral] + next_to_node * (nodes_[stable] - nodes_[neutral])) == 0;
    }

    bool on_a_piece(UnitPoint p) const { return paths_.pass(p, same_piece / cells_); }

    void visit_edge(std::size_t a, std::size_t b)
    {
        if (!differ(a, b) || fades_out(a, b)) return;
        ++result_.guard.changes;
        if (paths_.crossings(nodes_[a], nodes_[b]) % 2 == 1) return;
        const auto start = tracer_.locate(nodes_[a], values_[a], nodes_[b], values_[b]);
        if (!on_a_piece(start.p)) follow_from(start);
        if (!on_a_piece(start.p)) ++result_.guard.unexplained;
    }

    void follow_from(const Located& start)
    {
        std::vector<UnitPoint> path;
        auto piece = tracer_.piece_through(start, path);
        if (piece.last == CurveEnd::closed && !path.empty()) path.push_back(path.front());
        paths_.add(std::move(path));
        result_.pieces.push_back(std::move(piece));
    }

    /// Nodes whose neighbours all lie on the same side and further from the boundary may hide an island among them.
    void climb_extrema()
    {
        for (int j = 0; j <= cells_; ++j)
            for (int i = 0; i <= cells_; ++i) {
                const double here = values_[at(i, j)];
                bool extremal = !std::isnan(here);
                for (int dj = -1; dj <= 1 && extremal; ++dj)
                    for (int di = -1; di <= 1; ++di) {
                        if (i + di < 0 || i + di > cells_ || j + dj < 0 || j + dj > cells_) continue;
                        const double there = values_[at(i + di, j + dj)];
                        extremal = extremal && (there < 0) == (here < 0) && std::abs(there) >= std::abs(here);
                    }
                if (extremal) climb(at(i, j));
            }
    }

    void climb(std::size_t from)
    {
        ++result_.guard.climbed;
        const double sign = values_[from] < 0 ? -1 : 1;
        const auto top = climb_to_zero([&](UnitPoint p) { return sign * tracer_.at(p); }, nodes_[from], 1.0 / cells_);
        if (!(top.value < 0)) return;
        // from the top back to the node: first along one axis, then along the other
        const UnitPoint corner{top.p.u, nodes_[from].v};
        const double at_corner = tracer_.at(corner), at_top = sign * top.value;
        const bool first_leg = (at_corner < 0) != (at_top < 0);
        const auto start = first_leg ? tracer_.locate(corner, at_corner, top.p, at_top)
                                     : tracer_.locate(nodes_[from], values_[from], corner, at_corner);
        if (on_a_piece(start.p)) return;
        ++result_.guard.islands;
        follow_from(start);
    }

    const Sides& sides_;
    Tracer& tracer_;
    int cells_;
    std::vector<UnitPoint> nodes_;  ///< row by row
    std::vector<double> values_;
    FollowedPaths paths_;
    FollowedBoundary result_;
};

}  // namespace

namespace {

/// The requested precision, or what the steps need: a walk would take the scatter of wide brackets for turns.
double fine_enough(double precision, const Axis& x, const Axis& y, double step)
{
    constexpr double of_a_step = 0.05;
    for (const auto* axis : {&x, &y}) {
        const UnitAxis unit(*axis);
        const double span =
            unit.log ? unit.span() : (unit.high - unit.low) / std::max(std::abs(unit.low), std::abs(unit.high));
        precision = std::min(precision, of_a_step * step * span);
    }
    return precision;
}

}  // namespace

std::string FollowingOptions::problem() const
{
    return first_problem(problem_unless(guard >= 0, "guard", guard, "a number of cells, or 0 for the usual one"),
                         problem_unless(longest_step >= 0 && longest_step <= 1, "longest_step", longest_step, "0 to 1"),
                         problem_unless(shortest_step > 0 && shortest_step <= 1, "shortest_step", shortest_step,
                                        "above 0 and at most 1"),
                         problem_unless(turn > 0, "turn", turn, "an angle above 0"),
                         problem_unless(point_limit >= 1, "point_limit", point_limit, "at least 1"));
}

FollowedBoundary follow_boundary(const Sides& given_sides, const Axis& x, const Axis& y,
                                 const FollowingOptions& given_options)
{
    FollowingOptions options = given_options;
    Sides sides = given_sides;
    if (options.guard == 0) options.guard = default_guard(sides.continuous);
    if (options.longest_step == 0) options.longest_step = default_step(sides.continuous);
    sides.precision = fine_enough(sides.precision, x, y, options.longest_step);
    Tracer tracer(sides, x, y, options);
    auto followed = Guard(sides, tracer, options.guard).run();
    followed.x = x;
    followed.y = y;
    for (auto* axis : {&followed.x, &followed.y}) axis->values = {axis->values.front(), axis->values.back()};
    return followed;
}

}  // namespace stickslip
