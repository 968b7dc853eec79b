#include "analysis/diagnosis/audit/audit_numbers.h"

#include "analysis/diagnosis/audit/command_terms.h"
#include "analysis/diagnosis/audit/term_sets.h"
#include "analysis/diagnosis/policy/audit.h"
#include "analysis/joint/gains.h"
#include "analysis/numerics/line_search.h"

#include <algorithm>

namespace stickslip::gap {
namespace {

/// Sets a number of the controller, which enters the terms themselves, to what leaves least: `first`, or a value
/// between `from` and `to`. Back to `documented` where that leaves more than `policy::much_less` of what the documented
/// one does. Gives the value, and the part of the squares that it takes.
template <class Set>
std::pair<double, double> best_number(std::vector<Case>& cases, double limit, double documented, double first,
                                      std::pair<double, double> range, const Set& set)
{
    constexpr double ratio = 1.4;  // numerical: of the scan
    const auto set_all = [&](double value) {
        for (auto& c : cases) set(c.joint.control, value);
    };
    const auto misfit = [&](double value) {
        set_all(value);
        return left_by_one(cases, limit);
    };
    const double before = misfit(documented);
    double best = first, least = misfit(first), low = first, high = range.first;
    for (double value = range.first; value < range.second; value *= ratio)
        if (const double m = misfit(value); m < least)
            least = m, best = value, low = value / ratio, high = value * ratio;
    if (const double refined = least_between(low, high, misfit); misfit(refined) < least) best = refined;
    least = misfit(best);
    if (least < policy::much_less * before) return {best, 1 - std::pow(least / before, 2)};
    set_all(documented);
    return {documented, 0};
}

}  // namespace

double left_by_one(const std::vector<Case>& cases, double limit)
{
    const double zone = cases[0].joint.control.dead_zone;
    const auto all = command_terms(cases, zone, limit);
    return std::min(best_set(all, zone, 0).fit.misfit, best_set(all, zone, 1).fit.misfit);
}

void find_filter(std::vector<Case>& cases, double limit, Audit& result)
{
    const double documented = cases[0].joint.control.velocity_estimate.tau, tick = cases[0].ticks.step[0];
    const auto set = [](Control& c, double tau) { c.velocity_estimate.tau = tau; };
    const auto [tau, gain] = best_number(cases, limit, documented, 0, {0.1 * tick, 400 * tick}, set);
    if (gain > 0 && filters_differently(documented, tau, tick))
        result.findings.push_back({"velocity-filter", "velocity-filter.tau", tau, 0, Quantity::time, gain});
    else
        for (auto& c : cases) set(c.joint.control, documented);
}

void find_integral_limit(std::vector<Case>& cases, double limit, Audit& result)
{
    constexpr double smallest = 0.01, largest = 2, unreached = 1e3;  // numerical: of the largest command; the scan
    double most = 0;
    for (const auto& c : cases)
        for (std::size_t k = 0; k < c.ticks.size(); ++k)
            if (is_set(c.ticks.command[k])) most = std::max(most, std::abs(c.ticks.command[k]));
    if (!(most > 0)) return;
    const double documented = cases[0].joint.control.integral_limit;
    const auto set = [](Control& c, double value) { c.integral_limit = value; };
    const auto set_all = [&](double value) {
        for (auto& c : cases) set(c.joint.control, value);
    };
    const auto [found, gain] = best_number(cases, limit, std::min(documented, unreached * most), unreached * most,
                                           {smallest * most, largest * most}, set);
    if (1 - gain > policy::much_better * policy::much_better) return set_all(documented);
    const double limit_of_integral = found < largest * most ? found : infinity;
    set_all(limit_of_integral);
    result.findings.push_back({"gain-k_i", "gain-k_i.integral_limit", limit_of_integral, 0, Quantity::command, gain});
}

void find_coulomb_speed(std::vector<Case>& cases, double limit)
{
    double fastest = 0;
    for (const auto& c : cases)
        for (const double rate : c.ticks.reference_rate) fastest = std::max(fastest, std::abs(rate));
    if (!(fastest > 0)) return;
    const double usual = cases[0].joint.control.feed_forward.coulomb_speed;
    best_number(cases, limit, usual, usual, {1e-4 * fastest, 2 * fastest},
                [](Control& c, double speed) { c.feed_forward.coulomb_speed = speed; });
}

}  // namespace stickslip::gap
