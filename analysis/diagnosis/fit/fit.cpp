#include "analysis/diagnosis/fit/fit.h"

#include "analysis/diagnosis/fit/candidate_numbers.h"
#include "analysis/diagnosis/fit/residuals.h"
#include "analysis/joint/drive.h"

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

}  // namespace stickslip::gap
