#include "analysis/diagnosis/rig/rig.h"

#include "analysis/diagnosis/fit/effect.h"
#include "analysis/diagnosis/policy/outcomes_and_rigs.h"
#include "analysis/diagnosis/policy/records.h"
#include "analysis/diagnosis/rig/rig_answer.h"
#include "analysis/diagnosis/rig/rig_experiment.h"
#include "analysis/diagnosis/rig/rig_laws.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace stickslip::gap {
namespace {

/// A law, fitted, and how it predicts the rows that its fits have not seen.
struct Entry {
    RigFit fit;
    double held = 0;  ///< mean square over all folds
    std::array<double, rig_folds> squares{};
};

Entry entry_of(const Rig& rig, const RigRival& rival)
{
    Entry e;
    e.fit = fit_rig(rig, rival);
    for (int f = 0; f < rig_folds; ++f) {
        const RigFit refit = refit_rig(rig, rival, f, e.fit);
        const double square = rig_square(rig, rig_force(rig, rival.law, refit.p), f, true);
        e.squares[static_cast<std::size_t>(f)] = square;
        e.held += square / rig_folds;
    }
    return e;
}

/// A logarithm of speed upwards strengthens as viscous friction does; only downwards is it Stribeck's.
const char* effect_of(const RigRival& rival, const Entry& e)
{
    return rival.law == RigLaw::logarithm && e.fit.p[1] > 0 ? "viscous" : rival.effect;
}

/// What a law leaves on held-out rows, as log RMS. A law contains simpler ones as limits, so its numbers have to earn
/// their place.
double score_of(const Entry& e, const RigRival& rival)
{
    return 0.5 * std::log(e.held) + policy::price_of_rig_parameter * static_cast<double>(rival.parameters.size());
}

/// The laws by score, best first.
std::vector<std::size_t> ranked(const std::vector<Entry>& entries)
{
    std::vector<std::size_t> order(entries.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) {
        return score_of(entries[a], rig_rivals()[a]) < score_of(entries[b], rig_rivals()[b]);
    });
    return order;
}

Cause cause_of(const Rig& rig, const RigRival& rival, const Entry& e, const Entry& level, Motion motion)
{
    Cause c;
    c.names = {effect_of(rival, e)};
    c.form = rival.form;
    c.heldout_gain = 1 - std::sqrt(e.held / level.held);
    c.heldout_gain_interval = {1, -1};
    for (std::size_t f = 0; f < rig_folds; ++f) {
        const double gain = 1 - std::sqrt(e.squares[f] / level.squares[f]);
        c.heldout_gain_interval.low = std::min(c.heldout_gain_interval.low, gain);
        c.heldout_gain_interval.high = std::max(c.heldout_gain_interval.high, gain);
    }
    c.signature = c.heldout_gain > policy::worth_a_rig_law;
    if (effect_named(effect_of(rival, e))) c.signatures = c.names;
    const RigNumbers& p = e.fit.p;
    for (std::size_t n = 0; n < rival.parameters.size(); ++n)
        c.parameters.push_back({c.names[0] + "." + rival.parameters[n].name, p[n + 1], not_set,
                                std::string(unit_of(rival.parameters[n].quantity, Units(motion)))});
    if (p.size() > 3) {
        c.parameters.push_back(
            {c.names[0] + ".V_star", rig.speed, not_set, std::string(unit_of(Quantity::velocity, Units(motion)))});
        c.parameters.push_back({"stiffness", p[0], not_set, std::string(unit_of(Quantity::stiffness, Units(motion)))});
    }
    return c;
}

std::string described(const RigRival& rival, const Entry& e)
{
    const std::string effect = effect_of(rival, e);
    return *rival.form ? effect + " by the " + rival.form + " law" : effect;
}

/// The note that lists the laws of a cause; begun with the law that it was named by.
Note& laws_alike(std::vector<Note>& notes, const Cause& cause)
{
    for (auto& note : notes)
        if (note.code == Note::Code::rig_laws_alike && note.names[0] == cause.names[0]) return note;
    return notes.emplace_back(Note{.code = Note::Code::rig_laws_alike, .names = {cause.names[0], cause.form}});
}

/// Causes by rank, one for each effect: forms of one effect are one cause, whose law may be ambiguous.
void name_causes(const Rig& rig, const std::vector<Entry>& entries, const std::vector<std::size_t>& order, double noise,
                 Diagnosis& d)
{
    const auto& rivals = rig_rivals();
    const double least = score_of(entries[order[0]], rivals[order[0]]);
    double sum = 0;
    for (std::size_t i : order) {
        if (i == 0) continue;
        const double beyond = score_of(entries[i], rivals[i]) - least;
        const bool rival = !d.effects.empty() && beyond < policy::rig_margin;
        const auto same = std::find_if(d.effects.begin(), d.effects.end(),
                                       [&](const auto& c) { return c.names[0] == effect_of(rivals[i], entries[i]); });
        const std::vector<std::string> names{effect_of(rivals[i], entries[i])};
        if (rival && std::find(d.ambiguous_with.begin(), d.ambiguous_with.end(), names) == d.ambiguous_with.end())
            d.ambiguous_with.push_back(names);
        if (same == d.effects.end()) {
            d.effects.push_back(cause_of(rig, rivals[i], entries[i], entries[0], d.motion));
            d.effects.back().misfit = 0.5 * std::log(entries[i].held) - std::log(noise);
            sum += d.effects.back().probability = std::exp(-beyond / policy::rig_margin);
        } else if (rival) {
            auto& note = laws_alike(d.reasons, *same);
            note.names.emplace_back(rivals[i].form);
            same->form += std::string(" or ") + rivals[i].form;
        }
    }
    for (auto& c : d.effects) c.probability *= policy::any_law_of_rig / sum;
}

/// A law with memory becomes that of the joint, where it weakens as a joint's does.
void take_memory(const Rig& rig, RigLaw law, const RigNumbers& p, Joint& joint)
{
    if ((law != RigLaw::slip && law != RigLaw::ageing) || !(p[2] >= 0)) return;
    Memory& m = main_friction(joint).memory;
    m.A = p[1], m.B = p[2], m.L = p[3], m.V_star = rig.speed;
    m.form = law == RigLaw::ageing ? MemoryForm::ageing : MemoryForm::slip;
}

}  // namespace

bool is_rig(const Record& r)
{
    // a position beside an effort alone is what joint states hold; a rig logs where its load point is, or a normal load
    const bool load_point = r.position.empty() && !r.reference_position.empty();
    const bool slider = !r.position.empty() && r.reference_position.empty() && !r.normal_load.empty();
    return !r.effort_measured.empty() && r.effort_command.empty() && r.drive.empty() && r.current.empty() &&
           (load_point || slider);
}

namespace {

/// Those with rows enough; the others are reported.
std::vector<Record> long_enough(const std::vector<Record>& records, Diagnosis& d)
{
    std::vector<Record> enough;
    for (const auto& r : records)
        if (static_cast<double>(r.rows()) >= policy::fewest_rows)
            enough.push_back(r);
        else
            d.reasons.push_back({.code = Note::Code::too_few_rows,
                                 .record = r.name,
                                 .values = {static_cast<double>(r.rows()), policy::fewest_rows}});
    return enough;
}

/// The one cause as a ladder of one rung.
void report_one_rung(Diagnosis& d)
{
    if (d.verdict != Verdict::gap || d.effects.empty()) return;
    d.ladder.push_back({d.effects[0].names, std::clamp(d.overall.explained, 0.0, 1.0), d.overall.interval,
                        d.effects[0].parameters, d.ambiguous_with, d.effects[0].probability});
    d.ceiling.share = not_set;  // the flexible model is one of joints
}

}  // namespace

DiagnosisResult diagnose_rig(const Joint& joint, const std::vector<Record>& given, const ParallelFor& parallel)
{
    DiagnosisResult result{{}, joint};
    Diagnosis& d = result.diagnosis;
    d.motion = joint.mechanism.motion;
    const auto records = long_enough(given, d);
    if (records.empty()) return result;
    const Rig rig = rig_of(records);
    describe(rig, records, d);
    if (rig.travel == 0 || rig.range == 0 || rig.speed == 0) {
        d.reasons.push_back({Note::Code::rig_still, records.front().name});
        return result;
    }
    const auto& rivals = rig_rivals();
    std::vector<Entry> entries(rivals.size());
    parallel(rivals.size(), [&](std::size_t i) { entries[i] = entry_of(rig, rivals[i]); });
    const auto order = ranked(entries);
    const RigRival& best = rivals[order[0]];
    const double noise = std::max(rig_noise(rig), 1e-12 * rig.range);
    const double before = std::sqrt(entries[0].held), after = std::sqrt(entries[order[0]].held);
    const bool gap = order[0] != 0 && after < (1 - policy::worth_a_rig_law) * before;
    d.verdict = gap ? Verdict::gap : before < policy::quiet_rig * noise ? Verdict::no_gap : Verdict::unknown;
    add_gap(rig, before, after, noise, d);
    if (gap) {
        name_causes(rig, entries, order, noise, d);
        const std::size_t rival = order[1] == 0 ? order[2] : order[1];
        d.next_experiment = design_rig_experiment(rig, noise, best.law, entries[order[0]].fit.p, rivals[rival].law,
                                                  entries[rival].fit.p);
        if (d.next_experiment.motion != TestMotion::none)
            d.next_experiment.separates = {
                {described(best, entries[order[0]]), described(rivals[rival], entries[rival])}};
        take_memory(rig, best.law, entries[order[0]].fit.p, result.after);
    } else if (d.verdict == Verdict::no_gap) {
        d.reasons.push_back({Note::Code::rig_level_suffices});
    } else {
        d.reasons.push_back({Note::Code::rig_no_law_predicts});
    }
    d.traces = traces_of(rig, records, best.law, entries[order[0]].fit.p);
    report_one_rung(d);
    return result;
}

}  // namespace stickslip::gap
