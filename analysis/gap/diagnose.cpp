#include "analysis/gap/diagnose.h"

#include "analysis/gap/contest.h"
#include "analysis/gap/drive_force.h"
#include "analysis/gap/experiment.h"
#include "analysis/gap/free_force.h"
#include "analysis/gap/heldout.h"
#include "analysis/gap/inspect.h"
#include "analysis/gap/jumps.h"
#include "analysis/gap/locate.h"
#include "analysis/gap/pieces.h"
#include "analysis/gap/prepare.h"
#include "analysis/gap/rig.h"
#include "analysis/gap/search.h"
#include "analysis/gap/verdict.h"
#include "analysis/gap/withdraw.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace stickslip::gap {
namespace {

/// What has been gathered on the way to an answer.
struct Work {
    std::vector<Case> cases;
    std::vector<Joint> documented;
    Audit audit;
    Scales scales;
    Nominal nominal;
};

Cause cause_of(const Work& w, const Attribution& a, double probability)
{
    Cause c;
    for (const auto& f : w.audit.findings)
        if (std::find(c.names.begin(), c.names.end(), f.effect) == c.names.end()) c.names.push_back(f.effect);
    const Motion motion = w.documented[0].mechanism.motion;
    if (!c.names.empty())
        for (const auto& f : w.audit.findings)
            c.parameters.push_back({f.parameter, f.value, f.stderr_, std::string(unit_of(f.quantity, motion))});
    c.probability = probability;
    c.misfit = a.score;
    for (const auto& name : c.names)
        if (const Effect* e = effect_named(name))
            c.tell_tale += (c.tell_tale.empty() ? "" : "; ") + std::string(e->signature);
    c.signature = !c.names.empty();
    if (a.candidate.effects.empty()) return c;
    const auto quality = quality_of(w.cases, a, w.scales);
    c.signature = quality.signature;
    c.plausible = quality.plausible;
    const auto si = in_si(a.candidate, a.x[1], w.scales);
    std::size_t i = 0;
    for (std::size_t n = 0; n < a.candidate.effects.size(); ++n) {
        const Effect& e = *a.candidate.effects[n];
        if (std::find(c.names.begin(), c.names.end(), e.name) == c.names.end()) c.names.emplace_back(e.name);
        c.tell_tale += (c.tell_tale.empty() ? "" : "; ") + std::string(e.signature);
        if (!a.candidate.forms[n]->name.empty())
            c.form += (c.form.empty() ? "" : " + ") + std::string(a.candidate.forms[n]->name);
        const EffectForm& form = *a.candidate.forms[n];
        const std::size_t shared = form.parameters.size() - form.own;
        for (std::size_t k = 0; k < a.candidate.count_of(form); ++k, ++i) {
            const auto& p = a.candidate.parameter_of(form, k);
            std::string name = std::string(e.name) + "." + std::string(p.name);
            if (k >= shared) name += " in " + w.cases[(k - shared) / form.own].ticks.name;
            c.parameters.push_back({name, si[i], quality.standard_error[i], std::string(unit_of(p.quantity, motion))});
        }
    }
    return c;
}

/// A contestant as a cause: its refitted own numbers are the joint's, not the cause's.
Cause cause_of(const Work& w, const Contestant& one, std::size_t own_numbers, double probability)
{
    Cause c = cause_of(w, one.fit, probability);
    std::size_t own = 0;
    for (std::size_t i = 0; i < own_numbers; ++i) own += one.fit.candidate.count_of(*one.fit.candidate.forms[i]);
    c.names = {std::string(one.fit.candidate.effects.back()->name)};
    c.parameters.erase(c.parameters.begin(), c.parameters.begin() + static_cast<std::ptrdiff_t>(own));
    c.tell_tale = one.fit.candidate.effects.back()->signature;
    c.form = one.fit.candidate.forms.back()->name;
    c.misfit = std::log1p(-std::min(one.gain, 0.999));
    c.heldout_gain = one.gain;
    c.heldout_gain_interval = one.spread;
    c.force_gain = one.force_gain;
    c.force_gain_interval = one.force_spread;
    return c;
}

/// Which of the contestants it is: their held-out log RMS against each other, and the chance that it is none of them.
std::vector<double> probabilities(const Contest& contest)
{
    constexpr double width = 0.07;  // of log RMS: what is left is model error, not noise
    constexpr double none_of_these = 0.2;
    std::vector<double> p;
    double sum = 0;
    for (const auto& one : contest.ranked)
        sum += p.emplace_back(std::pow((1 - contest.ranked[0].gain) / (1 - one.gain), 1 / width));
    for (double& x : p) x *= (1 - none_of_these) / sum;
    return p;
}

std::string percent(double part)
{
    return std::to_string(static_cast<int>(std::lround(100 * part))) + " %";
}

/// A contestant, fitted at the middle level, as it stands at all of them.
Attribution at_all_levels(const Work& w, const Attribution& contestant)
{
    LevelFit fit;
    fit.x = contestant.x[1];
    return as_screened(w.cases, w.scales, w.nominal, contestant.candidate, fit);
}

/// The first `own_numbers` effects are refitted numbers of the joint, no causes.
std::string nearest_in_shape(const Attribution& cause, std::size_t own_numbers, const FreeFit& free)
{
    std::string names;
    for (std::size_t i = own_numbers; i < cause.candidate.effects.size(); ++i)
        names += (names.empty() ? "" : " with ") + std::string(cause.candidate.effects[i]->name);
    return names + " comes nearest, but " + in_words(free) +
           " explains the records clearly better, and has the shape of no effect of the catalogue";
}

/// Not empty where so much of controller and encoder differs from the document that it is hardly the same joint.
std::string another_joint(const Audit& audit)
{
    constexpr std::size_t hardly_the_same = 3;
    if (audit.findings.size() < hardly_the_same) return "";
    std::string list;
    for (const auto& f : audit.findings) {
        char number[32];
        std::snprintf(number, sizeof number, " = %.4g", f.value);
        list += (list.empty() ? "" : ", ") + f.parameter + number;
    }
    return "suspected record of another joint: encoder and controller differ from the document in " +
           std::to_string(audit.findings.size()) + " ways (" + list +
           "); if it is this joint, correct the document first";
}

void describe_data(const std::vector<Case>& cases, Diagnosis& d)
{
    for (const auto& c : cases) {
        d.records.push_back({c.ticks.name, "held-out"});
        if (c.ticks.lost)
            d.notes.push_back(c.ticks.name + ": rows are missing; what happened in them is simulated, not judged");
        else if (!c.ticks.regular)
            d.notes.push_back(c.ticks.name + ": irregular sampling; every row is used at its own time");
        if (c.ticks.rebuilt)
            d.notes.push_back(c.ticks.name +
                              ": logged at every second tick; the ticks between were rebuilt from the velocity");
        else if (c.ticks.ticks_per_row > 1)
            d.notes.push_back(c.ticks.name + ": logged slower than the loop; readings between rows are interpolated");
    }
    d.notes.push_back(cases.size() > 1 ? "every record is held out in turn and predicted from a fit to the others"
                                       : "one record: its three thirds are held out in turn");
}

}  // namespace

DiagnosisResult diagnose(const Joint& joint, const std::vector<Record>& records, const ParallelFor& parallel,
                         const DiagnosisOptions& options)
{
    DiagnosisResult result{{}, joint};
    Diagnosis& d = result.diagnosis;
    d.motion = joint.mechanism.motion;
    if (records.empty()) throw std::invalid_argument("no record was given");
    if (records.size() == 1 && is_rig(records[0])) return diagnose_rig(joint, records[0], parallel);
    const auto progress = [&](const char* stage, double done) {
        if (options.progress) options.progress(stage, done);
    };
    progress("reading", 0);
    std::vector<Record> usable;
    for (const auto& whole : records) {
        const auto found = inspect(whole, joint);
        if (!found.errors.empty()) throw std::invalid_argument(found.errors.front());
        d.notes.insert(d.notes.end(), found.notes.begin(), found.notes.end());
        if (!found.shortages.empty()) {
            d.reasons.insert(d.reasons.end(), found.shortages.begin(), found.shortages.end());
            continue;
        }
        auto uninterrupted = pieces(whole, d.notes);
        for (auto& piece : uninterrupted) {
            const auto left = uninterrupted.size() > 1 ? inspect(piece, joint).shortages : std::vector<std::string>();
            d.reasons.insert(d.reasons.end(), left.begin(), left.end());
            if (left.empty()) usable.push_back(std::move(piece));
        }
    }
    if (usable.empty()) return result;

    Work w;
    for (const Record& r : usable) {
        w.cases.push_back(prepare(r, joint, d.notes));
        w.cases.back().number = w.cases.size() - 1;
    }
    share_noise(w.cases, joint.sensor, d.notes);
    for (const auto& c : w.cases) w.documented.push_back(c.joint);
    progress("auditing the controller", 0.02);
    w.audit = audit(w.cases);
    describe_data(w.cases, d);  // the audit may take back what was rebuilt between rows
    d.notes.insert(d.notes.end(), w.audit.notes.begin(), w.audit.notes.end());
    if (auto suspicion = another_joint(w.audit); !suspicion.empty()) {
        d.reasons.push_back(std::move(suspicion));
        return result;
    }
    settle_jumps(w.cases, {}, {});
    w.scales = scales_of(w.cases);
    d.usual_speed = w.scales.velocity;
    w.nominal = judge_nominal(w.cases);
    d.signals = locate_signals(w.cases, w.documented);
    d.regimes = locate_regimes(w.cases);

    Attribution none;
    none.evaluation = w.nominal.evaluation;
    none.score = w.nominal.score;
    progress("measuring the floor", 0.05);
    const bool quiet = at_floor(w.cases, none, w.nominal, w.scales, parallel);
    if (quiet) none.accepted = true;
    std::vector<Attribution> singles, pairs;
    std::vector<FreeFit> free;
    bool nearest_only = false;  // a cause was found, but is only the nearest in shape
    Decision decision;
    Contest contest;
    const bool floor_documented =
        std::all_of(w.cases.begin(), w.cases.end(), [](const auto& c) { return c.noise_documented; });
    if (!quiet) {
        progress("fitting single effects", 0.1);
        const auto fit = [&] {
            return fit_singles(w.cases, w.scales, w.nominal, single_candidates(w.cases, w.audit), parallel);
        };
        singles = fit();
        // a jump in the wrong place costs little beside the effect, and much once the effect is found
        if (!singles.empty() &&
            settle_jumps(w.cases, singles[0].candidate, in_si(singles[0].candidate, singles[0].x[1], w.scales))) {
            w.nominal = judge_nominal(w.cases);
            singles = fit();
        }
        confirm(w.cases, singles, w.nominal, w.scales, parallel);
        if (singles.empty() || !singles[0].accepted) {
            progress("fitting pairs", 0.5);
            pairs = fit_pairs(w.cases, w.scales, w.nominal, singles, options.pair_partners, parallel);
            confirm(w.cases, pairs, w.nominal, w.scales, parallel);
            fit_members_alone(w.cases, w.scales, w.nominal, singles, pairs, parallel);
            confirm(w.cases, singles, w.nominal, w.scales, parallel);
        }
        decision = decide(singles, pairs);
        // without a documented floor nothing can be told to be noise: what predicts unseen data clearly best is named;
        // else what takes a good part of the misfit away, and whatever takes half as much is said to be a rival
        if (!decision.named && !floor_documented) {
            progress("comparing what causes predict", 0.75);
            contest = hold_contest(w.cases, w.scales, singles, parallel);
        }
        constexpr double worth_naming = 0.2;  // of mean log misfit: a tenth of the RMS
        const auto gain = [&](const Attribution& a) { return w.nominal.score - a.score; };
        if (!decision.named && !contest.decided && !floor_documented && !singles.empty() &&
            gain(singles[0]) > worth_naming) {
            decision.winner = &singles[0];
            decision.named = true;
            for (const auto& rival : singles)
                if (&rival != decision.winner && gain(rival) > 0.5 * gain(singles[0]))
                    decision.ambiguous.push_back(&rival);
        }
        const bool found = decision.named || contest.decided;
        const Attribution nearest = contest.decided  ? at_all_levels(w, contest.ranked[0].fit)
                                    : decision.named ? *decision.winner
                                                     : none;
        if (mean_log_misfit(nearest.evaluation) >= least_of_free_force) {
            progress("fitting forces without a name", 0.85);
            free = fit_free_forces(w.cases, w.scales, w.nominal, parallel);
            if (found && clearly_better(free[0], nearest)) {
                d.reasons.push_back(nearest_in_shape(nearest, contest.decided ? contest.own_numbers : 0, free[0]));
                decision.named = contest.decided = false;
                nearest_only = true;
            }
        }
    }
    progress("predicting held-out data", 0.9);
    const bool named = quiet ? !w.audit.findings.empty() : decision.named || contest.decided;
    if (quiet && !named) {
        d.verdict = could_have_shown(w.cases, w.scales, parallel) ? Verdict::no_gap : Verdict::insufficient_data;
        d.reasons.push_back(
            d.verdict == Verdict::no_gap
                ? "the nominal joint predicts every record to the noise"
                : "no effect of usual size would have shown itself at five times the noise under this excitation");
    } else {
        d.verdict = named || !w.audit.findings.empty() ? Verdict::gap : Verdict::unknown;
    }

    // ranking: the named set first, then everything that was fitted, by probability
    const auto ranked = quiet ? std::vector<Ranked>{} : rank(singles, pairs, decision, rows_of(w.cases));
    const Attribution& winner = contest.decided            ? contest.ranked[0].fit
                                : quiet || !decision.named ? none
                                                           : *ranked.front().attribution;
    const bool shown = d.verdict == Verdict::gap;
    const auto held = hold_out(w.cases, w.documented, w.scales, shown ? winner : none, options.ensemble, parallel);
    d.gap = held.signals;
    d.overall = held.overall;
    d.traces = held.traces;
    withdraw_no_gap(d);
    d.notes.insert(d.notes.end(), held.notes.begin(), held.notes.end());
    if (shown && winner.candidate.effects.empty()) {
        Attribution audited = none;
        d.effects.push_back(cause_of(w, audited, quiet ? 0.99 : 0.5));
        if (!quiet)
            d.reasons.push_back(
                "the controller differs from its document, and something that the catalogue does not explain remains");
    }
    if (contest.decided) {
        if (const double corner = drive_force_corner(w.cases); corner > 0) {
            const double before = hold_out_drive_force(w.cases, w.scales, contest, parallel);
            d.drive_force = {std::string(unit_of(Quantity::effort, d.motion)), corner, before,
                             contest.ranked[0].force_rms};
        }
        const auto p = probabilities(contest);
        for (std::size_t i = 0; i < contest.ranked.size(); ++i)
            d.effects.push_back(cause_of(w, contest.ranked[i], contest.own_numbers, p[i]));
        d.reasons.push_back(
            "no cause brings the misfit down to the noise; with inertia, friction and load refitted for all, " +
            d.effects[0].names[0] + " predicts held-out data best");
    }
    for (const auto& r : ranked) {
        if (d.effects.size() >= 8 || contest.decided) break;
        d.effects.push_back(cause_of(w, *r.attribution, r.probability));
    }
    if (!d.effects.empty() && shown && !contest.decided) {
        d.effects[0].heldout_gain = held.gain;
        d.effects[0].heldout_gain_interval = held.gain_interval;
    }
    if (d.verdict == Verdict::unknown && !nearest_only && !quiet) {
        d.reasons.push_back(
            "there is a gap, and no effect of the catalogue, nor two together, explain it: the best leaves " +
            percent(1 - decision.best_explained) + " of it");
        constexpr double worth_telling = 0.5;
        if (!free.empty() && free[0].fit.explained > worth_telling)
            d.reasons.push_back(in_words(free[0]) + " would explain " + percent(free[0].fit.explained) + " of it");
    }
    if (shown) {
        d.remainder = winner.candidate.effects.empty() ? quiet ? 0 : std::clamp(1 - held.overall.explained, 0.0, 1.0)
                                                       : std::max(0.0, 1 - winner.explained);
        for (const auto* rival : decision.ambiguous) d.ambiguous_with.push_back(names_of(rival->candidate));
        for (const auto* rival : contest.decided ? contest.ambiguous : std::vector<const Contestant*>{})
            d.ambiguous_with.push_back({std::string(rival->fit.candidate.effects.back()->name)});
        const Attribution* rival = contest.decided && contest.ranked.size() > 1 ? &contest.ranked[1].fit
                                   : !decision.ambiguous.empty()                ? decision.ambiguous.front()
                                   : ranked.size() > 1                          ? ranked[1].attribution
                                                                                : nullptr;
        if (rival && !winner.candidate.effects.empty())
            d.next_experiment = design_experiment(w.cases[0], w.scales, winner, *rival);
        // the refitted numbers of a contest are no part of what is told apart
        if (contest.decided && !d.next_experiment.separates.empty())
            d.next_experiment.separates = {{d.effects[0].names[0], d.effects[1].names[0]}};
        Joint after = w.cases[0].joint;
        if (!winner.candidate.effects.empty())
            after = edited(after, winner.candidate, in_si(winner.candidate, winner.x[1], w.scales), 0);
        result.after = after;
    }
    const bool settled = quiet || contest.decided || winner.accepted || !w.audit.findings.empty();
    if (withdraw_if_no_better(d, {settled, floor_documented})) result.after = joint;
    progress("done", 1);
    return result;
}

}  // namespace stickslip::gap
