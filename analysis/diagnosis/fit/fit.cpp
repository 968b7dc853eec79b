#include "analysis/diagnosis/fit/fit.h"

#include "analysis/diagnosis/fit/candidate_numbers.h"

#include "analysis/diagnosis/fit/block.h"
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

LevelFit descend(const std::vector<Case>& cases, const Candidate& candidate, const Scales& scales, Eigen::VectorXd x,
                 double omega, int iterations)
{
    return descend_block(cases, candidate, scales, std::move(x), omega, iterations, {});
}

// In one piece: Levenberg-Marquardt over blocks: one loop whose state all of it needs.
LevelFit descend_block(const std::vector<Case>& cases, const Candidate& candidate, const Scales& scales,
                       Eigen::VectorXd x, double omega, int iterations, const Kept& kept)
{
    LevelFit fit;
    const auto n = static_cast<Eigen::Index>(candidate.parameter_count());
    fit.x = bounded(candidate, std::move(x));
    fit.information = Eigen::MatrixXd::Zero(n, n);
    std::vector<double> here, weights;
    const auto evaluated = [&](const Eigen::VectorXd& at, std::vector<double>& residuals) {
        auto found = evaluate(cases, candidate, in_si(candidate, at, scales), omega, &residuals);
        found.objective += prior_cost(candidate, at);
        ++fit.evaluations;
        return found;
    };
    fit.evaluation = evaluated(fit.x, here);
    double damping = 1e-3;
    Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(here.size()), n);
    LevelFit best = fit;
    Eigen::VectorXd last = fit.x;  // where the step came from; at first, where the effect is absent
    for (Eigen::Index i = 0; i < n; ++i)
        if (candidate.parameter(static_cast<std::size_t>(i)).vanishes) last[i] = 0;
    constexpr int most_halvings = 10;
    int halvings = 0;
    // numbers with a prior hardly move: their slopes are found anew every few steps, and where a step fails
    constexpr int worn_after = 3;
    int age = 0;
    const auto slopes_at_x = [&] {
        std::vector<Place> places;
        std::vector<double> steps;
        for (Eigen::Index i = 0; i < n; ++i) {
            const auto parameter = static_cast<std::size_t>(i);
            if (!kept.empty() && kept[parameter]) continue;
            if (age > 0 && candidate.sd_of(parameter) > 0) continue;
            Eigen::VectorXd shifted = fit.x;
            double step = 1e-4 * std::max(0.1, std::abs(candidate.parameter(parameter).prior));
            if (candidate.parameter(parameter).logarithmic) step = 1e-4;
            shifted[i] += step;
            if (bounded(candidate, shifted)[i] != shifted[i]) shifted[i] -= 2 * step, step = -step;
            places.push_back({in_si(candidate, shifted, scales), omega, parameter});
            steps.push_back(step);
        }
        const Eigen::Map<const Eigen::VectorXd> r(here.data(), static_cast<Eigen::Index>(here.size()));
        const auto moved = residuals_at(cases, candidate, places, &here);
        Eigen::Index lost = n;
        for (std::size_t k = 0; k < places.size(); ++k) {
            const auto i = static_cast<Eigen::Index>(places[k].moved);
            jacobian.col(i) = (Eigen::Map<const Eigen::VectorXd>(moved[k].data(), r.size()) - r) / steps[k];
            if (lost == n && candidate.parameter(places[k].moved).vanishes && last[i] != fit.x[i] &&
                jacobian.col(i).isZero(0))
                lost = i;
        }
        fit.evaluations += static_cast<int>(places.size());
        return lost;
    };
    for (int iteration = 0; iteration < iterations && n > 0; ++iteration) {
        for (Eigen::Index lost; (lost = slopes_at_x()) < n && halvings < most_halvings; ++halvings) {
            // friction that has been taken away altogether has no slope that leads back: half way, and all slopes anew
            fit.x[lost] = 0.5 * (fit.x[lost] + last[lost]);
            fit.evaluation = evaluated(fit.x, here);
        }
        const Eigen::Map<const Eigen::VectorXd> r(here.data(), static_cast<Eigen::Index>(here.size()));
        block_weights(cases, here, weights);
        const Eigen::Map<const Eigen::VectorXd> w(weights.data(), r.size());
        const Eigen::MatrixXd weighted = w.asDiagonal() * jacobian;
        Eigen::MatrixXd normal = jacobian.transpose() * weighted;
        Eigen::VectorXd gradient = weighted.transpose() * r;
        for (Eigen::Index i = 0; i < n && candidate.prior_weight > 0; ++i)
            if (const double sd = candidate.sd_of(static_cast<std::size_t>(i)); sd > 0) {
                const double row = candidate.prior_weight * static_cast<double>(cases.size()) / (sd * sd);
                normal(i, i) += row;
                gradient[i] += row * (fit.x[i] - prior_mean(candidate, static_cast<std::size_t>(i)));
            }
        fit.information = normal;
        bool better = false;
        const double before = fit.evaluation.objective;
        const auto damped_step = [&](double by) -> Eigen::VectorXd {
            Eigen::MatrixXd damped = normal;
            damped.diagonal() += by * normal.diagonal();
            damped.diagonal().array() += 1e-12 * std::max(1e-12, normal.diagonal().maxCoeff());
            Eigen::VectorXd step = damped.ldlt().solve(-gradient);
            for (Eigen::Index i = 0; i < n; ++i) {
                const bool logarithmic = candidate.parameter(static_cast<std::size_t>(i)).logarithmic;
                const double longest = logarithmic ? 1.5 : std::max(1.0, std::abs(fit.x[i]));
                step[i] = std::isfinite(step[i]) ? std::clamp(step[i], -longest, longest) : 0;
            }
            return bounded(candidate, fit.x + step);
        };
        // the first trial mostly succeeds; where it fails the more damped ones go side by side
        constexpr int first = 1, others = 4;
        for (int count = first; !better; count = others) {
            std::vector<Place> places;
            std::vector<Eigen::VectorXd> next;
            for (double by = damping; static_cast<int>(next.size()) < count; by = std::max(1e-3, by) * 8) {
                next.push_back(damped_step(by));
                places.push_back({in_si(candidate, next.back(), scales), omega});
            }
            auto there = residuals_at(cases, candidate, places);
            for (std::size_t k = 0; k < next.size() && !better; ++k) {
                ++fit.evaluations;
                auto trial = judged(cases, there[k]);
                trial.objective += prior_cost(candidate, next[k]);
                better = trial.objective < fit.evaluation.objective;
                if (!better) {
                    damping = std::max(1e-3, damping) * 8;
                    continue;
                }
                last = fit.x;
                fit.x = next[k];
                fit.evaluation = std::move(trial);
                here.swap(there[k]);
                damping = std::max(1e-7, damping * 0.2);
            }
            if (count == others) break;
        }
        if (fit.evaluation.objective <= best.evaluation.objective)
            best.x = fit.x, best.evaluation = fit.evaluation, best.information = fit.information;
        constexpr double least_fall = 2e-4;  // of the objective in one step: less is its end
        const bool done = !better || before - fit.evaluation.objective < least_fall * before;
        if (done && age == 0) break;
        if (!better) damping = 1e-3;  // worn slopes failed, not the step
        age = done || age + 1 == worn_after ? 0 : candidate.prior_weight > 0 ? age + 1 : 0;
    }
    best.evaluations = fit.evaluations;
    return best;
}

LevelFit search_rough(const std::vector<Case>& cases, const Candidate& candidate, const Scales& scales,
                      Eigen::VectorXd x, double omega, int evaluations, double first_step)
{
    return search_block(cases, candidate, scales, std::move(x), omega, evaluations, first_step, {});
}

LevelFit search_block(const std::vector<Case>& cases, const Candidate& candidate, const Scales& scales,
                      Eigen::VectorXd x, double omega, int evaluations, double first_step, const Kept& kept)
{
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
        return evaluate(cases, candidate, in_si(candidate, at, scales), omega).objective + prior_cost(candidate, at);
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
    fit.evaluation = evaluate(cases, candidate, in_si(candidate, fit.x, scales), omega);
    fit.evaluation.objective += prior_cost(candidate, fit.x);
    fit.information = Eigen::MatrixXd::Zero(n, n);
    fit.evaluations = count + 1;
    return fit;
}

}  // namespace stickslip::gap
