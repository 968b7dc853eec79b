// One search for the numbers of a cause, from screening to polish.
#include "analysis/diagnosis/search/search.h"

#include "analysis/diagnosis/fit/excerpt.h"
#include "analysis/diagnosis/policy/search.h"

#include <algorithm>

namespace stickslip::gap {
namespace {

constexpr double slower_level = levels[1];  // numerical: rad/s

}  // namespace

bool jagged(const Candidate& candidate)
{
    return std::any_of(candidate.forms.begin(), candidate.forms.end(), [](const auto* f) { return f->rough; });
}

bool two_mass_edit(const Candidate& candidate)
{
    return std::ranges::any_of(candidate.effects, [](const auto* e) { return e->of_transmission; });
}

bool divides_mass(const Candidate& candidate)
{
    return std::ranges::any_of(candidate.forms, [](const auto* f) { return f->divides; });
}

bool moves_encoder(const Candidate& candidate)
{
    return std::ranges::any_of(candidate.forms, [](const auto* f) { return f->encoder_on_link; });
}

bool needs_history(const Candidate& candidate)
{
    return std::ranges::any_of(candidate.forms, [](const auto* f) { return f->needs_history; });
}

bool better(const Attribution& a, const Attribution& b)
{
    return a.score < b.score;
}

Fitting<LevelFit> improving(FitProblem problem, Eigen::VectorXd x, int effort, int descents)
{
    const Candidate& candidate = problem.candidate;
    LevelFit fit;
    if (!jagged(candidate)) {
        fit = co_await descending(problem, std::move(x), descents);
        co_return fit;
    }
    Kept smooth, rough;  // which parameters the misfit is jagged in, and which not
    for (std::size_t i = 0; i < candidate.parameter_count(); ++i) {
        rough.push_back(candidate.is_rough(i));
        smooth.push_back(!rough.back());
    }
    const auto searched = static_cast<int>(std::count(rough.begin(), rough.end(), 1));
    constexpr double first_step = 0.3, near = 0.1 * first_step;  // numerical: of the simplex
    constexpr int turns = 2;
    const int part = effort * searched / turns;
    // a simplex over all of them would get lost, and a descent in the teeth: together they lead along narrow valleys
    fit = co_await descending(problem, std::move(x), std::max(2, descents / 3), rough);
    int evaluations = fit.evaluations;
    for (const double step : {first_step, near}) {
        fit = co_await searching_rough(problem, fit.x, part, step, smooth);
        evaluations += fit.evaluations;
        fit = co_await descending(problem, fit.x, descents);
        evaluations += fit.evaluations;
    }
    fit.evaluations = evaluations;
    co_return fit;
}

LevelFit improve(const FitProblem& problem, const Eigen::VectorXd& x, int effort, int descents)
{
    return alone(improving(problem, x, effort, descents));
}

namespace {

/// Of each of these parameters.
std::vector<double> objectives(const FitProblem& problem, const std::vector<Eigen::VectorXd>& at)
{
    std::vector<std::vector<double>> si;
    for (const auto& x : at) si.push_back(problem.si(x));
    std::vector<double> all;
    for (const auto& e : evaluate_all(problem.cases, problem.candidate, si, {problem.omega}))
        all.push_back(e.objective);
    return all;
}

/// The same beside other fits.
Asked asked_at(const FitProblem& problem, const std::vector<Eigen::VectorXd>& at)
{
    Asked asked{{&problem.cases, &problem.candidate, {}, at.size()}};
    for (const auto& x : at) asked.places.push_back({problem.si(x), problem.omega});
    return asked;
}

/// From the best of these starts at a lower bandwidth, then near by at the problem's own: the slope towards the right
/// backlash or limit is longer where a prediction has to hold for longer.
Fitting<LevelFit> searching_slower_first(FitProblem problem, std::vector<Eigen::VectorXd> from, int effort)
{
    constexpr double first_step = 0.3, near = 0.03;  // numerical: of the simplex
    const FitProblem slower = problem.with_bandwidth(slower_level);
    const std::size_t start = co_await nearest_start(slower, from);
    const int count = effort * static_cast<int>(problem.candidate.parameter_count());
    LevelFit fit = co_await searching_rough(slower, from[start], count, first_step);
    int evaluations = static_cast<int>(from.size()) + fit.evaluations;
    fit = co_await searching_rough(problem, fit.x, count / 2, near);
    fit.evaluations += evaluations;
    co_return fit;
}

}  // namespace

Fitting<std::size_t> nearest_start(FitProblem problem, std::vector<Eigen::VectorXd> from)
{
    Asked asked = asked_at(problem, from);
    co_await asked;
    std::vector<double> there;
    for (const auto& scaled : asked.answers) there.push_back(judged(problem.cases, scaled).objective);
    co_return static_cast<std::size_t>(std::ranges::min_element(there) - there.begin());
}

std::vector<Fitting<LevelFit>> fits_from(const FitProblem& problem, const std::vector<Eigen::VectorXd>& from,
                                         int effort, int descents)
{
    const Candidate& candidate = problem.candidate;
    std::vector<std::pair<double, std::size_t>> order;
    constexpr std::size_t few = 3;
    // of a force found on a grid only the frequency is known: before its descent no start is better than another
    const bool combed =
        candidate.forms.size() == 1 && std::ranges::any_of(candidate.forms[0]->parameters,
                                                           [](const auto& p) { return p.grid != FrequencyGrid::none; });
    const bool rough = (from.size() > few && !combed) || jagged(candidate);
    const auto objective = rough ? objectives(problem, from) : std::vector<double>();
    for (std::size_t i = 0; i < from.size(); ++i) order.emplace_back(rough ? objective[i] : 0, i);
    std::stable_sort(order.begin(), order.end());
    const int apart = candidate.forms.size() == 1 ? candidate.forms[0]->apart : -1;
    if (apart >= 0) {
        std::vector<double> taken;
        std::erase_if(order, [&](const auto& start) {
            const double value = from[start.second][apart];
            const bool again = std::ranges::count(taken, value) > 0;
            taken.push_back(value);
            return again;
        });
    } else if (rough && order.size() > 2) {
        order.resize(2);
    }
    std::vector<Fitting<LevelFit>> fits;
    for (const auto& start : order) fits.push_back(improving(problem, from[start.second], effort, descents));
    if (jagged(candidate) && problem.omega > slower_level)
        fits.push_back(searching_slower_first(problem, from, effort));
    return fits;
}

LevelFit best_of(std::span<LevelFit> fits)
{
    LevelFit best;
    int evaluations = 0;
    for (auto& fit : fits) {
        evaluations += fit.evaluations;
        if (best.x.size() == 0 || fit.evaluation.objective < best.evaluation.objective) best = std::move(fit);
    }
    best.evaluations = evaluations;
    return best;
}

LevelFit best_of(const FitProblem& problem, const std::vector<Eigen::VectorXd>& from, int effort, int descents)
{
    auto fits = side_by_side(fits_from(problem, from, effort, descents));
    return best_of(fits);
}

Attribution as_screened(const Fit& fit, const Candidate& candidate, const LevelFit& screened)
{
    Attribution a;
    a.candidate = candidate;
    const std::vector<std::vector<double>> everywhere(levels.size(), in_si(candidate, screened.x, fit.scales));
    auto evaluations = evaluate_all(fit.cases, candidate, everywhere, {levels.begin(), levels.end()});
    for (std::size_t l = 0; l < levels.size(); ++l) {
        a.x[l] = screened.x;
        a.evaluation[l] = std::move(evaluations[l]);
    }
    a.evaluations = screened.evaluations + static_cast<int>(levels.size());
    a.information = screened.information;
    judge(a, fit.nominal);
    return a;
}

void polish_best(const Fit& context, std::vector<Attribution>& ranked, std::size_t most)
{
    constexpr int long_search = 40, short_search = 20;  // evaluations a parameter
    constexpr double wide = 0.3, narrow = 0.05;         // numerical: first steps
    const auto part = excerpts(context.cases, levels[1], refine_ticks, 1);
    std::vector<Attribution*> some;
    for (auto& a : ranked)
        if (some.size() < most && a.refined && jagged(a.candidate) && a.explained > policy::worth_a_long_search)
            some.push_back(&a);
    const auto search = [&](Attribution& a, std::size_t l, const Eigen::VectorXd& from, int effort, double step) {
        const auto fit = search_rough({part, a.candidate, context.scales, levels[l]}, from,
                                      effort * static_cast<int>(a.candidate.parameter_count()), step);
        a.evaluations += fit.evaluations + 1;
        auto there = evaluate(context.cases, a.candidate, in_si(a.candidate, fit.x, context.scales), levels[l]);
        if (there.objective < a.evaluation[l].objective) a.x[l] = fit.x, a.evaluation[l] = std::move(there);
    };
    context.parallel(some.size(), [&](std::size_t i) {
        Attribution& a = *some[i];
        search(a, 0, a.x[0], long_search, wide);
        for (std::size_t l = 1; l < levels.size(); ++l) search(a, l, a.x[l - 1], short_search, narrow);
        judge(a, context.nominal);
    });
    std::stable_sort(ranked.begin(), ranked.end(), better);
}

double screening_level(const Nominal& nominal)
{
    for (std::size_t l = 0; l < levels.size(); ++l) {
        double excess = 0;
        for (const auto& m : nominal.evaluation[l].records) excess = std::max({excess, m.position - 1, m.effort - 1});
        if (excess > policy::visible_excess) return levels[l];
    }
    return levels.back();
}

}  // namespace stickslip::gap
