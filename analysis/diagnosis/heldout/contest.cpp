#include "analysis/diagnosis/heldout/contest.h"

#include "analysis/diagnosis/fit/seeds.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace stickslip::gap {
namespace {

constexpr std::size_t level = 1;
constexpr std::array<std::string_view, 4> own_numbers{"coulomb-level", "viscous", "inertia", "constant-load"};
constexpr int first_look = 3, full_fit = 10, again = 4;  // iterations
constexpr std::size_t finalists = 6;
constexpr double worth_a_name = 0.25, in_every_fold = 0.15;  // of held-out RMS
constexpr double clearly = 0.05;                             // by which the first has to beat a rival in every fold

bool is_own_number(const Effect& e)
{
    return std::find(own_numbers.begin(), own_numbers.end(), e.name) != own_numbers.end();
}

/// The joint's own numbers that this joint has.
Candidate numbers_of(const std::vector<Case>& cases)
{
    Candidate base;
    base.records = cases.size();
    for (const auto name : own_numbers) {
        const Effect* e = effect_named(name);
        for (const auto& f : e->forms)
            if (!f.applies || f.applies(cases[0].joint)) {
                base.effects.push_back(e);
                base.forms.push_back(&f);
                break;
            }
    }
    return base;
}

Eigen::VectorXd join(const Eigen::VectorXd& a, const Eigen::VectorXd& b)
{
    Eigen::VectorXd x(a.size() + b.size());
    x << a, b;
    return x;
}

/// What the contestant, refitted without each fold, leaves there.
std::vector<double> squares_of(const std::vector<Case>& cases, const std::vector<Fold>& folds, const Scales& scales,
                               const Attribution& a)
{
    std::vector<double> squares;
    for (const auto& fold : folds) {
        const auto x = descend(without(cases, fold), a.candidate, scales, a.x[level], levels[level], again).x;
        squares.push_back(square_in(cases[fold.record], fold, scales, a.candidate, x, levels[level]));
    }
    return squares;
}

/// Fits at the middle level, whose parameters then stand for all.
void fit(const std::vector<Case>& cases, const Scales& scales, int iterations, Attribution& a)
{
    const auto found = descend(cases, a.candidate, scales, a.x[level], levels[level], iterations);
    a.x.fill(found.x);
    a.evaluation[level] = found.evaluation;
    a.information = found.information;
    a.evaluations += found.evaluations;
}

/// Every cause once more on top of the refitted numbers; the best few of a first look are fitted in full.
std::vector<Contestant> contestants(const std::vector<Case>& cases, const Scales& scales, const Attribution& base,
                                    const std::vector<Attribution>& singles, const ParallelFor& parallel)
{
    std::vector<Contestant> all;
    std::vector<Eigen::VectorXd> fitted;
    for (const auto& single : singles) {
        const Effect& e = *single.candidate.effects[0];
        const EffectForm& form = *single.candidate.forms[0];
        // two masses and searches cost ten times as much; a phase of its own for every record predicts nothing
        if (is_own_number(e) || form.rough || form.own > 0 || e.name == "compliance" || e.name == "backlash") continue;
        Contestant one;
        one.fit.candidate = base.candidate;
        one.fit.candidate.effects.push_back(&e);
        one.fit.candidate.forms.push_back(&form);
        all.push_back(one);
        fitted.push_back(single.x[level]);
    }
    const auto si = in_si(base.candidate, base.x[level], scales);
    parallel(all.size(), [&](std::size_t i) {
        Attribution& a = all[i].fit;
        auto from = starts(cases, scales, {{a.candidate.effects.back()}, {a.candidate.forms.back()}, cases.size()},
                           base.candidate, si);
        from.push_back(fitted[i]);
        double least = infinity;
        for (const auto& own : from) {
            const Eigen::VectorXd x = join(base.x[level], own);
            const double o = evaluate(cases, a.candidate, in_si(a.candidate, x, scales), levels[level]).objective;
            if (o < least) least = o, a.x[level] = x;
        }
        fit(cases, scales, first_look, a);
        a.score = a.evaluation[level].objective;
    });
    std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.fit.score < b.fit.score; });
    all.resize(std::min(all.size(), finalists));
    return all;
}

}  // namespace

ConfidenceInterval spread_of(const std::vector<double>& before, const std::vector<double>& after)
{
    ConfidenceInterval spread{1, -infinity};
    for (std::size_t f = 0; f < before.size(); ++f) {
        const double gain = 1 - std::sqrt(after[f] / before[f]);
        spread.low = std::min(spread.low, gain), spread.high = std::max(spread.high, gain);
    }
    return spread;
}

double square_in(const Case& c, const Fold& fold, const Scales& scales, const Candidate& candidate,
                 const Eigen::VectorXd& x, double omega)
{
    std::vector<double> residuals;
    evaluate({c}, candidate, in_si(candidate, x, scales), omega, &residuals);
    const auto rows = c.ticks.rows();
    double sum = 0, n = 0;
    std::size_t row = 0;
    for (std::size_t k = 0; k < c.ticks.size(); ++k) {
        if (!c.ticks.logged[k]) continue;
        if (c.ticks.time[k] >= fold.from && c.ticks.time[k] < fold.to)
            for (std::size_t i = row; i < residuals.size(); i += rows) sum += residuals[i] * residuals[i], n += 1;
        ++row;
    }
    return sum / std::max(n, 1.0);
}

void raise_floor(std::vector<Case>& cases, const Evaluation& now)
{
    for (std::size_t i = 0; i < cases.size(); ++i) {
        cases[i].sigma *= std::sqrt(std::max(now.records[i].position, 1e-12));
        if (cases[i].effort_sigma > 0) cases[i].effort_sigma *= std::sqrt(std::max(now.records[i].effort, 1e-12));
    }
}

Contest hold_contest(const std::vector<Case>& documented, const Scales& scales, const std::vector<Attribution>& singles,
                     const ParallelFor& parallel)
{
    Contest contest;
    std::vector<Case> cases = documented;
    const auto folds = folds_of(cases);
    Attribution nominal;
    Attribution& base = contest.base;
    base.candidate = numbers_of(cases);
    nominal.x[level] = Eigen::VectorXd();
    // factors are logarithms, so zero leaves every number as it is
    base.x[level] = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(base.candidate.parameter_count()));
    raise_floor(cases, evaluate(cases, {}, {}, levels[level]));
    std::vector<double> before;
    for (const auto& f : folds) before.push_back(square_in(cases[f.record], f, scales, {}, {}, levels[level]));
    fit(cases, scales, full_fit, base);
    contest.refit = spread_of(before, squares_of(cases, folds, scales, base));
    raise_floor(cases, base.evaluation[level]);
    fit(cases, scales, full_fit, base);
    before = squares_of(cases, folds, scales, base);
    contest.own_numbers = base.candidate.effects.size();

    contest.ranked = contestants(cases, scales, base, singles, parallel);
    parallel(contest.ranked.size(), [&](std::size_t i) {
        Contestant& one = contest.ranked[i];
        fit(cases, scales, full_fit, one.fit);
        one.squares = squares_of(cases, folds, scales, one.fit);
        one.spread = spread_of(before, one.squares);
        double with = 0, without_ = 0;
        for (std::size_t f = 0; f < folds.size(); ++f) with += one.squares[f], without_ += before[f];
        one.gain = 1 - std::sqrt(with / without_);
        one.fit.explained = 1 - with / without_;
    });
    std::stable_sort(contest.ranked.begin(), contest.ranked.end(),
                     [](const auto& a, const auto& b) { return a.gain > b.gain; });
    if (contest.ranked.empty()) return contest;
    const Contestant& best = contest.ranked[0];
    contest.decided = best.gain > worth_a_name && best.spread.low > in_every_fold;
    for (std::size_t i = 1; i < contest.ranked.size(); ++i)
        if (spread_of(contest.ranked[i].squares, best.squares).low < clearly)
            contest.ambiguous.push_back(&contest.ranked[i]);
    return contest;
}

}  // namespace stickslip::gap
