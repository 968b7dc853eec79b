#include "analysis/diagnosis/verdict/chances.h"

#include "analysis/diagnosis/fit/candidate_numbers.h"
#include "analysis/diagnosis/ladder/ladder.h"
#include "analysis/diagnosis/policy/ladder.h"
#include "analysis/diagnosis/policy/ladder_verdict.h"
#include "analysis/results/diagnosis.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace stickslip::gap {
namespace {

/// Whether this holds for every cause of the last rung, by its place among all causes.
bool every_last_cause(const Ladder& ladder, const std::function<bool(std::size_t)>& holds)
{
    if (!ladder.corrections || ladder.rungs.empty()) return false;
    const Candidate& causes = ladder.rungs.back().causes;
    for (std::size_t i = 0; i < causes.effects.size(); ++i) {
        const bool below = ladder.rungs.size() > 1 &&
                           std::ranges::count(ladder.rungs[ladder.rungs.size() - 2].causes.effects, causes.effects[i]);
        if (!below && !holds(i)) return false;
    }
    return true;
}

/// What part of its chance the last of several rungs keeps beside what the ladder leaves. A number that is only freed
/// from the bound of its correction had taken nearly all before.
double part_kept(const JudgedLadder& j)
{
    const auto& rungs = j.ladder.rungs;
    if (j.noise_left || rungs.size() < 2 || frees_held_number(j.ladder)) return 1;
    const double taken = std::max(0.0, part_taken(rungs[rungs.size() - 2], rungs.back())), left = 1 - taken;
    const double enough = policy::taken_of_rest * left;
    return taken < enough ? taken / enough : 1;
}

/// Whether a number of the document would be further off than documents are, beside all causes.
bool holds_a_number_back(const FittedSet& set)
{
    const Candidate& c = set.model.candidate;
    for (std::size_t i = 0, at = 0; i < set.model.corrections; at += c.count_of(*c.forms[i++]))
        if (!Corrections::is_small_term(*c.effects[i]) && Corrections::at_its_bound(c, i, at, set.fit.x)) return true;
    return false;
}

/// How much of a rival a form of the rung's causes is made of, in parts of the cause in whose place the rival stands.
double made_of(const FittedSet& rung, const FittedSet& rival)
{
    const auto has = [&](const FittedSet& set, std::string_view name) {
        return std::ranges::any_of(set.causes.effects, [&](const Effect* e) { return e->name == name; });
    };
    const Eigen::VectorXd x = rung.of_causes(rung.fit.x);
    Eigen::Index at = 0;
    for (std::size_t i = 0; i < rung.causes.effects.size(); ++i) {
        at += static_cast<Eigen::Index>(rung.causes.count_of(*rung.causes.forms[i]));
        const auto other = rung.causes.forms[i]->mixed_with;
        if (!other.empty() && has(rival, other) && !has(rival, rung.causes.effects[i]->name))
            return std::exp(x[at - 1]);
    }
    return 0;
}

}  // namespace

std::vector<double> odds_of_rivals(const JudgedLadder& j, std::size_t i)
{
    const FittedSet &rung = j.ladder.rungs[i], &last = j.ladder.last();
    const auto in_the_set = [&](const Effect* e) { return std::ranges::count(last.causes.effects, e) > 0; };
    const auto is_dropped = [&](const Effect* e) { return std::ranges::count(j.dropped, e) > 0; };
    // what a lower rung leaves is no doubt once all is explained
    const bool settled = j.noise_left && i + 1 < j.ladder.rungs.size();
    const auto odds = [](double misfit, double of_rival, double margin) {
        return std::exp(std::min(0.0, misfit - of_rival) / margin);
    };
    std::vector<double> all;
    for (const auto& rival : j.ladder.rivals[i]) {
        const bool same = move_alike(rung.causes, rival.causes);
        const FittedSet& named = rival.in_the_last ? last : rung;
        const double margin = margin_of(named, policy::ladder), misfit = rival.in_the_last.value_or(rival.misfit);
        // another rung of this ladder is no rival
        if ((settled && !(same && rival.in_the_last)) || std::ranges::all_of(rival.causes.effects, in_the_set) ||
            std::ranges::any_of(rival.causes.effects, is_dropped))
            all.push_back(0);
        else if (same && misfit < infinity)
            // not worse by its numbers, nor by what a number of the document costs it that is free beside the other: as
            // likely as what it leaves
            all.push_back(odds(mean_log(named.all_left()), mean_log(rival.named().all_left()), margin));
        else
            all.push_back(odds(named.misfit, misfit, margin));
        if (const double part = made_of(rung, rival); part >= policy::as_much_the_other)
            all.back() = std::max(all.back(), std::min(1.0, part));
    }
    return all;
}

std::vector<double> chances_of(const JudgedLadder& j)
{
    std::vector<double> chances;
    const double whole = std::max(1e-300, j.shares.base - j.shares.explainable_to);
    const double left = std::clamp((j.shares.rungs.back() - j.shares.explainable_to) / whole, 0.0, 1.0);
    const double rest = j.shares.rungs.back() / std::max(1e-300, j.shares.base) / policy::nearest_in_shape;
    const double doubt =
        policy::doubt_of_noise + (j.noise_left ? 0.0 : policy::doubt_of_rest * std::clamp(rest, 0.0, 1.0) + left);
    for (std::size_t i = 0; i < j.ladder.rungs.size(); ++i) {
        const auto odds = odds_of_rivals(j, i);
        const double sum = std::accumulate(odds.begin(), odds.end(), 1.0);
        // a rest speaks against the last cause that was found: the others take more than it does
        const bool last = i + 1 == j.ladder.rungs.size();
        double chance = std::max(0.0, 1 - (last ? doubt : policy::doubt_of_noise)) / sum * (last ? part_kept(j) : 1);
        if (last && !j.noise_left && holds_a_number_back(j.ladder.rungs[i]))
            chance = std::min(chance, policy::believed_held_back);
        chances.push_back(chance);
    }
    return chances;
}

bool usual_of_machines(const Ladder& ladder)
{
    const auto usual = [&](std::size_t i) {
        const FittedSet& last = ladder.rungs.back();
        return ladder.corrections->is_usual(last.causes, last.of_causes(last.fit.x), *last.causes.effects[i]);
    };
    return every_last_cause(ladder, usual);
}

bool frees_held_number(const Ladder& ladder)
{
    if (ladder.rungs.empty()) return false;
    const FittedSet& below = ladder.rungs.size() > 1 ? ladder.rungs[ladder.rungs.size() - 2] : ladder.corrected;
    const Candidate& c = below.model.candidate;
    return every_last_cause(ladder, [&](std::size_t cause) {
        const auto name = ladder.rungs.back().causes.effects[cause]->name;
        for (std::size_t i = 0, at = 0; i < below.model.corrections; at += c.count_of(*c.forms[i++]))
            if (c.effects[i]->name == name && c.forms[i]->own == 0 && !Corrections::is_small_term(*c.effects[i]))
                return Corrections::at_its_bound(c, i, at, below.fit.x);
        return false;
    });
}

bool only_stated_numbers(const Ladder& ladder)
{
    if (!ladder.corrections || ladder.rungs.empty()) return false;
    const Candidate& causes = ladder.last().causes;
    for (std::size_t i = 0; i < causes.effects.size(); ++i)
        if (!ladder.corrections->same_number(*causes.effects[i], *causes.forms[i])) return false;
    return true;
}

namespace {

/// Whether rung i takes little beside the corrections and the rungs above it.
bool takes_little(const Shares& s, std::size_t i)
{
    const double above = i > 0 ? s.rungs[i - 1] : s.corrected;
    return above - s.rungs[i] < policy::least_against_corrections * (s.documented - above);
}

}  // namespace

const Effect* small_term_between(const JudgedLadder& j)
{
    const Ladder& ladder = j.ladder;
    const FittedSet& last = ladder.last();
    for (std::size_t i = 1; i + 1 < ladder.rungs.size(); ++i) {
        const auto& above = ladder.rungs[i - 1].causes.effects;
        for (const Effect* cause : ladder.rungs[i].causes.effects)
            if (std::ranges::count(above, cause) == 0 && takes_little(j.shares, i) &&
                ladder.corrections->is_usual(last.causes, last.of_causes(last.fit.x), *cause))
                return cause;
    }
    return nullptr;
}

bool small_against_corrections(const JudgedLadder& j)
{
    // small terms that every machine has are not what the gap comes from, beside corrections or another cause
    const Shares& s = j.shares;
    if (!j.usual || s.rungs.empty()) return false;
    return takes_little(s, s.rungs.size() - 1);
}

}  // namespace stickslip::gap
