// In one file: one search over directions, by the measure or by the side, whichever costs less.
// The nearest boundary, over all directions of the coordinates.
#include "analysis/boundary/kinds/nearest.h"

#include "analysis/base/require_valid.h"
#include "analysis/boundary/kinds/directions.h"
#include "analysis/boundary/trace/locate.h"
#include "analysis/numerics/optimise.h"
#include "analysis/numerics/root.h"
#include "analysis/stability/frequency_search.h"
#include "analysis/stability/linear_joint.h"
#include "analysis/stability/real_loop.h"
#include "analysis/stability/steady.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stickslip {
namespace {

constexpr double crossing_precision = 1e-10;
constexpr double by_sides = 1e-4;          ///< of a distance, to which it is found by halving
constexpr int normal_steps = 6;            ///< at most
constexpr std::size_t followed = 5;        ///< directions whose normals are: the steepest one and the nearest axes
constexpr double normal_precision = 1e-4;  ///< of the distance, where its gain by another step ends them
constexpr double gradient_step = 1e-5;     ///< in units of the coordinates

class NearestSearch {
  public:
    NearestSearch(const Joint& joint, const std::vector<Coordinate>& coordinates, const NearestOptions& options)
        : joint_(joint),
          coordinates_(coordinates),
          options_(options),
          n_(coordinates.size()),
          movable_(joint, coordinates),
          costly_(growth_is_costly(joint))
    {
        if (!is_set(options_.reach)) options_.reach = default_reach(coordinates);
        precision_ = options_.precision;
    }

    NearestBoundary run()
    {
        decide();
        if (!result_.decided) return result_;
        result_.distance = options_.reach;
        if (n_ == 0) return result_;
        std::vector<Vector> starts = options_.starts;
        const bool further = !options_.along_starts_only;
        for (std::size_t i = 0; further && i < n_; ++i)
            for (const double sign : {-1.0, 1.0}) {
                starts.emplace_back(n_, 0);
                starts.back()[i] = sign;
            }
        const Bounds cube{Vector(n_, -1), Vector(n_, 1)};
        const auto distance = [this](const Vector& direction) { return first_crossing(direction); };
        Vector best;
        double least = infinity;
        Vector normal(n_, 0);
        std::vector<std::pair<double, Vector>> leads;
        const auto consider = [&](const Vector& direction, double within = infinity) {
            const double d = first_crossing(direction, within);
            if (d < least) least = d, best = direction;
            return d;
        };
        for (std::size_t i = 0; i < starts.size(); ++i) {
            // what is further than the nearest one is asked for by intercepts alone, or to lead a search
            const bool nearer_only = !further || (!costly_ && least < options_.reach);
            const double d = consider(starts[i], nearer_only ? std::min(least, options_.reach) : infinity);
            if (i >= options_.starts.size()) add_intercept(starts[i], d, normal);
            if (d < options_.reach) leads.emplace_back(d, starts[i]);
        }
        if (further && n_ > 1 && costly_ && norm(normal) > 0) consider(normal);
        if (further && options_.global && n_ > 1)
            consider(global_minimum(distance, cube, global_evaluations * static_cast<int>(n_)));
        if (further && n_ > 1 && !costly_) {
            // where numbers act together, as the level and the peak of one friction, the nearest point lies near no
            // axis
            leads.emplace_back(0, steepest(Vector(n_, 0)));
            std::ranges::stable_sort(leads, {}, &std::pair<double, Vector>::first);
            for (std::size_t i = 0; i < std::min(followed, leads.size()); ++i) {
                double reached = first_crossing(leads[i].second);
                if (!(reached < 2 * options_.reach)) continue;
                follow_normals(leads[i].second, reached);
                if (reached < least) least = reached, best = leads[i].second;
            }
            follow_normals(best, least);
        }
        for (const double step : {0.3, 0.05})
            if (further && n_ > 1 && options_.local > 0 && (options_.global || step < 0.1))
                consider(local_minimum(distance, cube, scaled_by(best, 0.7 / norm(best)), step,
                                       options_.local * static_cast<int>(n_)));
        if (least < options_.reach && precision_ > crossing_precision) {
            least = refined(best, least);
        }
        if (least < options_.reach) finish(best, least);
        return result_;
    }

  private:
    void decide()
    {
        if (costly_) {
            const auto side = side_at(Vector(n_, 0));
            result_.decided = side.has_value();
            result_.stable = side.value_or(false);
            return;
        }
        here_ = measure(Vector(n_, 0));
        result_.decided = !std::isnan(here_);
        result_.stable = here_ < 0;
    }

    std::optional<bool> side_at(const Vector& q)
    {
        ++result_.evaluations;
        const Joint& moved = movable_.at(q);
        return movable_.allowed() ? is_stable(moved, options_.theory) : std::nullopt;
    }

    double measure(const Vector& q)
    {
        ++result_.evaluations;
        const Joint& moved = movable_.at(q);
        return movable_.allowed() ? instability(moved, options_.theory) : missing;
    }

    /// The crossing that was located roughly along a direction, to crossing_precision.
    double refined(const Vector& direction, double rough)
    {
        const double beside = 2 * precision_ * rough;
        precision_ = crossing_precision;
        const Vector unit = scaled_by(direction, 1 / norm(direction));
        const auto at = [&](double r) { return measure(scaled_by(unit, r)); };
        const double low = rough - beside, high = rough + beside, fa = at(low), fb = at(high);
        const bool crosses = !std::isnan(fa + fb) && (fa < 0) == result_.stable && (fb < 0) != result_.stable;
        return crosses ? located(unit, bracketed_root(at, low, fa, high, fb, precision_)) : first_crossing(direction);
    }

    /// Distance to the first change of side along a direction; the reach, and a little more the less it comes near.
    /// Without a crossing nearer than `within` only that: infinity.
    double first_crossing(const Vector& direction, double within = infinity)
    {
        const double length = norm(direction);
        if (length < 1e-9) return 4 * options_.reach;
        const Vector unit = scaled_by(direction, 1 / length);
        const auto at = [&](double r) { return measure(scaled_by(unit, r)); };
        double a = 0, looked_at = 0;
        // what lies beyond the reach does not count, but leads a search over directions to what does
        const bool leads = n_ > 1 && !costly_;
        const double far = (leads ? 2 : 1) * options_.reach;
        for (int k = 1; k <= options_.rays; ++k) {
            const double share = static_cast<double>(k) / options_.rays;  // finer where it matters: near the joint
            const double b = std::min(far * share * share, within);
            const auto side = side_at(scaled_by(unit, b));
            if (!side) break;
            if (*side != result_.stable) {
                const auto [low, high] = costly_ ? narrowed(unit, a, b) : std::pair{a, b};
                if (costly_ && precision_ >= by_sides) return 0.5 * (low + high);
                const double fa = low == 0 && !costly_ ? here_ : at(low), fb = at(high);
                if ((fa < 0) != (fb < 0)) return located(unit, bracketed_root(at, low, fa, high, fb, precision_));
                if (costly_) return 0.5 * (low + high);
            }
            a = b;
            if (a >= within) return infinity;
            if (a <= options_.reach) looked_at = a;
        }
        if (within < infinity) return infinity;
        // without a crossing the search is led to where the measure has come down most, within the reach
        const double left = leads && looked_at > 0 ? at(looked_at) / here_ : 1;
        return far * (1 + 0.5 * (std::isnan(left) ? 1 : std::clamp(left, 0.0, 1.0)));
    }

    /// Where the measure has no number the search for its root ends early; the side still has one.
    double located(const Vector& unit, const Bracketed& root)
    {
        if (root.converged) return root.value;
        const auto [low, high] = narrowed(unit, root.low, root.high);
        return 0.5 * (low + high);
    }

    /// A change of side between two distances, by halving: where the measure costs many times the side.
    std::pair<double, double> narrowed(const Vector& unit, double a, double b)
    {
        while (b - a > by_sides * b) {
            const double middle = 0.5 * (a + b);
            const auto side = side_at(scaled_by(unit, middle));
            if (!side) break;
            (*side == result_.stable ? a : b) = middle;
        }
        return {a, b};
    }

    /// Of the plane through the crossings on the axes, Σ q_i/d_i = 1, whose normal is that of a smooth boundary if it
    /// is nearly a plane.
    void add_intercept(const Vector& axis, double distance, Vector& normal) const
    {
        if (!(distance < options_.reach)) return;
        for (std::size_t i = 0; i < n_; ++i)
            if (axis[i] != 0 && std::abs(normal[i]) * distance < 1) normal[i] = axis[i] / distance;
    }

    /// The nearest point of a smooth boundary lies along the boundary's normal there, so each point's normal leads to a
    /// nearer one. Source: R. Rackwitz & B. Fiessler, Comput. Struct. 9 (1978) 489-494.
    void follow_normals(Vector& direction, double& distance)
    {
        for (int k = 0; k < normal_steps; ++k) {
            Vector next = steepest(scaled_by(direction, distance / norm(direction)));
            const double length = norm(next);
            if (!(length > 0) || !std::isfinite(length)) return;
            for (std::size_t i = 0; i < n_; ++i) next[i] /= length;
            double reached = first_crossing(next);
            if (!(reached < distance)) {  // the normal turns quickly: half the way
                for (std::size_t i = 0; i < n_; ++i) next[i] += direction[i] / norm(direction);
                reached = first_crossing(next);
            }
            if (!(reached < distance)) return;
            const bool enough = distance - reached < normal_precision * distance;
            direction = next, distance = reached;
            if (enough) return;
        }
    }

    /// The direction in which the verdict changes fastest at a point, of any length.
    Vector steepest(const Vector& point)
    {
        const double here = measure(point);
        Vector gradient(n_);
        for (std::size_t i = 0; i < n_; ++i) {
            Vector beside = point;
            beside[i] += gradient_step;
            gradient[i] = (measure(beside) - here) * (result_.stable ? 1 : -1);
        }
        return gradient;
    }

    void finish(const Vector& best, double distance)
    {
        result_.found = true;
        result_.distance = distance;
        result_.direction = scaled_by(best, 1 / norm(best));
        for (std::size_t i = 0; i < n_; ++i) {
            const auto& c = coordinates_[i];
            const double from = value_of(joint_, c);
            result_.moves.push_back({c.path, c.less, from, from * std::exp(result_.direction[i] * distance * c.scale)});
        }
    }

    const Joint& joint_;
    const std::vector<Coordinate>& coordinates_;
    NearestOptions options_;
    std::size_t n_;
    MovableJoint movable_;
    bool costly_;  ///< the measure, beside the side
    double here_ = missing, precision_ = crossing_precision;
    NearestBoundary result_;
};

}  // namespace

NearestOptions affordable_search(const Joint& joint)
{
    NearestOptions options;
    const auto steady = steady_sliding(joint);
    if (steady.reason != Reason::none) return options;
    const auto linear = linear_joint(joint, steady.slides_at);
    if (!linear.rational())
        options.global = false, options.rays = 12, options.local = growth_is_costly(joint) ? 2 : 8,
        options.precision = 1e-4;
    else if (linear.bodies > 1)
        options.global = false, options.rays = 24, options.local = 40;
    const double effort = search_effort();
    constexpr double least_global = 0.5, most_local = 1000;
    options.global = options.global && effort >= least_global;
    options.local = static_cast<int>(std::clamp(options.local * effort, 1.0, most_local));
    return options;
}

double default_reach(const std::vector<Coordinate>& coordinates)
{
    double least = infinity;
    for (const auto& c : coordinates) least = std::min(least, c.scale);
    return std::numbers::ln10 / least;
}

double tolerance_each(double distance, const std::vector<Coordinate>& coordinates)
{
    double squares = 0;
    for (const auto& c : coordinates) squares += 1 / (c.scale * c.scale);
    return -std::expm1(-(squares > 0 ? distance / std::sqrt(squares) : distance));
}

std::string NearestOptions::problem() const
{
    return first_problem(
        problem_unless(std::isnan(reach) || reach > 0, "reach", reach, "above 0, or NaN for a factor of ten"),
        problem_unless(rays >= 1, "rays", rays, "at least 1"), problem_unless(local >= 0, "local", local, "at least 0"),
        problem_unless(precision > 0 && precision < 1, "precision", precision, "between 0 and 1"));
}

NearestBoundary nearest_boundary(const Joint& joint, const std::vector<Coordinate>& coordinates,
                                 const NearestOptions& options)
{
    require_valid(options);
    return NearestSearch(joint, coordinates, options).run();
}

double signed_margin(const NearestBoundary& nearest)
{
    return !nearest.decided ? missing : nearest.stable ? nearest.distance : -nearest.distance;
}

}  // namespace stickslip
