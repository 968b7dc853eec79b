#include "analysis/diagnosis/audit/audit_terms.h"

#include "analysis/diagnosis/audit/command_terms.h"
#include "analysis/joint/gains.h"
#include "analysis/numerics/line_search.h"

#include <algorithm>

namespace stickslip::gap {
namespace {

constexpr std::size_t most_changes = 3;
constexpr double enough = 1.2;        ///< times what every term together leaves: no further term is needed
constexpr double digits = 2e-5;       ///< of the command's rms, below which what is left is the file's digits
constexpr double understood = 2e-3;   ///< of the command's rms, below which the controller counts as understood
constexpr double much_better = 0.25;  ///< of what plain gains leave, before an undocumented term is believed
constexpr int zones = 28;

/// A dead zone and the linear changes beside it.
struct Changed {
    double dead_zone = 0;
    std::vector<int> terms;
    TermFit fit;
    std::size_t count(double documented) const { return terms.size() + (dead_zone != documented); }
};

/// All sets of `size` of the possible terms, `visit`ed in order.
template <class Visit>
void each_set(const CommandTerms& all, std::size_t size, std::vector<int>& chosen, int from, const Visit& visit)
{
    if (chosen.size() == size) return visit(chosen);
    for (int i = from; i < linear_terms; ++i) {
        if (!all.possible[static_cast<std::size_t>(i)]) continue;
        chosen.push_back(i);
        each_set(all, size, chosen, i + 1, visit);
        chosen.pop_back();
    }
}

/// The best set of at most `size` changes at this dead zone.
Changed best_set(const CommandTerms& all, double dead_zone, std::size_t size)
{
    Changed best;
    best.dead_zone = dead_zone;
    std::vector<int> chosen;
    each_set(all, size, chosen, 0, [&](const std::vector<int>& set) {
        const auto fit = fit_terms(all, set);
        if (fit.misfit < best.fit.misfit) best.fit = fit, best.terms = set;
    });
    return best;
}

/// The dead zone that leaves least, with at most one other change.
Changed best_zone(const std::vector<Case>& cases, double limit, double largest_error)
{
    const auto judged = [&](double zone) {
        const auto all = command_terms(cases, zone, limit);
        auto none = best_set(all, zone, 0);
        const auto one = best_set(all, zone, 1);
        return one.fit.misfit < 0.5 * none.fit.misfit ? one : none;
    };
    Changed best = judged(0);
    double low = 0, high = 0;
    double last = 0;
    for (int i = 0; i < zones; ++i) {
        const double zone = largest_error * std::pow(10, -3.0 * (zones - 1 - i) / (zones - 1));
        const auto at = judged(zone);
        if (at.fit.misfit < best.fit.misfit) best = at, low = last, high = zone * std::pow(10, 3.0 / (zones - 1));
        last = zone;
    }
    if (high == 0) return best;
    const double refined = least_between(low, high, [&](double zone) { return judged(zone).fit.misfit; });
    const auto at = judged(refined);
    return at.fit.misfit < best.fit.misfit ? at : best;
}

/// What is left with at most one change of the terms.
double left_by_one(const std::vector<Case>& cases, double limit)
{
    const double zone = cases[0].joint.control.dead_zone;
    const auto all = command_terms(cases, zone, limit);
    return std::min(best_set(all, zone, 0).fit.misfit, best_set(all, zone, 1).fit.misfit);
}

/// Sets a number of the controller, which enters the terms themselves, to what leaves least: `first`, or a value
/// between `from` and `to`. Back to `documented` where that leaves more than half of what the documented one does.
/// Gives the value, and the part of the squares that it takes.
template <class Set>
std::pair<double, double> best_number(std::vector<Case>& cases, double limit, double documented, double first,
                                      std::pair<double, double> range, const Set& set)
{
    constexpr double ratio = 1.4, much_less = 0.5;
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
    if (least < much_less * before) return {best, 1 - std::pow(least / before, 2)};
    set_all(documented);
    return {documented, 0};
}

/// A filter of the velocity that is not the documented one. Corrected in the cases.
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

/// A limit of the integral's share that is not the documented one. Corrected in the cases.
void find_integral_limit(std::vector<Case>& cases, double limit, Audit& result)
{
    constexpr double smallest = 0.01, largest = 2, unreached = 1e3;  // of the largest command
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
    if (1 - gain > much_better * much_better) return set_all(documented);
    const double limit_of_integral = found < largest * most ? found : infinity;
    set_all(limit_of_integral);
    result.findings.push_back({"gain-k_i", "gain-k_i.integral_limit", limit_of_integral, 0, Quantity::effort, gain});
}

/// How fast the reference has to be for a Coulomb feed-forward that the document lacks. Set in the cases.
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

double largest_error(const std::vector<Case>& cases)
{
    double largest = 0;
    for (const auto& c : cases)
        for (std::size_t k = 0; k < c.ticks.size(); ++k)
            largest = std::max(largest, std::abs(c.ticks.reference[k] - c.ticks.position[k]));
    return largest;
}

/// The fewest changes that leave no more than the most.
Changed fewest_changes(const std::vector<Case>& cases, double limit)
{
    const double documented = cases[0].joint.control.dead_zone;
    const auto all = command_terms(cases, documented, limit);
    std::vector<Changed> found;
    for (std::size_t size = 0; size <= most_changes; ++size) {
        found.push_back(best_set(all, documented, size));
        if (found.back().fit.misfit < digits) return found.back();
    }
    found.push_back(best_zone(cases, limit, largest_error(cases)));
    double least = infinity;
    for (const auto& f : found) least = std::min(least, f.fit.misfit);
    const Changed* best = nullptr;
    for (const auto& f : found)
        if (f.fit.misfit <= std::max(enough * least, digits) &&
            (!best || f.count(documented) < best->count(documented)))
            best = &f;
    return *best;
}

bool is_plain(const Control& c)
{
    const auto& f = c.feed_forward;
    return c.structure == Structure::pid && c.k_i == 0 && c.dead_zone == 0 && f.coulomb == 0 && f.acceleration == 0 &&
           f.velocity == 1 && !f.gravity;
}

/// Whether plain gains, a filter beside them, are all that changed.
bool of_plain_gains(const Changed& changed)
{
    for (int term : changed.terms)
        if (term != k_p_term && term != k_v_term) return false;
    return changed.dead_zone == 0;
}

void correct(Control& c, int term, double value, bool factor)
{
    auto& f = c.feed_forward;
    const double by = 1 + value;
    switch (term) {
        case k_p_term:
            (c.structure == Structure::cascade ? c.position_gain : c.k_p) *= by;
            break;
        case k_v_term:
            if (c.structure == Structure::cascade)
                c.velocity_gain *= by;
            else
                c.k_v = factor ? c.k_v * by : value;
            break;
        case k_i_term:
            if (!factor)
                (c.structure == Structure::cascade ? c.velocity_integral_gain : c.k_i) = value;
            else if (c.structure == Structure::pid)
                c.k_i *= by;
            else if (is_set(c.velocity_reset_time))
                c.velocity_reset_time /= by;
            else
                c.velocity_integral_gain *= by;
            break;
        case coulomb_term:
            f.coulomb += value;
            break;
        case acceleration_term:
            f.acceleration += value;
            break;
        case velocity_term:
            f.velocity += value;
            break;
        default:
            break;
    }
}

AuditFinding finding_of(int term, const TermFit& fit, bool factor, const Control& corrected, double gain)
{
    const auto i = static_cast<std::size_t>(term);
    const double value = fit.value[i], error = fit.error[i];
    const auto gain_of = [&](const char* effect, Quantity quantity) {
        const std::string name = effect;
        return factor ? AuditFinding{name, name + ".factor", 1 + value, error, Quantity::number, gain}
                      : AuditFinding{name, name + ".value", value, error, quantity, gain};
    };
    const auto& f = corrected.feed_forward;
    switch (term) {
        case k_p_term:
            return gain_of("gain-k_p", Quantity::stiffness);
        case k_v_term:
            return gain_of("gain-k_v", Quantity::damping);
        case k_i_term:
            return gain_of("gain-k_i",
                           corrected.structure == Structure::cascade ? Quantity::stiffness : Quantity::integral_gain);
        case coulomb_term:
            return {"feed-forward", "feed-forward.coulomb", f.coulomb, error, Quantity::effort, gain};
        case acceleration_term:
            return {"feed-forward", "feed-forward.acceleration", f.acceleration, error, Quantity::inertia, gain};
        default:
            return {"feed-forward", "feed-forward.velocity", f.velocity, error, Quantity::number, gain};
    }
}

/// The rms of an added term over that of the command.
double part_of_command(const CommandTerms& all, int term, double value)
{
    double square = 0;
    for (const auto& row : all.rows) square += std::pow(value * row.change[static_cast<std::size_t>(term)], 2);
    return std::sqrt(square / all.square);
}

}  // namespace

bool audit_terms(std::vector<Case>& cases, double limit, Audit& result)
{
    const Control documented = cases[0].joint.control;
    const bool plain = is_plain(documented);
    const auto as_documented = command_terms(cases, documented.dead_zone, limit);
    if (as_documented.rows.empty()) return false;
    const double before = fit_terms(as_documented, {}).misfit;
    const double with_gains = plain ? fit_terms(as_documented, {k_p_term, k_v_term}).misfit : before;
    if (plain && std::min(before, with_gains) < digits) return false;
    const bool filtered = gains_of(documented).k_v != 0 && documented.velocity_estimate.form != EstimateForm::exact &&
                          !result.filter_seen;
    if (!plain && filtered && before > digits) find_filter(cases, limit, result);
    if (as_documented.integrates && left_by_one(cases, limit) > digits) find_integral_limit(cases, limit, result);
    if (documented.feed_forward.coulomb == 0 && left_by_one(cases, limit) > digits) find_coulomb_speed(cases, limit);
    const Changed changed = fewest_changes(cases, limit);
    const bool believed = changed.fit.misfit < std::min(understood, much_better * with_gains);
    const bool of_coulomb = std::ranges::count(changed.terms, coulomb_term) > 0;
    if (!of_coulomb || (plain && !believed))
        for (auto& c : cases) c.joint.control.feed_forward.coulomb_speed = documented.feed_forward.coulomb_speed;
    if (plain && (of_plain_gains(changed) || !believed)) return false;
    result.residual_after = changed.fit.misfit;
    result.command_explained = changed.fit.misfit < understood;
    if (!result.command_explained && changed.fit.misfit > much_better * before) {
        result.notes.push_back({.code = Note::Code::command_unknown, .values = {before}});
        return true;
    }
    const double gain = 1 - std::pow(changed.fit.misfit / before, 2);
    const auto all = command_terms(cases, changed.dead_zone, limit);
    for (const int term : changed.terms) {
        const auto i = static_cast<std::size_t>(term);
        const bool factor = all.factor[i];
        const double size = factor ? std::abs(changed.fit.value[i]) : part_of_command(all, term, changed.fit.value[i]);
        if (size < flagged_gain) continue;
        for (auto& c : cases) correct(c.joint.control, term, changed.fit.value[i], factor);
        result.findings.push_back(finding_of(term, changed.fit, factor, cases[0].joint.control, gain));
    }
    if (changed.dead_zone != documented.dead_zone) {
        for (auto& c : cases) c.joint.control.dead_zone = changed.dead_zone;
        result.findings.push_back({"dead-zone", "dead-zone.width", changed.dead_zone, 0, Quantity::position, gain});
    }
    if (!result.command_explained)
        result.notes.push_back({.code = Note::Code::terms_to, .values = {100 * result.residual_after}});
    return true;
}

}  // namespace stickslip::gap
