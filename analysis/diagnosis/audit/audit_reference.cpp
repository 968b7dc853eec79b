#include "analysis/diagnosis/audit/audit_reference.h"

#include "analysis/diagnosis/audit/regression.h"
#include "analysis/diagnosis/fit/reference.h"
#include "analysis/diagnosis/plant/controller.h"
#include "analysis/diagnosis/policy/audit.h"
#include "analysis/numerics/line_search.h"

#include <algorithm>
#include <cmath>

namespace stickslip::gap {
namespace {

/// Fourth differences of the command, and of what it is computed from; rows whose stencil a limit touches are left
/// out.
GainRegression differences(const Case& c, double tau, double limit)
{
    Control control = c.joint.control;
    control.velocity_estimate.tau = tau;
    Controller controller(control);
    const Ticks& t = c.ticks;
    std::vector<double> y, v, u;
    for (std::size_t k = 0; k < t.size(); ++k) {
        const double exact = is_set(t.velocity[k]) ? t.velocity[k] : 0;
        controller.read(t.position[k], k == 0 ? t.step[0] : t.step[k - 1], exact);
        if (!t.logged[k]) continue;
        const bool usable =
            is_set(t.command[k]) && std::abs(t.command[k]) < policy::below_limit * limit && t.enabled[k];
        y.push_back(t.position[k]), v.push_back(controller.velocity());
        u.push_back(usable ? t.command[k] - t.added(k) : not_set);
    }
    GainRegression d;
    const auto fourth = [](const std::vector<double>& x, std::size_t k) {
        return x[k] - 4 * x[k - 1] + 6 * x[k - 2] - 4 * x[k - 3] + x[k - 4];
    };
    // on a coarse grid most readings repeat: rows where nothing changed tell of the reference, not of the
    // controller
    constexpr double nothing = 1e-6;  // numerical: of the largest difference
    double largest = 0;
    for (std::size_t k = 4; k < y.size(); ++k) largest = std::max(largest, std::abs(fourth(y, k)));
    for (std::size_t k = 4; k < u.size(); ++k)
        if (const double du = fourth(u, k), dy = fourth(y, k); is_set(du) && std::abs(dy) > nothing * largest)
            d.add(-dy, -fourth(v, k), du);
    return d;
}

/// Least squares of D⁴u on −D⁴y and −D⁴v, three times, each without what the last one found to be far off.
GainRegression::Answer regress(const GainRegression& d, bool with_k_v)
{
    GainRegression::Answer g;
    const std::size_t n = d.rows().size();
    constexpr std::size_t few = 100;  // numerical: rows of a regression
    if (n < few) return g;
    double within = infinity;
    for (int round = 0; round < 3; ++round) {
        const auto last = g;
        g = d.solve(with_k_v, [&](const auto& row) { return std::abs(GainRegression::left(row, last)) <= within; });
        if (g.used < policy::most_rows * static_cast<double>(n) || g.both != with_k_v) return {};
        std::vector<double> sizes;
        for (const auto& row : d.rows()) sizes.push_back(std::abs(GainRegression::left(row, g)));
        const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(n / 2);
        std::nth_element(sizes.begin(), middle, sizes.end());
        constexpr double outlier = 8;  // numerical: medians, beyond which a row is left out of a fit
        within = std::max(outlier * *middle, 1e-12 * g.rms);
    }
    return g;
}

double misfit_of(const std::vector<Case>& cases, double tau, double limit)
{
    double sum = 0;
    for (const auto& c : cases) sum += regress(differences(c, tau, limit), true).misfit;
    return sum / static_cast<double>(cases.size());
}

/// The filter time constant with the least misfit.
double best_tau(const std::vector<Case>& cases, double limit)
{
    const double tick = cases[0].ticks.step[0];
    const auto misfit = [&](double tau) { return misfit_of(cases, tau, limit); };
    double best = 0, least = misfit(0), low = 0, high = 0.1 * tick;
    constexpr double ratio = 1.4;  // numerical: of the scan
    for (double tau = 0.1 * tick; tau < 100 * tick; tau *= ratio)
        if (const double m = misfit(tau); m < least) least = m, best = tau, low = tau / ratio, high = tau * ratio;
    const double refined = least_between(low, high, misfit);
    return misfit(refined) < least ? refined : best;
}

/// One gain of all records: mean factor on the documented one, and the error of that mean.
struct Factor {
    double value = 1, error = 0;
    bool off() const
    {
        return std::abs(value - 1) > std::max(policy::flagged_gain, policy::flagged_gain_errors * error);
    }
};

}  // namespace

void audit_without_reference(std::vector<Case>& cases, double limit, Audit& result)
{
    const Control documented = cases[0].joint.control;
    if (!is_plain(documented)) return result.notes.push_back({Note::Code::controller_unseen});
    const bool damped = documented.k_v != 0;
    const bool filtered = damped && documented.velocity_estimate.form != EstimateForm::exact;
    double tau = documented.velocity_estimate.tau;
    if (filtered && !result.filter_seen) {
        const double before = misfit_of(cases, tau, limit), found = best_tau(cases, limit);
        const double after = misfit_of(cases, found, limit);
        if (after < policy::much_less * before && after < policy::rough_command &&
            filters_differently(tau, found, cases[0].ticks.step[0])) {
            tau = found;
            result.findings.push_back(
                {"velocity-filter", "velocity-filter.tau", tau, 0, Quantity::time, 1 - std::pow(after / before, 2)});
        }
    }
    Factor k_p{0}, k_v{0};
    const auto n = static_cast<double>(cases.size());
    for (const auto& c : cases) {
        const auto g = regress(differences(c, tau, limit), damped);
        if (g.misfit > policy::rough_command || c.joint.control.k_p == 0) return;
        k_p.value += g.k_p / c.joint.control.k_p / n;
        k_p.error = std::hypot(k_p.error, g.k_p_error / c.joint.control.k_p / n);
        if (!damped) continue;
        k_v.value += g.k_v / c.joint.control.k_v / n;
        k_v.error = std::hypot(k_v.error, g.k_v_error / c.joint.control.k_v / n);
    }
    result.command_explained = true;
    result.notes.push_back({Note::Code::reference_rebuilt});
    if (k_p.off())
        result.findings.push_back({"gain-k_p", "gain-k_p.factor", k_p.value, k_p.error, Quantity::number, 1});
    if (damped && k_v.off())
        result.findings.push_back({"gain-k_v", "gain-k_v.factor", k_v.value, k_v.error, Quantity::number, 1});
    for (auto& c : cases) {
        if (k_p.off()) c.joint.control.k_p *= k_p.value;
        if (damped && k_v.off()) c.joint.control.k_v *= k_v.value;
        c.joint.control.velocity_estimate.tau = tau;
        rebuild_reference(c, limit);
    }
}

}  // namespace stickslip::gap
