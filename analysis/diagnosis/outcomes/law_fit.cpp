#include "analysis/diagnosis/outcomes/law_fit.h"

#include "analysis/diagnosis/outcomes/law_cost.h"
#include "analysis/diagnosis/outcomes/side.h"
#include "analysis/diagnosis/policy/outcomes_and_rigs.h"
#include "analysis/numerics/optimise.h"

#include <algorithm>
#include <cmath>

namespace stickslip::gap {
namespace {

constexpr double least_softness = 0.02, most_softness = 0.6;  // numerical: range of a fitted number
constexpr int folds = 5;
constexpr double usual_rows = 40;  // numerical: a longer table has fewer evaluations a fit

/// Rows in the order of their settings, dealt out in turn: every fold spans the whole table.
std::vector<int> dealt(const Outcomes& o)
{
    auto order = all_rows(o);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        const auto &x = o.table.rows[a], &y = o.table.rows[b];
        return x.stick_slip != y.stick_slip ? x.stick_slip < y.stick_slip : x.settings < y.settings;
    });
    std::vector<int> fold(o.size());
    for (std::size_t i = 0; i < order.size(); ++i) fold[order[i]] = static_cast<int>(i % folds);
    return fold;
}

Bounds bounds_of(const RivalLaw& rival)
{
    Bounds b;
    for (const auto& n : rival.numbers) b.low.push_back(n.low), b.high.push_back(n.high);
    b.low.push_back(std::log(least_softness)), b.high.push_back(std::log(most_softness));
    return b;
}

std::vector<double> descended(const Objective& objective, const Bounds& bounds, std::vector<double> x, int evaluations)
{
    x = local_minimum(objective, bounds, std::move(x), 0.1, evaluations);
    return local_minimum(objective, bounds, std::move(x), 0.02, evaluations / 2);
}

}  // namespace

double probability_at(double distance, double softness)
{
    if (std::isnan(distance)) return 0.5;
    return policy::wrong_rows / 2 +
           (1 - policy::wrong_rows) / (1 + std::exp(-std::clamp(distance / softness, -50.0, 50.0)));
}

Joint with_law(const Joint& joint, const FrictionLaw& law)
{
    Joint changed = joint;
    changed.friction = {};
    changed.friction.law = law;
    return changed;
}

LawFit fit_law(const Outcomes& o, const RivalLaw& rival)
{
    LawFit fit;
    fit.rival = &rival;
    const auto bounds = bounds_of(rival);
    const double share = rival.effort * std::clamp(usual_rows / static_cast<double>(o.size()), 0.1, 1.0);
    const auto work = [&](double evaluations) { return std::max(20, static_cast<int>(evaluations * share)); };
    const auto rows = all_rows(o);
    const Objective whole = [&](const std::vector<double>& x) { return cost(o, rival, rows, x); };
    fit.x = descended(whole, bounds, global_minimum(whole, bounds, work(2500)), work(1200));
    fit.law = rival.make(o.scales, fit.x.data());
    fit.softness = std::exp(fit.x.back());
    fit.values = rival.values(fit.law);
    fit.standard_error = standard_errors(o, rival, fit.x);
    fit.distance = distances(o, fit.law, rows);
    fit.probability.resize(o.size());
    const auto fold = dealt(o);
    for (int f = 0; f < folds; ++f) {
        std::vector<std::size_t> in, out;
        for (std::size_t i : rows) (fold[i] == f ? out : in).push_back(i);
        const Objective part = [&](const std::vector<double>& x) { return cost(o, rival, in, x); };
        const auto x = local_minimum(part, bounds, fit.x, 0.05, work(600));
        const auto d = distances(o, rival.make(o.scales, x.data()), out);
        for (std::size_t k = 0; k < out.size(); ++k) fit.probability[out[k]] = probability_at(d[k], std::exp(x.back()));
    }
    fit.amplitude.assign(o.size(), not_set);
    judge(o, fit);
    return fit;
}

LawFit judge_nominal_law(const Outcomes& o, const Joint& nominal)
{
    LawFit fit;
    fit.law = nominal.friction.law;
    for (const auto& joint : o.joints) fit.distance.push_back(distance_to_stick_slip(joint));
    const Objective by_softness = [&](const std::vector<double>& x) {
        double sum = 0;
        for (std::size_t i = 0; i < o.size(); ++i)
            sum -= log_probability(probability_at(fit.distance[i], std::exp(x[0])), o.table.rows[i].stick_slip);
        return sum;
    };
    const Bounds bounds{{std::log(least_softness)}, {std::log(most_softness)}};
    fit.softness = std::exp(global_minimum(by_softness, bounds, 100)[0]);
    for (double d : fit.distance) fit.probability.push_back(probability_at(d, fit.softness));
    fit.amplitude.assign(o.size(), not_set);
    judge(o, fit);
    return fit;
}

}  // namespace stickslip::gap
