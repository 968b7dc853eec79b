// A simplex over parameters in which the misfit is jagged, as a fit that waits for its predictions.
#include "analysis/diagnosis/fit/candidate_numbers.h"
#include "analysis/diagnosis/fit/problem.h"
#include "analysis/numerics/optimise.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace stickslip::gap {
namespace {

using Point = std::vector<double>;

/// Of the objective, by which the simplex ends.
constexpr double tolerance = 1e-4;  // numerical: an end of a search
/// Points that it may ask for next, looked at along with one.
constexpr std::size_t most_guesses = 3;

/// Points that a run may ask for after `point`, whatever the value there: one that leads it on, one that is as good as
/// the best, or one that throws it back.
std::vector<Point> guesses(const Minimisation& search, const Point& start, std::vector<double> values,
                           const Point& point)
{
    constexpr double extreme = 1e290;  // numerical: infinity for the search
    const double best = values.empty() ? 0 : *std::ranges::min_element(values);
    std::vector<Point> found;
    for (std::vector<Point> before{{}}; !before.empty() && found.size() < most_guesses;) {
        std::vector<Point> after;
        for (const auto& told : before)
            for (const double value : {-extreme, extreme, best}) {
                auto then = values;
                then.insert(then.end(), told.begin(), told.end());
                then.push_back(value);
                const auto next = next_point(search, start, then);
                if (!next || *next == point || std::ranges::count(found, *next) > 0) continue;
                if (found.size() < most_guesses) found.push_back(*next);
                after.push_back(told), after.back().push_back(value);
            }
        before = std::move(after);
    }
    return found;
}

}  // namespace

Fitting<LevelFit> searching_rough(FitProblem problem, Eigen::VectorXd x, int evaluations, double first_step, Kept kept)
{
    const Candidate& candidate = problem.candidate;
    LevelFit fit;
    const auto n = static_cast<Eigen::Index>(candidate.parameter_count());
    fit.x = bounded(candidate, std::move(x));
    Minimisation rough{SearchMethod::simplex, {}, {}, evaluations};
    rough.ftol_rel = tolerance;
    std::vector<Eigen::Index> free;
    Point start;
    for (Eigen::Index i = 0; i < n; ++i) {
        if (!kept.empty() && kept[static_cast<std::size_t>(i)]) continue;
        const auto& p = candidate.parameter(static_cast<std::size_t>(i));
        rough.bounds.low.push_back(p.logarithmic ? std::log(p.low) : p.low);
        rough.bounds.high.push_back(p.logarithmic ? std::log(p.high) : p.high);
        rough.first_step.push_back(first_step * (p.logarithmic ? 1 : std::max(0.1, std::abs(p.prior))));
        free.push_back(i), start.push_back(fit.x[i]);
    }
    const auto at = [&](const Point& point) {
        Eigen::VectorXd all = fit.x;
        for (std::size_t k = 0; k < free.size(); ++k) all[free[k]] = point[k];
        return all;
    };
    std::vector<double> values;
    std::map<Point, Evaluation> seen;
    Asked asked{{&problem.cases, &candidate, {}}};
    const auto look_at = [&](std::vector<Point> points) {
        asked.places.clear(), asked.answers.clear();
        for (const auto& point : points) asked.places.push_back({problem.si(at(point)), problem.omega});
        asked.needed = 1;
    };
    for (std::optional<Point> next; (next = next_point(rough, start, values));) {
        if (!seen.contains(*next)) {
            std::vector<Point> points = guesses(rough, start, values, *next);
            std::erase_if(points, [&](const Point& point) { return seen.contains(point); });
            points.insert(points.begin(), *next);
            look_at(points);
            co_await asked;
            for (std::size_t i = 0; i < points.size(); ++i) {
                if (asked.answers[i].empty()) continue;
                auto there = judged(problem.cases, asked.answers[i]);
                there.objective += prior_cost(candidate, at(points[i]));
                seen.emplace(points[i], std::move(there));
            }
        }
        values.push_back(seen.at(*next).objective);
    }
    const Point best = minimum(
        rough, [&, i = std::size_t(0)](const Point&) mutable { return values[i++]; }, start);
    fit.x = at(best);
    fit.evaluation = seen.at(best);
    fit.information = Eigen::MatrixXd::Zero(n, n);
    fit.evaluations = static_cast<int>(values.size()) + 1;
    co_return fit;
}

LevelFit search_rough(const FitProblem& problem, Eigen::VectorXd x, int evaluations, double first_step,
                      const Kept& kept)
{
    return alone(searching_rough(problem, std::move(x), evaluations, first_step, kept));
}

}  // namespace stickslip::gap
