#include "analysis/gap/contest.h"

#include "analysis/gap/seeds.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace stickslip::gap {
namespace {

constexpr std::size_t level = 1;
constexpr std::array<std::string_view, 4> own_numbers{"coulomb-level", "viscous", "inertia", "constant-load"};
constexpr int first_fit = 10, again = 4;

bool is_own_number(const Effect& e)
{
    return std::find(own_numbers.begin(), own_numbers.end(), e.name) != own_numbers.end();
}

/// The joint's own numbers that this joint has.
Candidate numbers_of(const Joint& joint)
{
    Candidate base;
    for (const auto name : own_numbers) {
        const Effect* e = effect_named(name);
        for (const auto& f : e->forms)
            if (!f.applies || f.applies(joint)) {
                base.effects.push_back(e);
                base.forms.push_back(&f);
                break;
            }
    }
    return base;
}

Eigen::VectorXd unchanged(const Candidate& c)
{
    Eigen::VectorXd x = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(c.parameter_count()));
    return x;  // factors are logarithms: 0 is one
}

Eigen::VectorXd join(const Eigen::VectorXd& a, const Eigen::VectorXd& b)
{
    Eigen::VectorXd x(a.size() + b.size());
    x << a, b;
    return x;
}

/// Mean square of the scaled residuals inside each fold.
std::vector<double> in_folds(const std::vector<Case>& cases, const std::vector<Fold>& folds, const Scales& scales,
                             const Candidate& candidate, const std::vector<Eigen::VectorXd>& x)
{
    std::vector<double> squares;
    for (std::size_t f = 0; f < folds.size(); ++f) {
        const Case& c = cases[folds[f].record];
        std::vector<double> residuals;
        evaluate({c}, candidate, in_si(candidate, x[f], scales), levels[level], &residuals);
        double sum = 0, n = 0;
        std::size_t row = 0;
        const auto rows = static_cast<std::size_t>(std::count(c.ticks.logged.begin(), c.ticks.logged.end(), 1));
        for (std::size_t k = 0; k < c.ticks.size(); ++k) {
            if (!c.ticks.logged[k]) continue;
            if (c.ticks.time[k] >= folds[f].from && c.ticks.time[k] < folds[f].to)
                for (std::size_t i = row; i < residuals.size(); i += rows) sum += residuals[i] * residuals[i], n += 1;
            ++row;
        }
        squares.push_back(sum / std::max(n, 1.0));
    }
    return squares;
}

/// The case without a fold, for a fit.
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

/// Fits to all, then without each fold from there.
std::vector<Eigen::VectorXd> fit_folds(const std::vector<Case>& cases, const std::vector<Fold>& folds,
                                       const Scales& scales, Contestant& one)
{
    one.x = descend(cases, one.candidate, scales, one.x, levels[level], first_fit).x;
    std::vector<Eigen::VectorXd> x;
    for (const auto& fold : folds)
        x.push_back(descend(without(cases, fold), one.candidate, scales, one.x, levels[level], again).x);
    return x;
}

void rate(Contestant& one, const std::vector<double>& before, const std::vector<double>& after)
{
    double sum_before = 0, sum_after = 0;
    one.spread = {1, -infinity};
    for (std::size_t f = 0; f < before.size(); ++f) {
        sum_before += before[f], sum_after += after[f];
        const double gain = 1 - std::sqrt(after[f] / before[f]);
        one.spread.low = std::min(one.spread.low, gain), one.spread.high = std::max(one.spread.high, gain);
    }
    one.gain = 1 - std::sqrt(sum_after / sum_before);
}

}  // namespace

Contest hold_contest(const std::vector<Case>& documented, const Scales& scales, const std::vector<Attribution>& singles,
                     const ParallelFor& parallel)
{
    Contest contest;
    std::vector<Case> cases = documented;
    const auto folds = folds_of(cases);
    // what the refitted joint leaves in each record is the noise of this contest: no record drowns the others
    const auto raise_floor = [&](const Candidate& c, const Eigen::VectorXd& x) {
        const auto now = evaluate(cases, c, in_si(c, x, scales), levels[level]);
        for (std::size_t i = 0; i < cases.size(); ++i) {
            cases[i].sigma *= std::sqrt(std::max(now.records[i].position, 1e-12));
            if (cases[i].effort_sigma > 0) cases[i].effort_sigma *= std::sqrt(std::max(now.records[i].effort, 1e-12));
        }
    };
    contest.refitted.candidate = numbers_of(cases[0].joint);
    contest.refitted.x = unchanged(contest.refitted.candidate);
    raise_floor({}, {});
    const auto nominal = in_folds(cases, folds, scales, {}, std::vector<Eigen::VectorXd>(folds.size()));
    auto x = fit_folds(cases, folds, scales, contest.refitted);
    rate(contest.refitted, nominal, in_folds(cases, folds, scales, contest.refitted.candidate, x));
    raise_floor(contest.refitted.candidate, contest.refitted.x);
    x = fit_folds(cases, folds, scales, contest.refitted);
    const auto before = in_folds(cases, folds, scales, contest.refitted.candidate, x);

    constexpr std::size_t two_masses_among = 3;
    for (std::size_t i = 0; i < singles.size(); ++i) {
        const Effect& e = *singles[i].candidate.effects[0];
        const bool divided = e.name == "backlash" || e.name == "compliance";
        if (is_own_number(e) || (divided && i >= two_masses_among)) continue;
        for (const auto& f : e.forms) {
            if (f.applies && !f.applies(cases[0].joint)) continue;
            if (f.own > 0) continue;  // a phase of its own for every record predicts nothing
            Contestant one;
            one.candidate = contest.refitted.candidate;
            one.candidate.effects.push_back(&e);
            one.candidate.forms.push_back(&f);
            contest.ranked.push_back(one);
        }
    }
    const auto base_si = in_si(contest.refitted.candidate, contest.refitted.x, scales);
    parallel(contest.ranked.size(), [&](std::size_t i) {
        Contestant& one = contest.ranked[i];
        double least = infinity;
        for (const auto& seed : starts(cases, scales, {{one.candidate.effects.back()}, {one.candidate.forms.back()}},
                                       contest.refitted.candidate, base_si)) {
            const Eigen::VectorXd from = join(contest.refitted.x, seed);
            const double objective =
                evaluate(cases, one.candidate, in_si(one.candidate, from, scales), levels[level]).objective;
            if (objective < least) least = objective, one.x = from;
        }
        if (least == infinity) return;
        const auto fitted = fit_folds(cases, folds, scales, one);
        rate(one, before, in_folds(cases, folds, scales, one.candidate, fitted));
    });
    std::stable_sort(contest.ranked.begin(), contest.ranked.end(),
                     [](const auto& a, const auto& b) { return a.gain > b.gain; });
    for (auto i = contest.ranked.begin(); i != contest.ranked.end(); ++i)  // the best form of each
        contest.ranked.erase(
            std::remove_if(i + 1, contest.ranked.end(),
                           [&](const auto& o) { return o.candidate.effects.back() == i->candidate.effects.back(); }),
            contest.ranked.end());
    if (contest.ranked.empty()) return contest;
    auto& best = contest.ranked[0];
    contest.decided = best.gain > worth_a_name && best.spread.low > 0;
    for (std::size_t i = 1; i < contest.ranked.size(); ++i)
        if (contest.ranked[i].gain > distinct * best.gain) contest.decided = false;
    return contest;
}

}  // namespace stickslip::gap
