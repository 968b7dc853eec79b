#include "analysis/gap/audit_filter.h"

#include "analysis/gap/controller.h"
#include "analysis/gap/line_search.h"

#include <algorithm>
#include <cmath>

namespace stickslip::gap {
namespace {

constexpr double exact_velocity = 1e-3;  // misfit over rms of the steps of the velocity

struct Recursion {
    double gain = 0, misfit = 1;
};

/// Least squares of v_k − v_{k−1} on d_k − v_{k−1} over all records.
Recursion recursion_of(const std::vector<Case>& cases)
{
    double ab = 0, aa = 0, bb = 0;
    for (const auto& c : cases) {
        const Ticks& t = c.ticks;
        Control unfiltered = c.joint.control;
        unfiltered.velocity_estimate.tau = 0;
        Controller controller(unfiltered);
        for (std::size_t k = 0; k < t.size(); ++k) {
            controller.read(t.position[k], k == 0 ? t.step[0] : t.step[k - 1], 0);
            if (k == 0) continue;
            const double a = controller.velocity() - t.velocity[k - 1], b = t.velocity[k] - t.velocity[k - 1];
            if (std::isfinite(a) && std::isfinite(b)) ab += a * b, aa += a * a, bb += b * b;
        }
    }
    if (aa == 0 || bb == 0) return {};
    return {ab / aa, std::sqrt(std::max(0.0, 1 - ab * ab / aa / bb))};
}

/// Mean distance of the readings between the rows from the encoder's grid, in steps: a quarter where they know nothing
/// of it.
double off_grid(const std::vector<Case>& cases, double tau)
{
    double sum = 0, n = 0;
    for (const auto& c : cases)
        for (double y : halves(c.ticks, tau)) {
            const double steps = y / c.joint.sensor.encoder_quantum;
            sum += std::abs(steps - std::round(steps)), n += 1;
        }
    return n > 0 ? sum / n : 0.25;
}

/// The time constant with which the readings between the rows lie nearest to the grid.
double tau_of_halves(const std::vector<Case>& cases)
{
    const double tick = cases[0].ticks.step[0];
    const auto distance = [&](double tau) { return off_grid(cases, tau); };
    // the right one stands alone within some hundredths of τ + T
    constexpr double ratio = 1.02, longest = 100;  // ticks
    double best = 0, least = distance(0);
    for (double sum = tick * ratio; sum < longest * tick; sum *= ratio)
        if (const double d = distance(sum - tick); d < least) least = d, best = sum - tick;
    const double width = (ratio - 1) * (best + tick);
    const double refined = least_between(std::max(0.0, best - width), best + width, distance);
    return distance(refined) < least ? refined : best;
}

void correct(std::vector<Case>& cases, double tau, Audit& result)
{
    result.findings.push_back({"velocity-filter", "velocity-filter.tau", tau, 0, Quantity::time, 1});
    for (auto& c : cases) {
        c.joint.control.velocity_estimate.tau = tau;
        if (c.ticks.rebuilt) rebuild_halves(c.ticks, c.joint);
    }
}

}  // namespace

void audit_filter(std::vector<Case>& cases, Audit& result)
{
    const Control documented = cases[0].joint.control;
    const double tick = cases[0].ticks.step[0], tau = documented.velocity_estimate.tau;
    const auto all = [&](auto&& holds) { return std::all_of(cases.begin(), cases.end(), holds); };
    if (documented.k_v == 0 || documented.velocity_estimate.form != EstimateForm::backward_difference ||
        !all([&](const Case& c) { return c.ticks.regular && c.ticks.has_velocity && c.ticks.size() > 100; }))
        return;
    if (all([](const Case& c) { return c.ticks.ticks_per_row == 1; })) {
        const auto seen = recursion_of(cases);
        if (seen.misfit > exact_velocity || seen.gain <= 0 || seen.gain > 1 + exact_velocity) return;
        result.filter_seen = true;
        const double found = tick * std::max(0.0, 1 / seen.gain - 1);
        if (filters_differently(tau, found, tick)) correct(cases, found, result);
    } else if (all([](const Case& c) { return c.ticks.rebuilt; })) {
        // without a grid any reading between the rows could be one
        if (!all([](const Case& c) { return c.joint.sensor.encoder_quantum > 0; })) return;
        constexpr double on_grid = 0.05;
        const double found = off_grid(cases, tau) < on_grid ? tau : tau_of_halves(cases);
        result.filter_seen = off_grid(cases, found) < on_grid;
        if (result.filter_seen && filters_differently(tau, found, tick)) correct(cases, found, result);
    }
}

}  // namespace stickslip::gap
