#include "analysis/diagnosis/fit/fit.h"

#include "analysis/diagnosis/fit/candidate_numbers.h"
#include "analysis/diagnosis/fit/problem.h"
#include "analysis/diagnosis/fit/residuals.h"
#include "analysis/joint/drive.h"
#include "analysis/numerics/optimise.h"

#include <algorithm>
#include <cmath>

namespace stickslip::gap {
double reading_floor(const Case& c, double omega)
{
    const double passed_on = noise_amplification(omega, c.row_step);
    double floor = c.sigma;
    if (c.drive_sigma != 0) {
        const double kick = c.drive_sigma * c.row_step / flatten(c.joint).driven_inertia();
        floor = std::hypot(floor, kick * std::sqrt(kick_amplification(omega, c.row_step) / passed_on));
    }
    const auto nearest =
        std::ranges::min_element(levels, {}, [&](double level) { return std::abs(std::log(omega / level)); });
    const double by_load = c.load_sigma[static_cast<std::size_t>(nearest - levels.begin())];
    return by_load == 0 ? floor : std::hypot(floor, by_load / std::sqrt(passed_on));
}

double effort_floor(const Case& c, double omega)
{
    const double drag = push_of(c.joint.actuator, 0, c.joint.actuator.supply_voltage, 0).drag;
    return std::hypot(c.effort_sigma, drag * c.sigma * std::sqrt(velocity_noise_amplification(omega, c.row_step)));
}

double prior_cost(const Candidate& candidate, const Eigen::VectorXd& x)
{
    double cost = 0;
    for (Eigen::Index i = 0; i < x.size() && candidate.prior_weight > 0; ++i) {
        const auto parameter = static_cast<std::size_t>(i);
        if (const double sd = candidate.sd_of(parameter); sd > 0) {
            const double off = (x[i] - prior_mean(candidate, parameter)) / sd;
            cost += candidate.prior_weight * off * off;
        }
    }
    return cost;
}

Evaluation evaluate(const std::vector<Case>& cases, const Candidate& candidate, const std::vector<double>& si,
                    double omega, std::vector<double>* residuals)
{
    auto scaled = std::move(residuals_at(cases, candidate, {{si, omega}})[0]);
    Evaluation result = judged(cases, scaled);
    if (residuals) residuals->swap(scaled);
    return result;
}

std::vector<Evaluation> evaluate_all(const std::vector<Case>& cases, const Candidate& candidate,
                                     const std::vector<std::vector<double>>& si, const std::vector<double>& omega)
{
    std::vector<Place> places;
    for (std::size_t i = 0; i < si.size(); ++i) places.push_back({si[i], omega.size() == 1 ? omega[0] : omega[i]});
    std::vector<Evaluation> all;
    for (const auto& scaled : residuals_at(cases, candidate, places)) all.push_back(judged(cases, scaled));
    return all;
}

LevelFit search_rough(const FitProblem& problem, Eigen::VectorXd x, int evaluations, double first_step,
                      const Kept& kept)
{
    const Candidate& candidate = problem.candidate;
    LevelFit fit;
    const auto n = static_cast<Eigen::Index>(candidate.parameter_count());
    fit.x = bounded(candidate, std::move(x));
    std::vector<Eigen::Index> free;
    for (Eigen::Index i = 0; i < n; ++i)
        if (kept.empty() || !kept[static_cast<std::size_t>(i)]) free.push_back(i);
    int count = 0;
    Eigen::VectorXd at = fit.x;
    const auto objective = [&](const std::vector<double>& values) {
        ++count;
        for (std::size_t k = 0; k < free.size(); ++k) at[free[k]] = values[k];
        return problem.at(at).objective + prior_cost(candidate, at);
    };
    Minimisation rough{SearchMethod::simplex, {}, {}, evaluations};
    rough.ftol_rel = 1e-4;
    std::vector<double> start;
    for (const auto i : free) {
        const auto& p = candidate.parameter(static_cast<std::size_t>(i));
        rough.bounds.low.push_back(p.logarithmic ? std::log(p.low) : p.low);
        rough.bounds.high.push_back(p.logarithmic ? std::log(p.high) : p.high);
        rough.first_step.push_back(first_step * (p.logarithmic ? 1 : std::max(0.1, std::abs(p.prior))));
        start.push_back(fit.x[i]);
    }
    start = minimum(rough, objective, std::move(start));
    for (std::size_t k = 0; k < free.size(); ++k) fit.x[free[k]] = start[k];
    fit.evaluation = problem.at(fit.x);
    fit.evaluation.objective += prior_cost(candidate, fit.x);
    fit.information = Eigen::MatrixXd::Zero(n, n);
    fit.evaluations = count + 1;
    return fit;
}

}  // namespace stickslip::gap
