#include "analysis/diagnosis/audit/audit.h"

#include "analysis/diagnosis/audit/after_hole.h"
#include "analysis/diagnosis/audit/audit_filter.h"
#include "analysis/diagnosis/audit/audit_reference.h"
#include "analysis/diagnosis/audit/audit_terms.h"
#include "analysis/diagnosis/audit/regression.h"
#include "analysis/diagnosis/plant/controller.h"
#include "analysis/numerics/line_search.h"

#include <algorithm>
#include <cmath>

namespace stickslip::gap {
namespace {

constexpr double exact_command = 2e-3;  // misfit over rms below which the controller is taken as understood
// A controller between the samples of a slow log, or with a coarse output, is reproduced roughly at best: it is judged
// all the same, but only a gain that is off by many times what remains is a finding.
constexpr double rough_command = 0.05, rough_multiple = 5, rough_gain = 0.03;

/// The rows that no limit touches, with this filter time constant: what the gains multiply, and the logged command.
GainRegression regression_of(const Case& c, double tau, double limit)
{
    GainRegression rows;
    Control control = c.joint.control;
    control.velocity_estimate.tau = tau;
    Controller controller(control);
    const Ticks& t = c.ticks;
    const bool believed = t.unseen_between() && t.has_velocity;
    // at a kink or a step of the reference its rate is anybody's guess unless it was logged
    constexpr double bent = 0.02;  // of the largest rate
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
        if (blind || !is_set(t.command[k]) || std::abs(t.command[k]) > 0.999 * limit || !t.enabled[k]) continue;
        if (control.reference_velocity && control.k_v != 0 && kinked(k)) continue;
        const double rate = control.reference_velocity ? t.reference_rate[k] : 0;
        rows.add(t.reference[k] - t.position[k], rate - controller.velocity(), t.command[k] - t.added(k));
    }
    return rows;
}

/// Golden-section search of the filter time constant with the least misfit, both gains free.
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

/// A controller that is documented without a derivative part may have one: it is a term then, and no factor names it.
bool find_missing_k_v(std::vector<Case>& cases, double limit, double misfit_without, Audit& result)
{
    constexpr double most = 0.5;  // of what the proportional part alone leaves
    double k_v = 0, misfit = 0;
    std::vector<double> each;
    for (const auto& c : cases) {
        if (c.joint.control.k_v != 0) return false;
        const auto answer = regression_of(c, c.joint.control.velocity_estimate.tau, limit).solve(true);
        each.push_back(answer.k_v);
        k_v += answer.k_v / static_cast<double>(cases.size()),
            misfit += answer.misfit / static_cast<double>(cases.size());
    }
    const bool agree = std::all_of(each.begin(), each.end(), [&](double x) { return x > 0.5 * k_v && x < 2 * k_v; });
    if (!(k_v > 0) || !agree || !(misfit < most * misfit_without)) return false;
    double square = 0;
    for (const double x : each) square += (x - k_v) * (x - k_v);
    const double n = static_cast<double>(each.size());
    result.findings.push_back({"gain-k_v", "gain-k_v.value", k_v,
                               n > 1 ? std::sqrt(square / (n - 1) / n) : misfit * k_v, Quantity::damping,
                               1 - std::pow(misfit / misfit_without, 2)});
    result.notes.push_back({Note::Code::undocumented_k_v});
    for (auto& c : cases) c.joint.control.k_v = k_v;
    return true;
}

void audit_grid(std::vector<Case>& cases, Audit& result)
{
    double quantum = infinity;
    for (const auto& c : cases) {
        std::vector<double> readings;
        for (std::size_t k = 0; k < c.ticks.size(); ++k)
            if (c.ticks.logged[k]) readings.push_back(c.ticks.position[k]);
        quantum = std::min(quantum, grid_of(readings));
    }
    const Sensor documented = cases[0].joint.sensor;
    const bool coarser = quantum < infinity && coarser_grid(quantum, documented);
    const double known = std::hypot(documented.position_noise, documented.encoder_quantum / std::sqrt(12.0));
    if (!coarser || quantum / std::sqrt(12.0) < 0.1 * known) return;
    if (!cases[0].noise_documented) {
        // without a documented sensor a fine or a round grid may be nothing but the digits of the file
        constexpr double visible = 1e-3, round = 1e-3;  // of the span; of the digit
        double span = 0;
        for (const auto& c : cases) {
            const auto [low, high] = std::minmax_element(c.ticks.position.begin(), c.ticks.position.end());
            span = std::max(span, *high - *low);
        }
        const double digit = quantum / std::pow(10, std::floor(std::log10(quantum) + round));
        const bool decimal = std::min({std::abs(digit - 1), std::abs(digit - 2), std::abs(digit - 5)}) < round * digit;
        if (decimal || quantum < visible * span) return;
    }
    result.findings.push_back({"quantisation", "quantisation.quantum", quantum, 0, Quantity::position, 1});
    for (auto& c : cases) {
        c.joint.sensor.encoder_quantum = quantum;
        c.sigma = std::max(c.sigma, std::hypot(documented.position_noise, quantum / std::sqrt(12.0)));
    }
}

/// A logged supply that falls with the motor's current: the source has a resistance. The record's own supply then gives
/// way to the documented one and the resistance, so that the joint after the audit explains what the joint before does
/// not.
void audit_supply(std::vector<Case>& cases, Audit& result)
{
    double drop_current = 0, current_current = 0, drop_drop = 0, rows = 0;
    for (const auto& c : cases) {
        const Actuator& a = c.joint.actuator;
        if (a.kind != ActuatorKind::dc_motor || !is_set(a.supply_voltage) || !c.supply_logged) return;
        Innovation innovation;
        const Plant plant = flatten(c.joint);
        predict(plant, c.ticks, known_command(plant, c.ticks), levels[1], innovation);
        for (std::size_t k = 0; k < c.ticks.size(); ++k) {
            if (!c.ticks.logged[k] || !c.ticks.enabled[k]) continue;
            const double effort = is_set(c.ticks.effort[k]) ? c.ticks.effort[k] : innovation.predicted_effort[k];
            const double current = std::abs(effort / (a.effort_gain * a.k_t));
            const double drop = a.supply_voltage - c.ticks.supply[k];
            drop_current += drop * current, current_current += current * current, drop_drop += drop * drop, rows += 1;
        }
    }
    if (rows == 0 || current_current == 0 || drop_drop == 0) return;
    const double resistance = drop_current / current_current;
    const double explained = drop_current * drop_current / current_current / drop_drop;
    const double part = std::sqrt(drop_drop / rows) / cases[0].joint.actuator.supply_voltage;
    constexpr double follows = 0.8, matters = 0.002;
    if (resistance <= 0 || explained < follows || part < matters) return;
    result.findings.push_back({"supply-sag", "supply-sag.resistance", resistance, 0, Quantity::resistance, explained});
    for (auto& c : cases) {
        c.joint.actuator.supply_resistance += resistance;
        c.ticks.supply.assign(c.ticks.size(), c.joint.actuator.supply_voltage);
    }
}

/// The step in which commands are given, as a part of their rms; the largest of all records.
double command_rounding(const std::vector<Case>& cases)
{
    double largest = 0;
    for (const auto& c : cases) {
        double square = 0, n = 0;
        for (double u : c.ticks.command)
            if (is_set(u)) square += u * u, n += 1;
        if (square > 0) largest = std::max(largest, command_step(c.ticks) / std::sqrt(square / n));
    }
    return largest;
}

/// A plateau of the command below the documented limit, where the controller wanted more.
double observed_limit(const std::vector<Case>& cases)
{
    double highest = 0;
    for (const auto& c : cases)
        for (double u : c.ticks.command)
            if (is_set(u)) highest = std::max(highest, std::abs(u));
    int at = 0;
    for (const auto& c : cases)
        for (double u : c.ticks.command) at += is_set(u) && std::abs(u) > (1 - 1e-9) * highest;
    return at >= 10 ? highest : infinity;
}

}  // namespace

bool filters_differently(double documented_tau, double tau, double tick)
{
    const double documented = tick / (documented_tau + tick), now = tick / (tau + tick);
    return std::abs(now - documented) > flagged_gain * documented;
}

bool coarser_grid(double quantum, const Sensor& documented)
{
    return quantum > 1.3 * documented.encoder_quantum && quantum > 0.5 * documented.position_noise;
}

double grid_of(const std::vector<double>& readings)
{
    std::vector<double> sorted = readings;
    std::sort(sorted.begin(), sorted.end());
    if (sorted.empty()) return 0;
    const double span = sorted.back() - sorted.front();
    double least = infinity;
    for (std::size_t k = 1; k < sorted.size(); ++k)
        if (const double d = sorted[k] - sorted[k - 1]; d > 1e-9 * span) least = std::min(least, d);
    if (least == infinity) return 0;
    // refine the step by the farthest reading it can count to
    double step = least;
    for (std::size_t k = 0; k < sorted.size(); ++k) {
        const double count = std::round((sorted[k] - sorted.front()) / step);
        if (count > 0 && std::abs(sorted[k] - sorted.front() - count * step) < 0.1 * step)
            step = (sorted[k] - sorted.front()) / count;
    }
    std::size_t off = 0;
    for (double y : sorted) {
        const double count = (y - sorted.front()) / step;
        off += std::abs(count - std::round(count)) > 0.05;
    }
    return off * 1000 < sorted.size() ? step : 0;
}

double command_step(const Ticks& ticks)
{
    std::vector<double> logged;
    for (std::size_t k = 0; k < ticks.size(); ++k)
        if (ticks.logged[k] && is_set(ticks.command[k])) logged.push_back(ticks.command[k]);
    return grid_of(logged);
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
    if (wanted > 1.01 * limit) {
        result.findings.push_back({"saturation", "saturation.limit", limit, 0, Quantity::effort, 1});
        for (auto& c : cases) c.joint.control.effort_limit = limit;
    }
}

}  // namespace

// In one piece: the audit's checks in the order in which each relies on those before.
Audit audit(std::vector<Case>& cases)
{
    Audit result;
    if (cases.empty()) return result;
    audit_grid(cases, result);
    audit_supply(cases, result);
    audit_filter(cases, result);
    const bool without_reference = std::all_of(cases.begin(), cases.end(), [](const auto& c) {
        return c.ticks.source == CommandSource::logged && !c.ticks.has_reference && c.ticks.regular &&
               c.joint.control.kind == ControlKind::position && !c.ticks.unseen_between();
    });
    if (without_reference) {
        audit_without_reference(cases, std::min(cases[0].joint.control.effort_limit, observed_limit(cases)), result);
        return result;
    }
    for (const auto& c : cases)
        if (c.ticks.source != CommandSource::logged || !c.ticks.has_reference ||
            c.joint.control.kind != ControlKind::position ||
            (c.ticks.ticks_per_row > 1 && c.ticks.unseen_between() && !c.ticks.has_velocity))
            return result;
    result.possible = true;
    const Control documented = cases[0].joint.control;
    const double limit = std::min(documented.effort_limit, observed_limit(cases));
    if (audit_terms(cases, limit, result)) return result;
    const bool filtered = documented.k_v != 0 && documented.velocity_estimate.form != EstimateForm::exact;

    // one gain pair a record: overrides may give every record its own documented gains
    const auto regress = [&](double tau) {
        std::vector<GainRegression::Answer> answers;
        for (const auto& c : cases) answers.push_back(regression_of(c, tau, limit).solve(c.joint.control.k_v != 0));
        return answers;
    };
    const auto mean_misfit = [](const std::vector<GainRegression::Answer>& answers) {
        double sum = 0;
        for (const auto& a : answers) sum += a.misfit;
        return sum / static_cast<double>(answers.size());
    };
    double tau = documented.velocity_estimate.tau;
    auto answers = regress(tau);
    if (documented.k_v == 0 && find_missing_k_v(cases, limit, mean_misfit(answers), result)) answers = regress(tau);
    if (filtered && !result.filter_seen && mean_misfit(answers) > exact_command) {
        const double found = best_tau(cases, limit);
        const auto with = regress(found);
        if (mean_misfit(with) < 0.5 * mean_misfit(answers) && filters_differently(tau, found, cases[0].ticks.step[0])) {
            result.findings.push_back({"velocity-filter", "velocity-filter.tau", found, 0, Quantity::time,
                                       1 - std::pow(mean_misfit(with) / mean_misfit(answers), 2)});
            tau = found;
            answers = with;
        }
    }
    result.residual_after = mean_misfit(answers);
    const double rounding = command_rounding(cases);
    const bool exact = result.residual_after < exact_command;
    constexpr double slack = 1.2;  // what is left is rounding where it is no more than rounding makes
    const bool rounded = !exact && result.residual_after < slack * rounding / std::sqrt(12.0);
    result.command_explained = exact || rounded;
    // a command that is cut off instead of rounded loses half a step wherever it is: no gain is known better than that
    const double flagged = exact     ? flagged_gain
                           : rounded ? std::max(flagged_gain, rounding)
                                     : std::max(rough_gain, rough_multiple * result.residual_after);
    if (result.residual_after > rough_command) {
        result.notes.push_back({.code = Note::Code::gains_not_judged, .values = {result.residual_after}});
        return result;
    }
    if (rounded) result.notes.push_back({.code = Note::Code::gains_to_steps, .values = {100 * flagged}});
    if (!result.command_explained)
        result.notes.push_back({.code = Note::Code::gains_to, .values = {100 * result.residual_after}});
    correct_gains(cases, answers, flagged, result);
    for (auto& c : cases) c.joint.control.velocity_estimate.tau = tau;
    if (limit < 0.999 * documented.effort_limit) find_saturation(cases, limit, result);
    return result;
}

}  // namespace stickslip::gap
