#include "analysis/boundary/kinds/ray.h"

#include "analysis/boundary/kinds/boundary.h"
#include "analysis/boundary/kinds/linear_side.h"
#include "analysis/boundary/kinds/outcome.h"
#include "analysis/boundary/kinds/undecided_gap.h"
#include "analysis/boundary/trace/climb.h"
#include "analysis/boundary/trace/follow.h"
#include "analysis/boundary/trace/locate.h"
#include "analysis/joint/joint.h"
#include "analysis/joint/parameters.h"
#include "analysis/numerics/root.h"
#include "analysis/results/disturbance.h"

#include <algorithm>

namespace stickslip {
namespace {

class Ray {
  public:
    Ray(const Joint& joint, const Axis& axis, const BoundaryRequest& request)
        : joint_(joint), request_(request), unit_(axis)
    {
        ray_.kind = request.kind;
        ray_.axis = axis;
        ray_.axis.values = {axis.values.front(), axis.values.back()};
    }

    LocatedRay run()
    {
        scan();
        const auto n = values_.size();
        ray_.nodes = static_cast<int>(n);
        ray_.evaluations = ray_.nodes;
        int stable = 0, neutral = 0;
        for (std::size_t i = 0; i < n; ++i) {
            if (std::isnan(sides_[i])) note_undecided(i);
            stable += sides_[i] < 0;
            neutral += neutral_at(i);
            if (i + 1 < n && !neutral_at(i) && !neutral_at(i + 1))
                bracket(values_[i], sides_[i], values_[i + 1], sides_[i + 1]);
            if (!is_linear(request_.kind)) bracket_undecided(i);
            if (neutral_at(i) && (i == 0 || !neutral_at(i - 1))) {
                std::size_t last = i;
                while (last + 1 < n && neutral_at(last + 1)) ++last;
                judge_neutral(i, last);
            }
            if (i + 2 < n && is_linear(request_.kind)) climb(i);
        }
        if (ray_.undecided > 0) ray_.reason = reason_of_first();
        ray_.stable_share = static_cast<double>(stable) / static_cast<double>(n);
        ray_.neutral_share = static_cast<double>(neutral) / static_cast<double>(n);
        std::sort(ray_.points.begin(), ray_.points.end(),
                  [](const BoundaryPoint& a, const BoundaryPoint& b) { return a.value < b.value; });
        return std::move(ray_);
    }

  private:
    static constexpr double single_value = 1e-9;      ///< of the distance between nodes: as wide as a number to a user
    static constexpr double by_growth_within = 1e-4;  ///< relative width of a bracket

    bool neutral_at(std::size_t node) const { return is_linear(request_.kind) && sides_[node] == 0; }

    void note_undecided(std::size_t node)
    {
        ++ray_.undecided;
        auto& stretches = ray_.without_verdict;
        if (node > 0 && std::isnan(sides_[node - 1]))
            stretches.back().high = values_[node];
        else
            stretches.push_back({values_[node], values_[node]});
    }

    Joint joint_at(double value) const
    {
        Joint joint = joint_;
        number_at(joint, ray_.axis.path) = value;
        return joint;
    }

    double side(double value) const { return side_of(joint_at(value), request_); }
    double growth(double value) const { return instability(joint_at(value), theory_of(request_.kind)); }

    /// By sides, which a count of roots tells, to where growth rates take fewer steps than halving and a count resolves
    /// the sides no longer. False where the growth rates of the ends do not show them: then sides go on.
    bool narrow(double& a, double& fa, double& b, double& fb)
    {
        const double width = std::max(by_growth_within, request_.precision);
        while (std::abs(b - a) > std::max(width * std::max(std::abs(a), std::abs(b)), unit_.least_width())) {
            const double middle = 0.5 * (a + b), f = side(middle);
            ++ray_.evaluations;
            if (std::isnan(f)) return false;
            ((f < 0) == (fa < 0) ? a : b) = middle;
        }
        const double ga = growth(a), gb = growth(b);
        ray_.evaluations += 2;
        if (!std::isfinite(ga) || !std::isfinite(gb) || (ga < 0) != (fa < 0) || (gb < 0) != (fb < 0)) return false;
        fa = ga, fb = gb;
        return true;
    }

    Reason reason_of_first() const
    {
        const auto first = std::find_if(sides_.begin(), sides_.end(), [](double side) { return std::isnan(side); });
        Joint joint = joint_;
        number_at(joint, ray_.axis.path) = values_[static_cast<std::size_t>(first - sides_.begin())];
        return reason_without_side(joint, request_);
    }

    void scan()
    {
        const auto n = static_cast<std::size_t>(request_.scan) + 1;
        values_.resize(n), sides_.resize(n);
        for (std::size_t i = 0; i < n; ++i) values_[i] = unit_.value(static_cast<double>(i) / request_.scan);
        if (request_.kind != BoundaryKind::outcome)
            return request_.parallel(n, [&](std::size_t i) { sides_[i] = side(values_[i]); });
        std::vector<Joint> joints(n, joint_);
        for (std::size_t i = 0; i < n; ++i) number_at(joints[i], ray_.axis.path) = values_[i];
        sides_ = outcome_sides(joints, request_.disturbance, request_.parallel);
    }

    void bracket(double a, double fa, double b, double fb)
    {
        if (std::isnan(fa) || std::isnan(fb) || (fa < 0) == (fb < 0)) return;
        if (!is_linear(request_.kind)) return halve({a, b}, fa);
        const bool by_growth = is_told_by_count(joint_at(b), request_.kind) && narrow(a, fa, b, fb);
        const auto measure = [&](double v) { return by_growth ? growth(v) : side(v); };
        auto root = bracketed_root(measure, a, fa, b, fb, request_.precision, unit_.least_width());
        // a boundary at zero is met within rounding only
        if (a < 0 && b > 0 && std::abs(root.value) <= single_value * (b - a) && is_linear(request_.kind) &&
            side(0) == 0)
            root.low = std::min(root.low, 0.0), root.high = std::max(root.high, 0.0), root.value = 0;
        ray_.evaluations += root.evaluations;
        ray_.points.push_back({root.value, root.low, root.high, fb > fa ? 1 : -1, root.converged, root.evaluations});
    }

    /// Node `i` and the next one that has a verdict lie on opposite sides, and nodes between them have none.
    void bracket_undecided(std::size_t i)
    {
        std::size_t next = i + 1;
        while (next < sides_.size() && std::isnan(sides_[next])) ++next;
        if (std::isnan(sides_[i]) || next == i + 1 || next == sides_.size()) return;
        if ((sides_[i] < 0) == (sides_[next] < 0)) return;
        halve({values_[i], values_[next], values_[i + 1], values_[next - 1]}, sides_[i]);
    }

    /// Where only the side is known. Where the change cannot be told from values without a verdict, these are reported.
    void halve(SideGap gap, double side_of_low)
    {
        const auto width = [&](double value) { return std::max(request_.precision * value, unit_.least_width()); };
        gap = closed_in([&](double v) { return side(v); }, gap, side_of_low, width);
        ray_.evaluations += gap.evaluations;
        BoundaryPoint point;
        point.value = 0.5 * (gap.low + gap.high), point.low = gap.low, point.high = gap.high;
        point.direction = side_of_low < 0 ? 1 : -1;
        point.converged = gap.high - gap.low <= width(std::max(std::abs(gap.low), std::abs(gap.high)));
        point.evaluations = gap.evaluations, point.method = LocationMethod::bisection;
        if (!point.converged && ray_.reason == Reason::none && !std::isnan(gap.open_low))
            ray_.reason = reason_without_side(joint_at(gap.open_low), request_);
        ray_.points.push_back(point);
    }

    /// Nodes from `first` to `last` are neutral, those beside them not. A boundary lies there if stability changes
    /// across them, or if neutral sliding is the single value at an end of the range: where it goes on, what was left
    /// of growth or decay has faded into rounding, and nothing turns.
    void judge_neutral(std::size_t first, std::size_t last)
    {
        const double left = first > 0 ? sides_[first - 1] : missing;
        const double right = last + 1 < values_.size() ? sides_[last + 1] : missing;
        if (std::isnan(left) && std::isnan(right)) return;
        if (!std::isnan(left) && !std::isnan(right) && (left < 0) == (right < 0)) return;
        BoundaryPoint point;
        point.low = std::isnan(left) ? values_[first] : end_of_neutral(values_[first], values_[first - 1]);
        point.high = std::isnan(right) ? values_[last] : end_of_neutral(values_[last], values_[last + 1]);
        const double width = point.high - point.low;
        const double apart =
            std::abs(std::isnan(left) ? values_[last + 1] - values_[last] : values_[first] - values_[first - 1]);
        const bool single =
            first == last && width <= std::max(single_value * apart, request_.precision * std::abs(values_[first]));
        if ((std::isnan(left) || std::isnan(right)) && !single) return;
        point.value = single ? values_[first] : 0.5 * (point.low + point.high);
        const bool rises = std::isnan(left) ? right > 0 : left < 0;
        point.direction = rises ? 1 : -1;
        point.converged = point.value == 0 ? single : width <= request_.precision * std::abs(point.value);
        ray_.points.push_back(point);
    }

    /// How far neutral sliding reaches from a neutral node towards another one, by bisection.
    double end_of_neutral(double neutral, double other)
    {
        const double fine = 1e-3 * single_value * std::abs(other - neutral);
        const auto root = bracketed_root(
            [&](double v) {
                ++ray_.evaluations;
                return side(v) == 0 ? 1.0 : -1.0;
            },
            neutral, 1, other, -1, 0, neutral == 0 ? fine : 0.25 * request_.precision * std::abs(neutral));
        return other > neutral ? root.high : root.low;
    }

    /// A pair of boundaries between three nodes of one side shows itself as an extremum towards zero.
    void climb(std::size_t i)
    {
        const double a = sides_[i], b = sides_[i + 1], c = sides_[i + 2];
        if (std::isnan(a + b + c) || (a < 0) != (b < 0) || (c < 0) != (b < 0)) return;
        if (!(std::abs(b) < std::abs(a) && std::abs(b) < std::abs(c))) return;
        ++ray_.climbed;
        const double sign = b < 0 ? -1 : 1;
        const double u = unit_.unit(values_[i + 1]);
        double best = b, at = values_[i + 1];
        climb_to_zero(
            [&](double p) {
                const double v = unit_.value(p), f = side(v);
                ++ray_.evaluations;
                if (sign * f < sign * best) best = f, at = v;
                return sign * f;
            },
            u, unit_.unit(values_[i]), unit_.unit(values_[i + 2]));
        if ((best < 0) == (b < 0)) return;
        bracket(values_[i], a, at, best);
        bracket(at, best, values_[i + 2], c);
    }

    const Joint& joint_;
    const BoundaryRequest& request_;
    UnitAxis unit_;
    std::vector<double> values_, sides_;
    LocatedRay ray_;
};

}  // namespace

LocatedRay locate_on_ray(const Joint& joint, const Axis& axis, const BoundaryRequest& request)
{
    return Ray(joint, axis, request).run();
}

}  // namespace stickslip
