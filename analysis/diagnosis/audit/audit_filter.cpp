#include "analysis/diagnosis/audit/audit_filter.h"

#include "analysis/diagnosis/audit/audit_numbers.h"
#include "analysis/diagnosis/audit/half_rate_filter.h"
#include "analysis/diagnosis/audit/regression.h"
#include "analysis/diagnosis/audit/velocity_recursion.h"
#include "analysis/diagnosis/plant/controller.h"
#include "analysis/diagnosis/policy/audit.h"
#include "analysis/joint/gains.h"
#include "analysis/numerics/line_search.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace stickslip::gap {
namespace {

constexpr double exact_velocity = 1e-3;  // numerical: misfit over rms of the velocity's steps, as digits are logged

bool is_filter(const OnePole& seen)
{
    return seen.misfit <= exact_velocity && seen.gain > 0 && seen.gain <= 1 + exact_velocity;
}

/// Whether the command is made of the logged velocities, seen without a reference: a motion that somebody wants is
/// smooth, and of its fifth differences from tick to tick nothing is left beside those of readings with noise and
/// steps; where it has a kink the rows are left out.
bool changes_make_the_command(const Case& c)
{
    constexpr double kink = 5, mostly = 0.95;                      // numerical: rms; rows that stay
    constexpr int rounds = 5;                                      // numerical: of leaving kinks out
    constexpr std::array<double, 6> fifth{1, -5, 10, -10, 5, -1};  // numerical: a difference
    const Ticks& t = c.ticks;
    GainRegression rows;
    const auto usable = [&](std::size_t k) {
        return t.logged[k] && t.enabled[k] &&
               std::abs(t.command[k]) <= policy::below_limit * c.joint.control.effort_limit;
    };
    std::size_t in_a_row = 0;
    for (std::size_t k = 0; k < t.size(); ++k) {
        in_a_row = usable(k) ? in_a_row + 1 : 0;
        if (in_a_row < fifth.size()) continue;
        GainRegression::Row row{0, 0, 0};
        for (std::size_t i = 0; i < fifth.size(); ++i) {
            row.a -= fifth[i] * t.position[k - i], row.b -= fifth[i] * t.velocity[k - i];
            row.u += fifth[i] * (t.command[k - i] - t.added(k - i));
        }
        if (std::isfinite(row.a + row.b + row.u)) rows.add(row.a, row.b, row.u);
    }
    auto found = rows.solve(true);
    const double all = found.used;
    for (int round = 0; round < rounds && found.used > 0; ++round) {
        const auto before = found;
        found = rows.solve(true, [&](const GainRegression::Row& row) {
            return std::abs(GainRegression::left(row, before)) <= kink * before.misfit * before.rms;
        });
    }
    return found.used > mostly * all && found.both && found.misfit < policy::made_of_differences;
}

/// Whether the command is made of the logged velocities, with gains of any size: they are the controller's own then.
bool velocities_make_the_command(const Case& c)
{
    if (!c.ticks.has_reference) return changes_make_the_command(c);
    const Ticks& t = c.ticks;
    const Control& control = c.joint.control;
    GainRegression rows;
    for (std::size_t k = 0; k < t.size(); ++k) {
        const double rate = control.reference_velocity ? t.reference_rate[k] : 0;
        const double a = t.reference[k] - t.position[k], b = rate - t.velocity[k], u = t.command[k] - t.added(k);
        const bool cut = std::abs(t.command[k]) > policy::below_limit * control.effort_limit;
        if (t.logged[k] && t.enabled[k] && !cut && std::isfinite(a + b + u)) rows.add(a, b, u);
    }
    const auto found = rows.solve(true);
    return found.used > 0 && found.both && found.misfit < policy::made_of_velocities;
}

/// Whether the commands are made of the logged velocities, seen beside what the documented filter makes of them: with
/// the controller's own terms or one change of them, integral included.
bool velocities_explain_the_command(std::vector<Case> cases, double limit)
{
    for (auto& c : cases) c.ticks.own_velocity = true;
    const double with = left_by_one(cases, limit);
    for (auto& c : cases) c.ticks.has_velocity = false;
    const double without = left_by_one(cases, limit);  // infinite where the filter has to be waited for everywhere
    return with < policy::understood && std::isfinite(without) && with < policy::of_own_velocities * without;
}

double distance_to_grid(double y, double quantum)
{
    return std::abs(y / quantum - std::round(y / quantum));
}

/// Mean distance from the encoder's grid, in steps, of the readings between every `stride`-th pair of rows in which
/// anything moves: a quarter where they know nothing of it, NaN where nothing moves.
double off_grid(const std::vector<Case>& cases, double tau, std::size_t stride = 1)
{
    constexpr double still = 1e-3;  // numerical: steps a tick: a reading between equal ones fits any filter
    double sum = 0, n = 0;
    for (const auto& c : cases) {
        const Ticks& t = c.ticks;
        const double quantum = c.joint.sensor.encoder_quantum, slow = still * quantum / c.joint.control.period;
        const std::size_t ticks = 2 * stride;
        for (std::size_t k = 2; k < t.size(); k += ticks) {
            if (t.position[k] == t.position[k - 2] && std::abs(t.velocity[k]) < slow &&
                std::abs(t.velocity[k - 2]) < slow)
                continue;
            sum += distance_to_grid(between_rows(t, k, c.joint.control.period, tau), quantum), n += 1;
        }
    }
    constexpr double few = 30;  // numerical: rows that give a mean
    return n >= few ? sum / n : not_set;
}

/// The time constant with which the readings between the rows lie nearest to the grid.
double tau_of_halves(const std::vector<Case>& cases, double tick)
{
    // the right one stands alone, the closer the finer the grid: many trials on some of the rows, then all of them
    constexpr double ratio = 1.001, longest = 100;  // numerical: of the scan; ticks
    constexpr std::size_t some = 2000;
    std::size_t rows = 0;
    for (const auto& c : cases) rows += c.ticks.rows();
    const std::size_t stride = std::max<std::size_t>(1, rows / some);
    double best = 0, least = off_grid(cases, 0, stride);
    for (double sum = tick * ratio; sum < longest * tick; sum *= ratio)
        if (const double d = off_grid(cases, sum - tick, stride); d < least) least = d, best = sum - tick;
    const double width = (ratio - 1) * (best + tick);
    const auto distance = [&](double tau) { return off_grid(cases, tau); };
    const double refined = least_between(std::max(0.0, best - width), best + width, distance);
    return distance(refined) < distance(best) ? refined : best;
}

void correct(std::vector<Case>& cases, double tau, Audit& result)
{
    result.findings.push_back({"velocity-filter", "velocity-filter.tau", tau, 0, Quantity::time, 1});
    for (auto& c : cases) {
        c.joint.control.velocity_estimate.tau = tau;
        if (c.ticks.rebuilt) rebuild_halves(c.ticks, c.joint);
    }
}

/// A filter of another shape than the documented one, in velocities that the commands are made of: of one pole it is as
/// slow as the one with this delay.
void audit_two_poles(std::vector<Case>& cases, double limit, Audit& result)
{
    std::vector<const Case*> all;
    for (const auto& c : cases) {
        if (c.ticks.source != CommandSource::logged || !c.ticks.has_reference) return;
        all.push_back(&c);
    }
    const auto seen = two_poles_of(all);
    if (!(seen.misfit <= exact_velocity && seen.gain > 0 && seen.delay > 0)) return;
    if (!velocities_explain_the_command(cases, limit)) return;
    result.filter_seen = true;
    for (auto& c : cases) c.ticks.own_velocity = true;
    const double tick = cases[0].ticks.step[0], delay = seen.delay * tick;
    if (!filters_differently(cases[0].joint.control.velocity_estimate.tau, delay, tick)) return;
    correct(cases, delay, result);
    result.notes.push_back({.code = Note::Code::filter_of_two_poles, .values = {delay}});
}

/// Of logs of every second tick whose readings between the rows were rebuilt.
void audit_halves(std::vector<Case>& cases, Audit& result)
{
    const auto all = [&](auto&& holds) { return std::all_of(cases.begin(), cases.end(), holds); };
    const double tau = cases[0].joint.control.velocity_estimate.tau, tick = cases[0].joint.control.period;
    if (all([](const Case& c) { return c.joint.sensor.encoder_quantum > 0; })) {
        // without a grid any reading between the rows could be one
        constexpr double on_grid = 0.05;  // numerical: of a step, as digits are logged
        double off = 0, n = 0;
        for (const auto& c : cases)
            for (std::size_t k = 0; k < c.ticks.size(); k += 2)
                off += distance_to_grid(c.ticks.position[k], c.joint.sensor.encoder_quantum), n += 1;
        const double as_documented = off_grid(cases, tau);
        if (off > on_grid * n || !is_set(as_documented)) return;
        const double found = as_documented < on_grid ? tau : tau_of_halves(cases, tick);
        result.filter_seen = off_grid(cases, found) < on_grid;
        if (!result.filter_seen)
            for (auto& c : cases) interpolate_halves(c.ticks);
        else if (filters_differently(tau, found, tick))
            correct(cases, found, result);
    } else if (all([](const Case& c) {
                   return c.ticks.source != CommandSource::logged || velocities_make_the_command(c);
               })) {
        const double share = tick / (tau + tick);
        const auto seen = filter_shares_of_halves(cases);
        if (!seen) return;
        const bool slower = seen->by_noise < (1 - policy::rough_gain) * share;
        const bool faster = seen->by_motion > (1 + policy::rough_gain) * share;
        result.filter_seen = slower || faster;
        if (result.filter_seen) correct(cases, tick * (1 / seen->by_motion - 1), result);
    }
}

}  // namespace

bool velocities_follow_a_filter(const std::vector<const Case*>& cases)
{
    return is_filter(one_pole_of(cases));
}

void audit_filter(std::vector<Case>& cases, double limit, Audit& result)
{
    const Control documented = cases[0].joint.control;
    const double tau = documented.velocity_estimate.tau;
    const auto all = [&](auto&& holds) { return std::all_of(cases.begin(), cases.end(), holds); };
    const bool one_controller = all([&](const Case& c) {
        const Control& control = c.joint.control;
        return control.velocity_estimate.form != EstimateForm::exact && gains_of(control).k_v != 0 &&
               control.velocity_estimate.tau == tau && control.period == documented.period;
    });
    if (!one_controller ||
        !all([](const Case& c) { return (c.ticks.regular || c.ticks.lost) && c.ticks.has_velocity; }))
        return;
    std::vector<const Case*> at_every_tick;
    for (const auto& c : cases)
        if (c.ticks.ticks_per_row == 1) at_every_tick.push_back(&c);
    if (!at_every_tick.empty()) {
        const double tick = at_every_tick[0]->ticks.step[0];
        const auto seen = one_pole_of(at_every_tick);
        if (!is_filter(seen)) {
            if (at_every_tick.size() == cases.size()) audit_two_poles(cases, limit, result);
            return;
        }
        // a logged command says it better: the velocities may be anybody's. Where rows are lost its gains are read off
        // with the logged velocities, and so say nothing of their filter but that they are the controller's
        if (!all([](const Case& c) {
                return c.ticks.source != CommandSource::logged ||
                       (c.ticks.unseen_between() && velocities_make_the_command(c));
            }))
            return;
        const double found = tick * std::max(0.0, 1 / seen.gain - 1);
        const bool differs = filters_differently(tau, found, tick);
        // plain differences of the readings are what anybody would log
        if (differs && seen.gain > 1 - exact_velocity) return;
        result.filter_seen = true;
        if (differs) correct(cases, found, result);
        return;
    }
    if (all([](const Case& c) { return c.ticks.regular && c.ticks.rebuilt; })) audit_halves(cases, result);
}

}  // namespace stickslip::gap
