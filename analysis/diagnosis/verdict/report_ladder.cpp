#include "analysis/diagnosis/verdict/report_ladder.h"

#include "analysis/diagnosis/policy/ladder.h"
#include "analysis/diagnosis/policy/ladder_verdict.h"
#include "analysis/diagnosis/policy/verdict.h"
#include "analysis/diagnosis/verdict/causes.h"
#include "analysis/diagnosis/verdict/experiment.h"
#include "analysis/diagnosis/verdict/reject.h"
#include "analysis/diagnosis/verdict/report_corrections.h"

#include <algorithm>
#include <cmath>

namespace stickslip::gap {
namespace {

/// The causes of a set in place of this rung that the rung below does not have.
std::vector<std::string> added_by(const Ladder& ladder, std::size_t rung, const Candidate& causes)
{
    std::vector<std::string> names;
    for (const auto* e : causes.effects)
        if (rung == 0 || std::ranges::count(ladder.rungs[rung - 1].causes.effects, e) == 0) names.emplace_back(e->name);
    return names;
}

/// All causes of the ladder, with those of a rival in place of its rung.
std::vector<std::string> with_the_others(const JudgedLadder& j, std::size_t rung, const Candidate& rival)
{
    const Ladder& ladder = j.ladder;
    auto names = names_of(rival);
    for (const auto* e : ladder.last().causes.effects)
        if (std::ranges::count(ladder.rungs[rung].causes.effects, e) == 0 && std::ranges::count(rival.effects, e) == 0)
            names.emplace_back(e->name);
    return j.with_numbers(std::move(names));
}

/// A number of the document as a rung. Several far numbers may make up for each other: together they take no more than
/// all corrections do.
LadderRung rung_of(const JudgedLadder& j, const Cause& whole, const Effect& number, const SharesWithInterval& share)
{
    LadderRung rung;
    rung.names = {std::string(number.name)};
    const double corrected = std::max(0.0, 1 - j.shares.corrected / std::max(1e-300, j.shares.documented));
    const double part = std::min(1.0, corrected / std::max(1e-300, taken_by_numbers(j)));
    rung.share = part * share.share, rung.interval = {part * share.low, part * share.high};
    for (const auto& parameter : whole.parameters)
        if (is_of(parameter, rung.names[0])) rung.parameters.push_back(parameter);
    rung.probability = 1 - policy::doubt_of_noise;
    return rung;
}

LadderRung rung_of(const JudgedLadder& j, const Cause& whole, std::size_t i)
{
    const FittedSet& set = j.ladder.rungs[i];
    LadderRung rung;
    rung.names = added_by(j.ladder, i, set.causes);
    const bool worse = j.shares.corrected >= j.shares.documented;
    const auto above = i > 0   ? j.ladder.rungs[i - 1].all_left()
                       : worse ? j.ladder.documented
                               : j.ladder.corrected_as_last;
    const auto share = share_between(j.ladder.documented, above, set.all_left());
    rung.share = share.share, rung.interval = {share.low, share.high};
    for (const auto& parameter : whole.parameters)
        for (const auto& name : rung.names)
            if (is_of(parameter, name)) rung.parameters.push_back(parameter);
    for (const auto& rival : indistinguishable(j))
        if (rival.rung == i) rung.ambiguous_with.push_back(added_by(j.ladder, i, rival.set->causes));
    rung.probability = j.chances[i];
    return rung;
}

std::vector<std::string> signals_in(const Flexible& flexible)
{
    std::vector<std::string> signals;
    for (const auto& [signal, share] : flexible.alone)
        if (share > policy::ladder.worth_telling) signals.emplace_back(signal);
    return signals;
}

/// What is explainable where nothing was climbed: what the audited joint takes, and what a flexible force of the
/// signals still takes of what that leaves. A joint without a gap has nothing to explain.
ExplainableShare beside_the_audit(const Prepared& p, double audited)
{
    ExplainableShare ceiling;
    ceiling.share = not_set;
    if (p.audit.findings.empty()) return ceiling;
    const HeldOutData data(p.cases);
    const Flexible rest = regress(data, p.scales, {}, {}, {});
    const double more = rest.before > 0 ? std::clamp(1 - rest.after / rest.before, 0.0, 1.0) : 0;
    ceiling.share = audited + (1 - audited) * more;
    ceiling.depends_on = signals_in(rest);
    return ceiling;
}

}  // namespace

std::vector<RungRival> rivals_of(const JudgedLadder& j)
{
    std::vector<RungRival> rivals;
    for (std::size_t i = 0; i < j.ladder.rungs.size(); ++i) {
        const auto odds = odds_of_rivals(j, i);
        const auto own = added_by(j.ladder, i, j.ladder.rungs[i].causes);
        for (std::size_t r = 0; r < odds.size(); ++r) {
            const Rival& set = j.ladder.rivals[i][r];
            rivals.push_back({i,
                              &set,
                              &set.named(),
                              odds[r],
                              with_the_others(j, i, set.causes),
                              {own[0], added_by(j.ladder, i, set.causes)[0]}});
        }
    }
    return rivals;
}

std::vector<RungRival> indistinguishable(const JudgedLadder& j)
{
    auto rivals = rivals_of(j);
    std::erase_if(rivals, [](const RungRival& r) { return r.odds < policy::odds_of_indistinguishable; });
    return rivals;
}

double chance_of_all(const JudgedLadder& j)
{
    double all = 1;
    for (const double chance : j.chances) all *= chance;
    for (std::size_t i = 0; i < j.numbers.size(); ++i) all *= 1 - policy::doubt_of_noise;
    return all;
}

void report_ladder(const Prepared& p, const Findings& f, double audited, Diagnosis& d)
{
    const double rest = 1 - audited;
    if (!p.audit.findings.empty()) {
        const Cause found = cause_of(p, f.none, 1);
        d.ladder.push_back({found.names, audited, {}, found.parameters, {}, 1 - policy::doubt_of_finding});
    }
    if (!f.climbed) {
        d.ceiling = beside_the_audit(p, audited);
        return;
    }
    const JudgedLadder& j = f.judged;
    const Cause whole = cause_of(p, j.winner, 1, j.corrections);
    const bool told = f.named();
    if (told)
        for (std::size_t i = 0; i < j.ladder.rungs.size(); ++i) {
            auto rung = rung_of(j, whole, i);
            if (!f.by_ladder) {
                rung.probability = d.effects.empty() ? 0 : d.effects[0].probability;
                for (const auto* rival : f.decision.ambiguous)
                    if (i == 0) rung.ambiguous_with.push_back(names_of(rival->candidate));
            }
            d.ladder.push_back(std::move(rung));
        }
    const auto first = static_cast<std::ptrdiff_t>(p.audit.findings.empty() ? 0 : 1);
    d.corrections = corrections_of(p, j);
    if (!(j.shares.documented > 0)) {
        // from row to row all is within the noise: nothing is left to be explained
        d.ceiling.share = 1, d.ceiling.interval = {1, 1};
        d.corrected_share = rest;
        d.remainder.share = 0;
        return;
    }
    const double gap = j.shares.documented;
    // where nothing is named, no cause stands beside the corrections
    d.corrected_share = std::max(0.0, 1 - (told ? j.shares.corrected : j.shares.base) / gap);
    for (const auto& [effect, share] : j.numbers) {
        if (!j.named) break;  // numbers alone are corrections, however much they take
        auto rung = rung_of(j, whole, *effect, share);
        d.corrected_share = std::max(0.0, d.corrected_share - rung.share);
        const auto smaller = std::find_if(d.ladder.begin() + first, d.ladder.end(),
                                          [&](const LadderRung& other) { return other.share < rung.share; });
        d.ladder.insert(smaller, std::move(rung));
    }
    d.corrected_share *= rest;
    for (auto rung = d.ladder.begin() + first; rung != d.ladder.end(); ++rung)
        rung->share *= rest, rung->interval.low *= rest, rung->interval.high *= rest;
    const auto explainable = share_between(j.ladder.documented, j.ladder.documented, j.ladder.last().all_left());
    const double more = (beyond_noise(j.ladder.last().all_left()) - j.shares.explainable_to) / gap;
    d.ceiling.share = audited + rest * std::clamp(explainable.share + more, 0.0, 1.0);
    d.ceiling.interval = {audited + rest * std::clamp(explainable.low + more, 0.0, 1.0),
                          audited + rest * std::clamp(explainable.high + more, 0.0, 1.0)};
    d.ceiling.depends_on = signals_in(j.of_corrected);
    const double left = told ? beyond_noise(j.ladder.last().all_left()) : j.shares.base;
    d.remainder.share = rest * std::clamp(left / gap, 0.0, 1.0);
    if (!j.noise_left) d.remainder.structure = signals_in(j.of_last);
}

std::vector<Cause> causes_of(const Prepared& p, const JudgedLadder& j)
{
    if (j.ladder.rungs.empty()) return j.only_corrections ? numbers_alone(p, j) : std::vector<Cause>{};
    std::vector<Cause> causes;
    const double all = chance_of_all(j);
    Cause first = cause_of(p, j.winner, j.named ? all : policy::believed_unnamed * all, j.corrections);
    const auto gain = [&](const FittedSet& set) {
        return 1 - std::sqrt(beyond_noise(set.all_left()) / std::max(1e-300, j.shares.base));
    };
    first.plausible = j.ladder.last().plausible;        // a correction at the end of its prior does not count
    first.misfit = misfit(j.ladder.last().all_left());  // as that of its rivals
    first.heldout_gain = gain(j.ladder.last());
    first.heldout_gain_interval = {1, -infinity};
    for (std::size_t f = 0; f < HeldOutData::folds; ++f) {
        const double before = beyond_noise(j.ladder.corrected.left[f]), after = beyond_noise(j.ladder.last().left[f]);
        const double in_fold = before > 0 ? 1 - std::sqrt(after / before) : 0;
        first.heldout_gain_interval.low = std::min(first.heldout_gain_interval.low, in_fold);
        first.heldout_gain_interval.high = std::max(first.heldout_gain_interval.high, in_fold);
    }
    causes.push_back(std::move(first));
    const auto add = [&](const FittedSet& rival, const std::vector<std::string>& names, double probability) {
        Cause c;
        c.names = with_findings(p, names);
        c.plausible = rival.plausible;
        c.heldout_gain = gain(rival);
        c.misfit = misfit(rival.all_left());
        c.probability = (j.named ? 1.0 : policy::believed_unnamed) * probability;
        std::size_t i = 0;
        const auto si = in_si(rival.causes, rival.of_causes(rival.fit.x), p.scales);
        for (std::size_t n = 0; n < rival.causes.effects.size(); ++n)
            for (std::size_t k = 0; k < rival.causes.count_of(*rival.causes.forms[n]); ++k, ++i)
                c.parameters.push_back(
                    {std::string(rival.causes.effects[n]->name) + "." + std::string(rival.causes.parameter(i).name),
                     si[i], not_set,
                     std::string(unit_of(rival.causes.parameter(i).quantity, units_of(p.documented[0])))});
        causes.push_back(std::move(c));
    };
    for (const auto& rival : rivals_of(j))
        if (rival.rung == 0 || rival.odds >= policy::odds_of_indistinguishable)
            add(*rival.named, rival.names, all * rival.odds);
    return causes;
}

}  // namespace stickslip::gap
