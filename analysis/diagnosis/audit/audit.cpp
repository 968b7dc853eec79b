#include "analysis/diagnosis/audit/audit.h"

#include "analysis/diagnosis/audit/align_log.h"
#include "analysis/diagnosis/audit/audit_filter.h"
#include "analysis/diagnosis/audit/audit_readings.h"
#include "analysis/diagnosis/audit/audit_reference.h"
#include "analysis/diagnosis/audit/audit_terms.h"
#include "analysis/diagnosis/audit/gain_regression.h"
#include "analysis/diagnosis/audit/slow_log.h"
#include "analysis/diagnosis/plant/controller.h"
#include "analysis/diagnosis/policy/audit.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace stickslip::gap {
namespace {

/// A controller that is documented without a derivative part may have one: it is a term then, and no factor names it.
bool find_missing_k_v(std::vector<Case>& cases, double limit, double misfit_without, Audit& result)
{
    double k_v = 0, misfit = 0;
    std::vector<double> each;
    for (const auto& c : cases) {
        if (c.joint.control.k_v != 0) return false;
        const auto answer = regression_of(c, c.joint.control.velocity_estimate.tau, limit).solve(true);
        each.push_back(answer.k_v);
        k_v += answer.k_v / static_cast<double>(cases.size()),
            misfit += answer.misfit / static_cast<double>(cases.size());
    }
    const bool damps = std::all_of(each.begin(), each.end(), [](double x) { return x > 0; });
    if (!damps || !(misfit < policy::much_less * misfit_without)) return false;
    double square = 0;
    for (const double x : each) square += (x - k_v) * (x - k_v);
    const double n = static_cast<double>(each.size());
    result.findings.push_back({"gain-k_v", "gain-k_v.value", k_v,
                               n > 1 ? std::sqrt(square / (n - 1) / n) : misfit * k_v, Quantity::velocity_gain,
                               1 - std::pow(misfit / misfit_without, 2)});
    result.notes.push_back({Note::Code::undocumented_k_v});
    for (auto& c : cases) c.joint.control.k_v = k_v;
    return true;
}

}  // namespace

bool filters_differently(double documented_tau, double tau, double tick)
{
    const double documented = tick / (documented_tau + tick), now = tick / (tau + tick);
    return std::abs(now - documented) > policy::flagged_gain * documented;
}

namespace {

/// The mean of both gains over the records as a factor of the documented ones, where that differs by more than is
/// known.
void correct_gains(std::vector<Case>& cases, const std::vector<GainRegression::Answer>& answers, double flagged,
                   Audit& result)
{
    double kp = 0, kv = 0;
    int rated = 0;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        kp += answers[i].k_p / cases[i].joint.control.k_p / static_cast<double>(cases.size());
        if (cases[i].joint.control.k_v != 0) kv += answers[i].k_v / cases[i].joint.control.k_v, ++rated;
    }
    if (rated) kv /= rated;
    const auto between_records = [&](double mean, auto&& of) {
        double square = 0, n = 0;
        for (std::size_t i = 0; i < cases.size(); ++i)
            if (const double x = of(i); std::isfinite(x)) square += (x - mean) * (x - mean), n += 1;
        return n > 1 ? std::sqrt(square / (n - 1) / n) : result.residual_after * std::abs(mean);
    };
    if (std::abs(kp - 1) > flagged)
        result.findings.push_back(
            {"gain-k_p", "gain-k_p.factor", kp,
             between_records(kp, [&](std::size_t i) { return answers[i].k_p / cases[i].joint.control.k_p; }),
             Quantity::number, 1});
    if (rated && std::abs(kv - 1) > flagged)
        result.findings.push_back(
            {"gain-k_v", "gain-k_v.factor", kv,
             between_records(kv, [&](std::size_t i) { return answers[i].k_v / cases[i].joint.control.k_v; }),
             Quantity::number, 1});
    for (auto& c : cases) {
        if (std::abs(kp - 1) > flagged) c.joint.control.k_p *= kp;
        if (rated && std::abs(kv - 1) > flagged) c.joint.control.k_v *= kv;
    }
}

/// A plateau is a limit only where the controller wanted more.
void find_saturation(std::vector<Case>& cases, double limit, Audit& result)
{
    double wanted = 0;
    for (const auto& c : cases) {
        Controller controller(c.joint);
        for (std::size_t k = 0; k < c.ticks.size(); ++k) {
            controller.read(c.ticks.position[k], k == 0 ? c.ticks.step[0] : c.ticks.step[k - 1], 0);
            controller.command(c.ticks.reference[k], c.ticks.reference_rate[k], c.ticks.added(k), c.ticks.time[k]);
            wanted = std::max(wanted, std::abs(controller.wanted()));
        }
    }
    if (wanted > policy::wanted_more * limit) {
        result.findings.push_back({"saturation", "saturation.limit", limit, 0, Quantity::command, 1});
        for (auto& c : cases) c.joint.control.effort_limit = limit;
    }
}

/// The filter's time constant: another than the documented one where that leaves much less of the command.
double find_filter_time(const std::vector<Case>& cases, double limit, std::vector<GainRegression::Answer>& answers,
                        Audit& result)
{
    const Control& documented = cases[0].joint.control;
    const double tau = documented.velocity_estimate.tau;
    const bool filtered = documented.velocity_estimate.form != EstimateForm::exact;
    if (!filtered || result.filter_seen || mean_misfit(answers) <= policy::understood) return tau;
    const double found = best_tau(cases, limit);
    const auto with = gains_of(cases, found, limit);
    if (mean_misfit(with) >= policy::much_less * mean_misfit(answers) ||
        !filters_differently(tau, found, cases[0].ticks.step[0]))
        return tau;
    result.findings.push_back({"velocity-filter", "velocity-filter.tau", found, 0, Quantity::time,
                               1 - std::pow(mean_misfit(with) / mean_misfit(answers), 2)});
    answers = with;
    return found;
}

/// Relative error from which on a gain is off, by what the regression leaves; nothing where that is too much to judge.
std::optional<double> flagged_by(const std::vector<Case>& cases, Audit& result)
{
    const double rounding = command_rounding(cases);
    const bool exact = result.residual_after < policy::understood;
    const bool rounded = !exact && result.residual_after < policy::enough * rounding / std::sqrt(12.0);
    result.command_explained = exact || rounded;
    if (result.residual_after > policy::rough_command) {
        result.notes.push_back({.code = Note::Code::gains_not_judged, .values = {result.residual_after}});
        return std::nullopt;
    }
    // a command that is cut off instead of rounded loses half a step wherever it is: no gain is known better than that
    const double flagged = exact     ? policy::flagged_gain
                           : rounded ? std::max(policy::flagged_gain, rounding)
                                     : std::max(policy::rough_gain, policy::rough_multiple * result.residual_after);
    if (rounded) result.notes.push_back({.code = Note::Code::gains_to_steps, .values = {100 * flagged}});
    if (!result.command_explained)
        result.notes.push_back({.code = Note::Code::gains_to, .values = {100 * result.residual_after}});
    return flagged;
}

/// Whether the command of every record is a position controller's, logged with its reference at ticks that are known.
bool can_be_audited(const std::vector<Case>& cases)
{
    return std::ranges::all_of(cases, [](const Case& c) {
        return c.ticks.source == CommandSource::logged && c.ticks.has_reference &&
               c.joint.control.kind == ControlKind::position &&
               (c.ticks.ticks_per_row <= 1 || !c.ticks.unseen_between() || c.ticks.has_velocity);
    });
}

bool lacks_reference(const std::vector<Case>& cases)
{
    return std::ranges::all_of(cases, [](const Case& c) {
        return c.ticks.source == CommandSource::logged && !c.ticks.has_reference && c.ticks.regular &&
               c.joint.control.kind == ControlKind::position && !c.ticks.unseen_between();
    });
}

/// Every row that was logged at a tick whose readings are known.
void audit_rows(std::vector<Case>& cases, const Control& documented, double limit, Audit& result)
{
    result.possible = true;
    align_log(cases, limit, result);
    if (audit_terms(cases, limit, result)) return;
    const double filter = cases[0].joint.control.velocity_estimate.tau;
    auto answers = gains_of(cases, filter, limit);
    if (documented.k_v == 0 && find_missing_k_v(cases, limit, mean_misfit(answers), result))
        answers = gains_of(cases, filter, limit);
    const double tau = documented.k_v != 0 ? find_filter_time(cases, limit, answers, result) : filter;
    result.residual_after = mean_misfit(answers);
    const auto flagged = flagged_by(cases, result);
    if (!flagged) return;
    correct_gains(cases, answers, *flagged, result);
    for (auto& c : cases) c.joint.control.velocity_estimate.tau = tau;
    if (limit < policy::below_limit * documented.effort_limit) find_saturation(cases, limit, result);
}

}  // namespace

Audit audit(std::vector<Case>& cases)
{
    Audit result;
    if (cases.empty()) return result;
    audit_grid(cases, result);
    audit_supply(cases, result);
    const double limit = std::min(cases[0].joint.control.effort_limit, observed_limit(cases));
    audit_filter(cases, limit, result);
    const Control documented = cases[0].joint.control;
    if (lacks_reference(cases)) {
        audit_without_reference(cases, limit, result);
        return result;
    }
    if (is_slow_log(cases)) {
        if (std::ranges::none_of(cases, [](const Case& c) { return c.ticks.has_velocity; })) {
            audit_slow_log(cases, limit, result);
            return result;
        }
        if (!result.filter_seen) audit_slow_filter(cases, limit, result);
    }
    if (!can_be_audited(cases)) return result;
    audit_rows(cases, documented, limit, result);
    if (is_slow_log(cases) && result.findings.empty() && !result.command_explained) {
        audit_slow_log(cases, limit, result);  // what no row shows for the readings between them
        result.possible = true;
    }
    // of the documented controller, where it is not the one that ran
    if (is_slow_log(cases) && !result.findings.empty())
        std::erase_if(result.notes, [](const Note& note) {
            return note.code == Note::Code::command_unknown || note.code == Note::Code::gains_not_judged;
        });
    return result;
}

}  // namespace stickslip::gap
