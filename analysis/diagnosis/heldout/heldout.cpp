// In one file: how records are held out, what stays of them, and what is left where they are simulated.
#include "analysis/diagnosis/heldout/heldout.h"

#include "analysis/diagnosis/fit/candidate_numbers.h"
#include "analysis/diagnosis/fit/problem.h"
#include "analysis/diagnosis/policy/ladder.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace stickslip::gap {
namespace {

constexpr std::size_t level = 1;  // the middle horizon: its parameters serve closed-loop runs best

/// Mean squares before, after, of the floor and of the floor with the cause.
using Squares = std::array<double, 4>;

double overall(const std::map<std::string, Squares>& sums, std::size_t which)
{
    double total = 0;
    for (const auto& [signal, s] : sums) total += s[which] / std::max(s[2], 1e-300);
    return sums.empty() ? 0 : std::sqrt(total / static_cast<double>(sums.size()));
}

double explained_part(double before, double after, double floor)
{
    const double whole = before * before - floor * floor;
    return whole > 0 ? (before * before - after * after) / whole : 0;
}

void add_thirds(const std::vector<Case>& cases, std::size_t record, std::vector<Fold>& folds)
{
    constexpr int blocks = 3;
    const Ticks& t = cases[record].ticks;
    const double start = t.time.front(), length = t.duration() / blocks;
    // minus infinity would mean the whole record
    for (int b = 0; b < blocks; ++b)
        folds.push_back({record, b == 0 ? std::numeric_limits<double>::lowest() : start + b * length,
                         b + 1 == blocks ? infinity : start + (b + 1) * length});
}

/// What an effect of a cause takes off the objective in these cases, all of them together.
double worth_of(std::size_t effect, const std::vector<Case>& cases, const Scales& scales, const Attribution& cause)
{
    Candidate rest;
    rest.records = cause.candidate.records;
    const Eigen::VectorXd& all = cause.x[level];
    std::vector<double> kept;
    Eigen::Index first = 0;
    for (std::size_t i = 0; i < cause.candidate.effects.size(); ++i) {
        const auto count = static_cast<Eigen::Index>(cause.candidate.count_of(*cause.candidate.forms[i]));
        if (i != effect) {
            rest.effects.push_back(cause.candidate.effects[i]);
            rest.forms.push_back(cause.candidate.forms[i]);
            kept.insert(kept.end(), all.data() + first, all.data() + first + count);
        }
        first += count;
    }
    const Eigen::VectorXd x = Eigen::Map<Eigen::VectorXd>(kept.data(), static_cast<Eigen::Index>(kept.size()));
    const double with = evaluate(cases, cause.candidate, in_si(cause.candidate, all, scales), levels[level]).objective;
    return (evaluate(cases, rest, in_si(rest, x, scales), levels[level]).objective - with) *
           static_cast<double>(cases.size());
}

}  // namespace

std::vector<Fold> folds_of(const std::vector<Case>& cases)
{
    std::vector<Fold> folds;
    if (cases.size() > 1)
        for (std::size_t i = 0; i < cases.size(); ++i) folds.push_back({i});
    else
        add_thirds(cases, 0, folds);
    return folds;
}

std::vector<Fold> folds_for(const std::vector<Case>& cases, const Scales& scales, const Attribution& cause)
{
    if (cases.size() < 2 || cause.candidate.parameter_count() == 0) return folds_of(cases);
    std::vector<Fold> folds;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const auto others = without(cases, {i});
        bool alone = false;
        for (std::size_t e = 0; e < cause.candidate.effects.size(); ++e) {
            if (cause.candidate.effects[e]->stage == Stage::correction) continue;
            const double here = worth_of(e, {cases[i]}, scales, cause);
            alone = alone || (here > 0 && worth_of(e, others, scales, cause) < policy::hardly_in_others * here);
        }
        if (alone)
            add_thirds(cases, i, folds);
        else
            folds.push_back({i});
    }
    return folds;
}

std::vector<Case> without(const std::vector<Case>& cases, const Fold& fold)
{
    std::vector<Case> rest;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        if (i == fold.record && fold.from == -infinity) continue;
        rest.push_back(cases[i]);
        if (i == fold.record) rest.back().skip_from = fold.from, rest.back().skip_to = fold.to;
    }
    return rest;
}

namespace {

/// What belongs to the record that is held out keeps what was fitted to it: no other record knows the phase of its
/// disturbance, or how its Coulomb level differs from theirs, and a prior would take it back.
Kept of_the_fold(const Candidate& candidate, const Fold& fold, std::size_t record)
{
    Kept kept(candidate.parameter_count(), 0);
    for (std::size_t i = 0; i < kept.size() && fold.from == -infinity; ++i) kept[i] = record_of(candidate, i) == record;
    return kept;
}

/// What is kept of a number with a prior is its difference from that of the other records: what they have in common is
/// the document's error, which the others tell by themselves.
Eigen::VectorXd apart_from_the_others(const Candidate& candidate, const Kept& kept, Eigen::VectorXd x)
{
    const Eigen::VectorXd all = x;
    for (std::size_t i = 0; i < kept.size(); ++i) {
        if (!kept[i] || !(candidate.sd_of(i) > 0)) continue;
        double sum = 0, records = 0;
        for (std::size_t k = 0; k < kept.size(); ++k)
            if (record_of(candidate, k) && candidate.sd_of(k) > 0 &&
                candidate.parameter(k).name == candidate.parameter(i).name)
                sum += all[static_cast<Eigen::Index>(k)], records += 1;
        x[static_cast<Eigen::Index>(i)] -= sum / records;
    }
    return x;
}

/// The joint of a fold after the cause is fitted to everything but the fold.
Joint refitted(const std::vector<Case>& cases, const Fold& fold, const Scales& scales, const Attribution& found)
{
    const Case& c = cases[fold.record];
    if (found.candidate.parameter_count() == 0) return c.joint;
    constexpr int few = 5;
    const auto rest = without(cases, fold);
    bool rough = false;
    for (const auto* f : found.candidate.forms) rough = rough || f->rough;
    // the start is near: a long first step would only lose it where these records say little
    constexpr double first_step = 0.03;  // numerical: of the simplex
    constexpr int evaluations = 40;
    const Kept kept = of_the_fold(found.candidate, fold, c.number);
    const FitProblem problem{rest, found.candidate, scales, levels[level]};
    const Eigen::VectorXd start = apart_from_the_others(found.candidate, kept, found.x[level]);
    const auto refit =
        rough ? search_rough(problem, start, evaluations, first_step, kept) : descend(problem, start, few, kept);
    return edited(c.joint, found.candidate, problem.si(refit.x), c.number);
}

}  // namespace

FoldResult before_and_after(const Case& c, const Joint& documented, const Joint& after, int runs, double from,
                            double to)
{
    FoldResult r;
    r.before = compare(c, documented, runs, from, to, &r.trace_before);
    r.after = compare(c, after, runs, from, to, &r.trace_after);
    // the readings of two joints that move alike to less than a coarse step differ by it here and there
    if (const double finer = documented.sensor.encoder_quantum; after.sensor.encoder_quantum > finer)
        raise_floor_to_steps(c, after, finer, r.after);
    return r;
}

void add_gaps(const std::vector<FoldResult>& results, HeldOut& held)
{
    std::map<std::string, Squares> all;
    std::map<std::string, double> rows;
    std::map<std::string, std::string> units;
    std::vector<double> gains, parts;
    for (const auto& r : results) {
        std::map<std::string, Squares> own;
        for (std::size_t s = 0; s < std::min(r.before.size(), r.after.size()); ++s) {
            const double floor = std::max(r.before[s].floor, 1e-300);
            own[r.before[s].signal] = {r.before[s].difference, r.after[s].difference, floor, r.after[s].floor};
            units[r.before[s].signal] = r.before[s].unit;
            const double n = r.before[s].rows;
            rows[r.before[s].signal] += n;
            for (std::size_t k = 0; k < own[r.before[s].signal].size(); ++k)
                all[r.before[s].signal][k] += n * own[r.before[s].signal][k];
        }
        const double before = overall(own, 0), after = overall(own, 1);
        if (before > 0) gains.push_back(1 - after / before), parts.push_back(explained_part(before, after, 1));
    }
    for (auto& [signal, s] : all) {
        const double n = rows[signal];
        for (double& x : s) x /= n;
        SignalGap g{signal, units[signal], std::sqrt(s[0]), std::sqrt(s[1]), std::sqrt(s[2])};
        g.explained = explained_part(g.before, g.after, g.floor);
        held.signals.push_back(g);
    }
    held.overall = {overall(all, 0), overall(all, 1), 1};
    held.overall.own_floor = overall(all, 3);
    held.overall.explained = explained_part(held.overall.before, held.overall.after, 1);
    held.gain = held.overall.before > 0 ? 1 - held.overall.after / held.overall.before : 0;
    if (gains.empty()) return;
    held.gain_interval = {*std::min_element(gains.begin(), gains.end()), *std::max_element(gains.begin(), gains.end())};
    held.overall.interval = {*std::min_element(parts.begin(), parts.end()),
                             *std::max_element(parts.begin(), parts.end())};
}

DiagnosedTrace trace_of(const Case& shown, const Trace& before, const Trace& after)
{
    const Ticks& t = shown.ticks;
    DiagnosedTrace trace;
    trace.file = t.name;
    trace.predicted = before.predicted;
    // what is put into a prediction cannot be predicted
    const bool effort = t.has_effort && t.source != CommandSource::measured;
    const CommandUnit command = command_unit(shown.joint);
    trace.effort = effort ? DiagnosedTrace::Effort::measured : DiagnosedTrace::Effort::command;
    trace.effort_unit =
        effort ? std::string(unit_of(Quantity::effort, Units(shown.joint.mechanism.motion))) : command.unit;
    constexpr std::size_t most = 4000;  // points a chart can show
    const std::size_t stride = std::max<std::size_t>(1, t.size() / most);
    for (std::size_t k = 0; k < t.size(); k += stride) {
        trace.time.push_back(t.time[k]);
        trace.measured.push_back(t.position[k]);
        trace.before.push_back(before.position[k]);
        trace.after.push_back(after.position[k]);
        if (effort) {
            trace.effort_measured.push_back(t.effort[k]);
            trace.effort_before.push_back(before.effort[k]);
            trace.effort_after.push_back(after.effort[k]);
        } else if (t.source == CommandSource::logged && !trace.predicted) {
            // where the drive is off nobody knows what the controller asked for
            const double factor = t.enabled[k] ? command.factor : not_set;
            trace.effort_measured.push_back(command.factor * t.command[k]);
            trace.effort_before.push_back(factor * before.command[k]);
            trace.effort_after.push_back(factor * after.command[k]);
        }
    }
    return trace;
}

HeldOut hold_out(const Fit& fit, const std::vector<Joint>& documented, const Attribution& found, int runs)
{
    const auto& cases = fit.cases;
    const auto folds = folds_for(cases, fit.scales, found);
    std::vector<FoldResult> results(folds.size());
    fit.parallel(folds.size(), [&](std::size_t i) {
        const Fold& fold = folds[i];
        const Case& c = cases[fold.record];
        const Joint after = refitted(cases, fold, fit.scales, found);
        results[i] = before_and_after(c, documented[fold.record], after, runs, fold.from, fold.to);
    });
    HeldOut held;
    add_gaps(results, held);
    for (std::size_t i = 0; i < folds.size(); ++i) {
        if ((i > 0 && folds[i].record == folds[i - 1].record) || results[i].trace_before.position.empty()) continue;
        const Case& shown = cases[folds[i].record];
        if (cases.size() > 1 && folds[i].from > -infinity)
            held.notes.push_back({Note::Code::cause_almost_alone, shown.ticks.name});
        held.traces.push_back(trace_of(shown, results[i].trace_before, results[i].trace_after));
    }
    return held;
}

}  // namespace stickslip::gap
