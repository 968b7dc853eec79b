#include "analysis/diagnosis/audit/gain_regression.h"

#include "analysis/diagnosis/audit/after_hole.h"
#include "analysis/diagnosis/plant/controller.h"
#include "analysis/diagnosis/policy/audit.h"
#include "analysis/numerics/line_search.h"

#include <algorithm>
#include <cmath>

namespace stickslip::gap {

GainRegression regression_of(const Case& c, double tau, double limit)
{
    GainRegression rows;
    Control control = c.joint.control;
    control.velocity_estimate.tau = tau;
    Controller controller(control);
    const Ticks& t = c.ticks;
    const bool believed = t.velocity_believed();
    // at a kink or a step of the reference its rate is anybody's guess unless it was logged
    constexpr double bent = 0.02;  // numerical: of the largest rate; which rows are compared
    double fastest = 0;
    for (double rate : t.reference_rate) fastest = std::max(fastest, std::abs(rate));
    const auto kinked = [&](std::size_t k) {
        if (k == 0 || k + 1 >= t.size()) return true;
        const double before = (t.reference[k] - t.reference[k - 1]) / t.step[k - 1],
                     after = (t.reference[k + 1] - t.reference[k]) / t.step[k];
        return std::abs(after - before) > bent * fastest;
    };
    AfterHole hole(t, control);
    for (std::size_t k = 0; k < t.size(); ++k) {
        const bool blind = hole.holds(k);
        const double exact = is_set(t.velocity[k]) ? t.velocity[k] : 0;
        controller.read(t.position[k], k == 0 ? t.step[0] : t.step[k - 1], exact);
        if (believed && is_set(t.velocity[k])) controller.believe(t.velocity[k]);
        if (blind || !is_set(t.command[k]) || std::abs(t.command[k]) > policy::below_limit * limit || !t.enabled[k])
            continue;
        if (control.reference_velocity && control.k_v != 0 && kinked(k)) continue;
        const double rate = control.reference_velocity ? t.reference_rate[k] : 0;
        rows.add(t.reference[k] - t.position[k], rate - controller.velocity(), t.command[k] - t.added(k));
    }
    return rows;
}

double best_tau(const std::vector<Case>& cases, double limit)
{
    const double tick = cases[0].ticks.step[0];
    const auto misfit = [&](double tau) {
        double worst = 0;
        for (const auto& c : cases) worst += regression_of(c, tau, limit).solve(true).misfit;
        return worst;
    };
    double best = 0, least = misfit(0);
    double low = 0, high = tick;
    for (double tau = 0.1 * tick; tau < 400 * tick; tau *= 1.4)
        if (const double m = misfit(tau); m < least) least = m, best = tau, low = tau / 1.4, high = tau * 1.4;
    const double refined = least_between(low, high, misfit);
    return misfit(refined) < least ? refined : best;
}

std::vector<GainRegression::Answer> gains_of(const std::vector<Case>& cases, double tau, double limit)
{
    std::vector<GainRegression::Answer> answers;
    for (const auto& c : cases) answers.push_back(regression_of(c, tau, limit).solve(c.joint.control.k_v != 0));
    return answers;
}

double mean_misfit(const std::vector<GainRegression::Answer>& answers)
{
    double sum = 0;
    for (const auto& a : answers) sum += a.misfit;
    return sum / static_cast<double>(answers.size());
}

}  // namespace stickslip::gap
