#include "analysis/diagnosis/audit/slow_log.h"

#include "analysis/diagnosis/audit/command_terms.h"
#include "analysis/diagnosis/audit/term_findings.h"
#include "analysis/diagnosis/audit/term_sets.h"
#include "analysis/diagnosis/policy/audit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>

namespace stickslip::gap {
namespace {

/// numerical: rows that are averaged. One shows a filter best; many show a gain behind the steps of an encoder.
constexpr std::array<std::size_t, 3> averages{1, 4, 16};
constexpr int most_changes = 3;  // numerical: one after the other

/// A change of the controller and what part of the command's misfit it leaves where it leaves least.
struct Found {
    double left = infinity;
    std::size_t rows = 1;  ///< that were averaged
    std::vector<int> terms;
    std::optional<double> tau, zone;  ///< in place of terms
};

/// The record's own controller with one number in another's place.
std::vector<Case> with(std::vector<Case> cases, const std::function<void(Control&)>& set)
{
    for (auto& c : cases) set(c.joint.control);
    return cases;
}

/// What the controllers leave unexplained, over each number of rows.
std::array<double, averages.size()> misfits(const CommandTerms& terms)
{
    std::array<double, averages.size()> left{};
    for (std::size_t i = 0; i < averages.size(); ++i) left[i] = fit_terms(averaged(terms, averages[i]), {}).misfit;
    return left;
}

class SlowLog {
  public:
    SlowLog(std::vector<Case>& cases, double limit)
        : cases_(cases), limit_(limit), terms_(command_terms(cases, zone(), limit)), before_(misfits(terms_))
    {
    }

    double zone() const { return cases_[0].joint.control.dead_zone; }
    /// Of what the controllers leave, over as many rows as are averaged at most.
    double misfit() const { return before_.back(); }
    const CommandTerms& terms() const { return terms_; }

    Found nearest_change() const
    {
        Found best = of_terms(1), two = of_terms(2);
        // two gains imitate a filter better than one does
        if (two.left < policy::much_less * best.left) best = two;
        for (const auto& other : {filter(), dead_zone()})
            if (other.left < best.left) best = other;
        return best;
    }

    Found filter() const
    {
        Found best;
        if (!shows_filter(cases_)) return best;
        constexpr double ratio = 1.25, widest = 100;  // numerical: of the scan; ticks
        const double tick = cases_[0].ticks.step[0];
        const auto try_tau = [&](double tau) {
            const auto changed = with(cases_, [&](Control& c) { c.velocity_estimate.tau = tau; });
            consider(best, misfits(command_terms(changed, zone(), limit_)), {.terms = {}, .tau = tau, .zone = {}});
        };
        try_tau(0);
        for (double tau = tick / 4; tau < widest * tick; tau *= ratio) try_tau(tau);
        return best;
    }

  private:
    void consider(Found& best, const std::array<double, averages.size()>& misfit, Found change) const
    {
        for (std::size_t i = 0; i < averages.size(); ++i)
            if (before_[i] > policy::digits && misfit[i] < best.left * before_[i]) {
                best = change;
                best.left = misfit[i] / before_[i], best.rows = averages[i];
            }
    }

    Found of_terms(std::size_t count) const
    {
        Found best;
        for (std::size_t i = 0; i < averages.size(); ++i) {
            const Changed set = best_set(averaged(terms_, averages[i]), zone(), count);
            if (before_[i] > policy::digits && set.fit.misfit < best.left * before_[i])
                best = {set.fit.misfit / before_[i], averages[i], set.terms, {}, {}};
        }
        return best;
    }

    Found dead_zone() const
    {
        Found best;
        constexpr int zones = 20;       // numerical: of the scan
        constexpr double least = 1e-3;  // numerical: of the largest error
        const double largest = largest_error(cases_);
        for (int i = 0; i < zones; ++i) {
            const double zone = largest * std::pow(least, 1 - (i + 0.5) / zones);
            consider(best, misfits(command_terms(cases_, zone, limit_)), {.terms = {}, .tau = {}, .zone = zone});
        }
        return best;
    }

    std::vector<Case>& cases_;
    double limit_;
    CommandTerms terms_;
    std::array<double, averages.size()> before_;
};

/// Whether one controller ran: what a record says by itself is what all say.
bool alike_in_records(const CommandTerms& rows, const std::vector<int>& terms, const TermFit& all, std::size_t records)
{
    for (std::size_t r = 0; r < records; ++r) {
        const TermFit own = fit_terms(of_record(rows, r), terms);
        for (const int term : terms) {
            const auto i = static_cast<std::size_t>(term);
            const bool tells =
                own.misfit < infinity && policy::flagged_gain_errors * own.error[i] < std::abs(all.value[i]);
            if (tells && std::abs(own.value[i] - all.value[i]) > policy::alike_in_records * std::abs(all.value[i]))
                return false;
        }
    }
    return true;
}

bool apply_terms(std::vector<Case>& cases, const SlowLog& log, const Found& change, Audit& result)
{
    const CommandTerms rows = averaged(log.terms(), change.rows);
    const TermFit fit = fit_terms(rows, change.terms);
    for (const int term : change.terms) {
        const auto i = static_cast<std::size_t>(term);
        if (size_of(rows, fit, term) < policy::rough_gain ||
            std::abs(fit.value[i]) < policy::flagged_gain_errors * fit.error[i])
            return false;
    }
    if (!alike_in_records(rows, change.terms, fit, cases.size())) return false;
    for (const int term : change.terms) {
        const auto i = static_cast<std::size_t>(term);
        const bool factor = rows.factor[i];
        for (auto& c : cases) correct(c.joint.control, term, fit.value[i], factor);
        result.findings.push_back(finding_of(term, fit, factor, cases[0].joint.control, 1 - change.left * change.left));
    }
    return true;
}

bool apply(std::vector<Case>& cases, const SlowLog& log, const Found& change, Audit& result)
{
    if (!(change.left < policy::much_less)) return false;
    const double gain = 1 - change.left * change.left;
    if (change.tau) {
        const double documented = cases[0].joint.control.velocity_estimate.tau;
        if (!filters_differently(documented, *change.tau, cases[0].ticks.step[0])) return false;
        for (auto& c : cases) c.joint.control.velocity_estimate.tau = *change.tau;
        result.findings.push_back({"velocity-filter", "velocity-filter.tau", *change.tau, 0, Quantity::time, gain});
        return true;
    }
    if (change.zone) {
        for (auto& c : cases) c.joint.control.dead_zone = *change.zone;
        result.findings.push_back({"dead-zone", "dead-zone.width", *change.zone, 0, Quantity::position, gain});
        return true;
    }
    return apply_terms(cases, log, change, result);
}

/// What is looked at of long records. Every tick of it is gone through a few hundred times.
std::vector<Case> first_part(const std::vector<Case>& cases)
{
    constexpr std::size_t most = 300000;  // numerical: ticks of all records
    auto part = cases;
    for (auto& c : part)
        if (const std::size_t own = most / cases.size(); c.ticks.size() > own) c.ticks = first_ticks(c.ticks, own);
    return part;
}

void take_controllers(const std::vector<Case>& from, std::vector<Case>& to)
{
    for (std::size_t i = 0; i < to.size(); ++i) to[i].joint.control = from[i].joint.control;
}

}  // namespace

bool is_slow_log(const std::vector<Case>& cases)
{
    return std::ranges::all_of(cases, [](const Case& c) {
        return c.ticks.source == CommandSource::logged && c.ticks.has_reference && c.ticks.ticks_per_row > 1 &&
               is_set(c.joint.control.period) && c.joint.control.kind == ControlKind::position;
    });
}

void audit_slow_log(std::vector<Case>& cases, double limit, Audit& result)
{
    auto seen = first_part(cases);
    for (int i = 0; i < most_changes; ++i) {
        const SlowLog log(seen, limit);
        if (log.terms().rows.empty() || !apply(seen, log, log.nearest_change(), result)) break;
    }
    take_controllers(seen, cases);
    const SlowLog log(seen, limit);
    if (log.terms().rows.empty()) return;
    result.residual_after = log.misfit();
    result.possible = result.residual_after < policy::rough_command;
    if (result.possible)
        result.notes.push_back({.code = Note::Code::terms_to, .values = {100 * result.residual_after}});
}

void audit_slow_filter(std::vector<Case>& cases, double limit, Audit& result)
{
    auto seen = first_part(cases);
    for (auto& c : seen) {
        if (c.ticks.rebuilt) interpolate_halves(c.ticks);
        c.ticks.has_velocity = false;
        std::ranges::fill(c.ticks.velocity, not_set);
    }
    const SlowLog log(seen, limit);
    if (log.terms().rows.empty() || !apply(seen, log, log.filter(), result)) return;
    take_controllers(seen, cases);
    for (auto& c : cases)
        if (c.ticks.rebuilt) interpolate_halves(c.ticks);  // by a filter that was not there
}

}  // namespace stickslip::gap
