#include "analysis/diagnosis/outcomes/explain.h"

#include "analysis/diagnosis/outcomes/rows.h"
#include "analysis/diagnosis/outcomes/share.h"
#include "analysis/diagnosis/outcomes/side.h"
#include "analysis/diagnosis/policy/outcomes_and_rigs.h"
#include "analysis/diagnosis/policy/verdict.h"
#include "analysis/diagnosis/verdict/reject.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace stickslip::gap {
namespace {

/// The place within three times the range of the rows where two explanations differ most.
NextOutcome next_of(const OutcomeAnswer& a, const LawFit& one, const LawFit& two)
{
    const auto& o = a.outcomes;
    constexpr int steps = 9;
    constexpr double beyond = 3;  // numerical: times the range that is scanned
    const std::size_t n = o.table.paths.size();
    std::vector<double> low(n, infinity), high(n, -infinity);
    for (const auto& row : o.table.rows)
        for (std::size_t k = 0; k < n; ++k) {
            low[k] = std::min(low[k], row.settings[k]);
            high[k] = std::max(high[k], row.settings[k]);
        }
    NextOutcome next;
    double best = policy::least_apart;
    std::size_t places = 1;
    for (std::size_t k = 0; k < n; ++k) places *= low[k] < high[k] ? steps : 1;
    for (std::size_t place = 0; place < places; ++place) {
        std::vector<double> settings;
        std::size_t rest = place;
        for (std::size_t k = 0; k < n; ++k) {
            double value = low[k];
            if (low[k] < high[k]) {
                const double u = static_cast<double>(rest % steps) / (steps - 1);
                rest /= steps;
                value = low[k] > 0 ? low[k] / beyond * std::pow(high[k] / low[k] * beyond * beyond, u)
                                   : low[k] + (high[k] - low[k]) * u;
            }
            settings.push_back(value);
        }
        const Joint joint = joint_at(a.after, o.table, settings);
        const double p = probability_at(distance_to_stick_slip(with_law(joint, one.law)), one.softness);
        const double q = probability_at(distance_to_stick_slip(with_law(joint, two.law)), two.softness);
        if (std::abs(p - q) > best) {
            best = std::abs(p - q);
            next = {settings, p, q};
        }
    }
    return next;
}

void decide(OutcomeAnswer& a)
{
    Diagnosis& d = a.diagnosis;
    const auto& o = a.outcomes;
    const auto n = static_cast<double>(o.size());
    const auto explains = [&](const LawFit& f) { return f.misjudged <= a.contradictions + policy::most_misjudged * n; };
    const LawFit& winner = a.laws.front();
    std::set<std::string_view> effects{winner.rival->effect};
    for (const auto& f : a.laws) {
        if (&f == &winner || distinguished(winner, f) || !explains(f)) continue;
        effects.insert(f.rival->effect);
        d.ambiguous_with.push_back({std::string(f.rival->effect)});
        if (f.rival->effect == winner.rival->effect)
            d.reasons.push_back(
                {.code = Note::Code::laws_alike, .names = {std::string(winner.rival->law), std::string(f.rival->law)}});
    }
    if (a.contradictions > policy::most_contradicting * n) {
        d.verdict = Verdict::insufficient_data;
        d.reasons.push_back(
            {.code = Note::Code::rows_contradict, .values = {static_cast<double>(a.contradictions), n}});
    } else if (explains(a.nominal) && !distinguished(winner, a.nominal)) {
        d.verdict = Verdict::no_gap;
        d.reasons = {{Note::Code::nominal_explains}};
    } else if (!explains(winner)) {
        d.verdict = Verdict::unknown;
        d.reasons = {{.code = Note::Code::best_law_misjudges,
                      .names = {std::string(winner.rival->law)},
                      .values = {static_cast<double>(winner.misjudged), n}}};
        // their odds among each other say nothing of whether it is one of them
        if (const double factor = policy::believed_unnamed / winner.posterior; factor < 1)
            for (auto& f : a.laws) f.posterior *= factor;
    } else if (static_cast<double>(effects.size()) >= policy::too_many_kinds) {
        d.verdict = Verdict::insufficient_data;
        d.reasons.push_back({.code = Note::Code::kinds_alike, .values = {static_cast<double>(effects.size())}});
    } else {
        d.verdict = Verdict::gap;
    }
    if (d.verdict == Verdict::no_gap || d.verdict == Verdict::unknown) d.ambiguous_with.clear();
    for (const auto& f : a.laws) {
        const bool named =
            std::ranges::any_of(d.ambiguous_with, [&](const auto& c) { return c[0] == f.rival->effect; });
        if (&f != &winner && named && !distinguished(winner, f)) a.alike.push_back(f.rival->law);
    }
}

/// Fits every rival and judges the documented law, by distances to stick-slip first, the likely ones by their motion.
void fit_laws(OutcomeAnswer& a, const Joint& nominal, std::span<const RivalLaw> rivals, const ParallelFor& parallel,
              const StageProgress& progress)
{
    a.laws.resize(rivals.size());
    if (progress) progress(DiagnosisStage::fitting_laws, 0.1);
    const auto fit_at = [&](std::size_t i) -> LawFit& { return i == rivals.size() ? a.nominal : a.laws[i]; };
    parallel(rivals.size() + 1, [&](std::size_t i) {
        fit_at(i) = i == rivals.size() ? judge_nominal_law(a.outcomes, nominal) : fit_law(a.outcomes, rivals[i]);
    });
    if (progress) progress(DiagnosisStage::following_motions, 0.7);
    double likeliest = -infinity;
    for (const auto& f : a.laws) likeliest = std::max(likeliest, f.held_out);
    parallel(rivals.size() + 1, [&](std::size_t i) {
        LawFit& fit = fit_at(i);
        if (&fit == &a.nominal || fit.held_out > likeliest - policy::worth_following)
            confirm_by_motion(a.outcomes, fit);
    });
    double amplitudes = 0;
    for (const auto& f : a.laws) amplitudes = std::min(amplitudes, f.amplitude_held_out);
    for (auto& f : a.laws)
        if (!f.followed) f.amplitude_held_out = amplitudes;
}

/// Posteriors of the laws, the likeliest first. "None of these" guesses the share of stick-slip, and every amplitude to
/// be the middle one.
void rank_laws(OutcomeAnswer& a, std::size_t stuck)
{
    double best = -infinity, sum = 0;
    for (const auto& f : a.laws) best = std::max(best, f.total());
    const auto rows = static_cast<double>(a.outcomes.size());
    const double share = static_cast<double>(stuck) / rows;
    const double guess =
        rows * (share * std::log(share) + (1 - share) * std::log(1 - share)) + guessed_amplitudes(a.outcomes);
    sum = std::exp(std::min(0.0, guess - best));
    for (const auto& f : a.laws) sum += std::exp(f.total() - best);
    for (auto& f : a.laws) f.posterior = std::exp(f.total() - best) / sum;
    std::stable_sort(a.laws.begin(), a.laws.end(), [](const auto& x, const auto& y) { return x.total() > y.total(); });
}

/// What to measure next, between the winner and the likeliest law of another effect.
void propose_next(OutcomeAnswer& a)
{
    Diagnosis& d = a.diagnosis;
    const LawFit& winner = a.laws.front();
    const auto rival = std::find_if(a.laws.begin() + 1, a.laws.end(),
                                    [&](const auto& f) { return f.rival->effect != winner.rival->effect; });
    if (rival == a.laws.end() || d.verdict == Verdict::no_gap) return;
    a.next = next_of(a, winner, *rival);
    if (!a.next.settings.empty())
        d.next_experiment.separates.push_back({std::string(winner.rival->effect), std::string(rival->rival->effect)});
}

}  // namespace

OutcomeAnswer explain(const Joint& nominal, const OutcomeTable& table, const ParallelFor& parallel,
                      const StageProgress& progress, std::span<const RivalLaw> rivals,
                      const std::function<void()>& checkpoint)
{
    refuse_unfit(nominal, table);
    OutcomeAnswer a{{}, nominal, prepared(nominal, table), {}, {}, {}, {}, 0};
    a.outcomes.checkpoint = checkpoint;
    Diagnosis& d = a.diagnosis;
    d.motion = nominal.mechanism.motion;
    d.records.push_back({table.name, "held-out"});
    d.usual_speed = a.outcomes.scales.velocity;
    d.notes.push_back({Note::Code::fifths_in_turn});
    a.contradictions = contradictions(table, d.notes);
    std::size_t stuck = 0;
    for (const auto& row : table.rows) stuck += row.stick_slip;
    const std::size_t rarer = std::min(stuck, table.rows.size() - stuck);
    const auto rows = static_cast<double>(table.rows.size());
    if (rows < policy::fewest_outcomes || static_cast<double>(rarer) < policy::fewest_of_either) {
        d.reasons.push_back(
            {.code = Note::Code::too_few_outcomes,
             .record = table.name,
             .values = {rows, static_cast<double>(stuck), policy::fewest_outcomes, policy::fewest_of_either}});
        return a;
    }
    fit_laws(a, nominal, rivals, parallel, progress);
    if (progress) progress(DiagnosisStage::ranking_laws, 0.95);
    rank_laws(a, stuck);
    decide(a);
    const auto best_of = [&](bool memory) {
        const auto found =
            std::find_if(a.laws.begin(), a.laws.end(), [&](const auto& f) { return f.rival->memory == memory; });
        return found == a.laws.end() ? nullptr : &*found;
    };
    for (const auto& f : a.laws) d.effects.push_back(cause_of(a, f, best_of(!f.rival->memory)));
    locate(a);
    reject_if_not_validated(d, {.settled = true});
    const LawFit& winner = a.laws.front();
    if (d.verdict == Verdict::gap) {
        a.after = with_law(nominal, winner.law);
        if (winner.beyond_linear > 0)
            d.notes.push_back(
                {.code = Note::Code::beyond_linear, .values = {static_cast<double>(winner.beyond_linear)}});
    }
    propose_next(a);
    if (progress) progress(DiagnosisStage::done, 1);
    return a;
}

}  // namespace stickslip::gap
