#include "analysis/diagnosis/verdict/judge_ladder.h"

#include "analysis/diagnosis/verdict/chances.h"

#include "analysis/diagnosis/fit/candidate_numbers.h"
#include "analysis/diagnosis/policy/ladder.h"
#include "analysis/diagnosis/policy/ladder_verdict.h"
#include "analysis/diagnosis/search/search.h"
#include "analysis/diagnosis/verdict/decide.h"
#include "analysis/diagnosis/verdict/experiment.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace stickslip::gap {
namespace {

Shares shares_of(const Ladder& ladder, const Flexible& of_corrected, const Flexible& of_last)
{
    Shares s;
    s.documented = beyond_noise(ladder.documented);
    s.base = beyond_noise(ladder.corrected.all_left());
    s.corrected = std::min(s.documented, beyond_noise(ladder.corrected_as_last));
    for (const auto& rung : ladder.rungs) s.rungs.push_back(beyond_noise(rung.all_left()));
    s.explainable_to = std::min(of_corrected.after, of_last.after);
    if (!s.rungs.empty()) s.explainable_to = std::min(s.explainable_to, s.rungs.back());
    return s;
}

/// Whether corrections stand in for the causes when these are left out: they go further off than documents are.
bool corrections_stand_in(const Ladder& ladder)
{
    return !ladder.rungs.empty() && ladder.last().model.numbers > 0 &&
           ladder.corrected.deviations() - ladder.last().deviations() > policy::standing_in;
}

/// Whether the rungs take most of what is explainable beyond the corrections.
bool takes_most(const Shares& s)
{
    const double explainable = s.base - s.explainable_to;
    if (s.rungs.empty() || !(explainable > 0)) return false;
    return s.base - s.rungs[0] >= policy::least_of_explainable * explainable ||
           (s.rungs.size() > 1 && s.base - s.rungs.back() >= policy::least_of_explainable_together * explainable);
}

/// Whether a free force of the signal that the first cause is a function of takes most of a rest that matters.
bool only_nearest(const JudgedLadder& j)
{
    const Effect& first = *j.ladder.rungs[0].causes.effects[0];
    return j.shares.rungs.back() > policy::nearest_in_shape * j.shares.base &&
           j.of_last.share_of(signal_of(first)) > policy::taken_by_free_force;
}

/// Why a ladder has no rung: no cause earns one, or one would with numbers that it cannot have.
Note why_no_rung(const Ladder& ladder)
{
    for (const auto& tried : ladder.rivals.empty() ? std::vector<Rival>{} : ladder.rivals[0])
        if (!tried.plausible && earns(ladder.corrected, tried, policy::ladder))
            return {.code = Note::Code::earns_implausible, .names = names_of(tried.causes)};
    return {Note::Code::nothing_earns};
}

/// Why the causes of a ladder are not the answer, if they are not.
std::optional<Note> why_not(const JudgedLadder& j)
{
    const auto& rungs = j.ladder.rungs;
    if (!j.noise_left && !takes_most(j.shares)) {
        // of what the corrections leave: beside them both may be next to nothing of the whole gap
        const double whole = std::max(1e-300, j.shares.base);
        const double taken = std::max(0.0, j.shares.base - j.shares.rungs[0]);
        return Note{.code = Note::Code::takes_too_little,
                    .names = names_of(rungs[0].causes),
                    .values = {taken / whole, (j.shares.base - j.shares.explainable_to) / whole}};
    }
    if (!j.noise_left && only_nearest(j))
        return Note{.code = Note::Code::force_in_the_rest,
                    .names = names_of(rungs.back().causes),
                    .signal = std::string(signal_of(*rungs[0].causes.effects[0]))};
    return std::nullopt;
}

}  // namespace

void hold_against(JudgedLadder& j, const FreeFit& force)
{
    if (!j.only_corrections && j.shares.rungs.back() < policy::all_but_explained * j.shares.base) return;
    // a free force takes the small terms that every machine has along: the cause is held against it with its own
    if (!clearly_better(force, std::min(mean_log_misfit(j.winner.evaluation), j.with_small_terms))) return;
    if (j.only_corrections) {
        const double more = force.fit.explained - j.winner.explained;
        if (more < policy::least_against_corrections * j.winner.explained) return;
        j.why_not = Note{.code = Note::Code::force_beside_numbers, .signal = std::string(force.of), .values = {more}};
    } else {
        j.why_not = Note{.code = Note::Code::nearer_force,
                         .names = names_of(j.ladder.last().causes),
                         .signal = std::string(force.of)};
    }
    j.named = j.only_corrections = false;
}

std::vector<std::string> JudgedLadder::with_numbers(std::vector<std::string> causes) const
{
    for (const auto& [effect, share] : numbers)
        if (!std::ranges::count(causes, effect->name)) causes.emplace_back(effect->name);
    return causes;
}

bool corrections_take_most(const Shares& s)
{
    return s.documented - s.base >= std::max(policy::least_of_gap * s.documented,
                                             policy::least_of_explainable * (s.documented - s.explainable_to));
}

namespace {

/// Moves a correction of a fit behind its causes.
void count_as_cause(Attribution& a, std::size_t& corrections, const Effect* effect)
{
    Candidate& c = a.candidate;
    const auto from = std::ranges::find(c.effects, effect) - c.effects.begin();
    Eigen::Index at = 0;
    for (std::ptrdiff_t i = 0; i < from; ++i)
        at += static_cast<Eigen::Index>(c.count_of(*c.forms[static_cast<std::size_t>(i)]));
    const auto count = static_cast<Eigen::Index>(c.count_of(*c.forms[static_cast<std::size_t>(from)]));
    std::vector<Eigen::Index> order;
    for (Eigen::Index i = 0; i < static_cast<Eigen::Index>(c.parameter_count()); ++i)
        if (i < at || i >= at + count) order.push_back(i);
    for (Eigen::Index i = at; i < at + count; ++i) order.push_back(i);
    for (auto& x : a.x)
        if (x.size() == static_cast<Eigen::Index>(order.size())) x = Eigen::VectorXd(x(order));
    if (a.information.rows() == static_cast<Eigen::Index>(order.size()))
        a.information = Eigen::MatrixXd(a.information(order, order));
    c.prior_sd.erase(c.prior_sd.begin() + at, c.prior_sd.begin() + at + count);
    std::rotate(c.effects.begin() + from, c.effects.begin() + from + 1, c.effects.end());
    std::rotate(c.forms.begin() + from, c.forms.begin() + from + 1, c.forms.end());
    --corrections;
}

}  // namespace

void count_far_numbers(JudgedLadder& j, const std::vector<FarNumber>& far)
{
    if (!j.answers()) return;
    const double after = j.only_corrections ? j.shares.base : j.shares.rungs.back();
    const double by_causes = (j.only_corrections ? j.shares.documented : j.shares.corrected) - after;
    const auto left = j.ladder.last().all_left();
    for (const auto& number : far) {
        const double least = number.unstated_load ? policy::least_of_unstated : policy::as_much_as_causes;
        if (beyond_noise(number.as_documented) - after < least * by_causes) continue;
        j.numbers.emplace_back(number.effect, share_between(j.ladder.documented, number.as_documented, left));
        if (!j.only_corrections) count_as_cause(j.winner, j.corrections, number.effect);
    }
}

std::string_view signal_of(const Effect& effect)
{
    const auto is = [&](std::initializer_list<std::string_view> names) {
        return std::find(names.begin(), names.end(), effect.name) != names.end();
    };
    if (is({"gravity", "cogging", "constant-load", "sensor-offset"})) return "position";
    if (is({"position-dependent-friction"})) return "direction";
    if (is({"stribeck", "viscous", "asymmetric-friction", "coulomb-level"})) return "velocity";
    if (is({"presliding", "frictional-memory", "backlash", "compliance"})) return "history";
    if (is({"friction-drift", "periodic-disturbance"})) return "time";
    if (is({"inertia"})) return "acceleration";
    return "effort";
}

Attribution at_all_levels(const Fit& fit, const FittedSet& set)
{
    return as_screened(fit, set.model.candidate, set.fit);
}

bool leaves_noise(const Fit& fit, const FittedSet& set)
{
    const Attribution all = at_all_levels(fit, set);
    return all.accepted && at_floor(fit, all);
}

SharesWithInterval share_between(const std::vector<Window>& documented, const std::vector<Window>& above,
                                 const std::vector<Window>& below)
{
    constexpr int resamples = 200;
    SharesWithInterval result;
    const std::size_t n = std::min({documented.size(), above.size(), below.size()});
    if (n == 0) return result;
    const auto of = [&](auto&& pick) {
        double whole = 0, taken = 0;
        for (std::size_t i = 0; i < n; ++i) {
            const std::size_t w = pick(i);
            whole += documented[w].beyond_noise();
            taken += above[w].beyond_noise() - below[w].beyond_noise();
        }
        return whole > 0 ? std::clamp(taken / whole, -1.0, 1.0) : 0;
    };
    result.share = of([](std::size_t i) { return i; });
    std::uint64_t state = 1;
    std::vector<double> drawn;
    for (int r = 0; r < resamples; ++r)
        drawn.push_back(of([&](std::size_t) {
            state = state * 6364136223846793005ull + 1442695040888963407ull;
            return static_cast<std::size_t>((state >> 33) % n);
        }));
    std::sort(drawn.begin(), drawn.end());
    result.low = drawn[resamples / 40], result.high = drawn[resamples - 1 - resamples / 40];
    return result;
}

void judge(JudgedLadder& j, const HeldOutData& data, const Fit& fit)
{
    const Ladder& ladder = j.ladder;
    const FittedSet& base = ladder.corrected;
    const FittedSet& last = ladder.last();
    j.of_corrected = regress(data, fit.scales, base.model.candidate, base.x, base.fit.x);
    j.of_last =
        ladder.rungs.empty() ? j.of_corrected : regress(data, fit.scales, last.model.candidate, last.x, last.fit.x);
    j.shares = shares_of(ladder, j.of_corrected, j.of_last);
    if (corrections_stand_in(ladder)) j.shares.base = std::max(j.shares.base, j.shares.corrected);
    j.winner = at_all_levels(fit, last);
    j.winner.refined = true;
    // its fit weighed by what it leaves: errors are those of the documented noise
    j.winner.information =
        descend({fit.cases, j.winner.candidate, fit.scales, levels[ladder_level]}, last.fit.x, 1).information;
    j.corrections = last.model.corrections;
    j.noise_left = j.winner.accepted && at_floor(fit, j.winner);
    j.usual = usual_of_machines(ladder);
    if (ladder.rungs.empty()) {
        // nothing but the document's numbers: if they take most of what is explainable, that is the answer
        j.only_corrections = j.noise_left || corrections_take_most(j.shares);
        if (!j.only_corrections) j.why_not = why_no_rung(ladder);
        return;
    }
    j.chances = chances_of(j);
    j.why_not = why_not(j);
    j.named = !j.why_not;
}

}  // namespace stickslip::gap
