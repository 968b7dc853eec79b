#include "analysis/gap/attribute.h"

#include "analysis/gap/seeds.h"

#include <algorithm>
#include <cmath>

namespace stickslip::gap {
namespace {

constexpr int iterations = 12;
constexpr std::size_t refined_singles = 8, refined_pairs = 6;

/// One descent, or a search where the misfit is jagged.
LevelFit improve(const std::vector<Case>& cases, const Candidate& candidate, const Scales& scales,
                 const Eigen::VectorXd& x, double omega, int effort)
{
    for (const auto* f : candidate.forms)
        if (f->rough)
            return search_rough(cases, candidate, scales, x, omega,
                                effort * static_cast<int>(candidate.parameter_count()));
    return descend(cases, candidate, scales, x, omega, iterations);
}

/// The best of descents from the given starts at one level. Jagged misfits try all starts and go on from the two best.
LevelFit best_of(const std::vector<Case>& cases, const Scales& scales, const Candidate& candidate,
                 const std::vector<Eigen::VectorXd>& from, double omega)
{
    std::vector<std::pair<double, std::size_t>> order;
    // many starts, or a jagged misfit: a look at all of them first
    constexpr std::size_t few = 3;
    const bool rough = from.size() > few || std::any_of(candidate.forms.begin(), candidate.forms.end(),
                                                        [](const auto* f) { return f->rough; });
    for (std::size_t i = 0; i < from.size(); ++i)
        order.emplace_back(rough ? evaluate(cases, candidate, in_si(candidate, from[i], scales), omega).objective : 0,
                           i);
    std::stable_sort(order.begin(), order.end());
    if (rough && order.size() > 2) order.resize(2);
    LevelFit best;
    int evaluations = rough ? static_cast<int>(from.size()) : 0;
    for (const auto& [objective, i] : order) {
        auto fit = improve(cases, candidate, scales, from[i], omega, 25);
        evaluations += fit.evaluations;
        if (best.x.size() == 0 || fit.evaluation.objective < best.evaluation.objective) best = std::move(fit);
    }
    best.evaluations = evaluations;
    return best;
}

/// A candidate as it stands after screening: judged everywhere at the same parameters.
Attribution as_screened(const std::vector<Case>& cases, const Scales& scales, const Nominal& nominal,
                        const Candidate& candidate, const LevelFit& screened)
{
    Attribution a;
    a.candidate = candidate;
    a.screened = screened.evaluation.objective;
    for (std::size_t l = 0; l < levels.size(); ++l) {
        a.x[l] = screened.x;
        a.evaluation[l] = evaluate(cases, candidate, in_si(candidate, screened.x, scales), levels[l]);
    }
    a.evaluations = screened.evaluations + static_cast<int>(levels.size());
    a.information = screened.information;
    judge(a, nominal);
    return a;
}

/// Carries a screened candidate through all levels, fastest first.
void refine(const std::vector<Case>& cases, const Scales& scales, const Nominal& nominal, Attribution& a)
{
    const Attribution screened = a;
    for (std::size_t l = 0; l < levels.size(); ++l) {
        std::vector<Eigen::VectorXd> from{screened.x[l]};
        if (l > 0 && a.x[l - 1] != screened.x[l]) from.push_back(a.x[l - 1]);
        std::size_t start = 0;
        double least = infinity;
        for (std::size_t i = 0; i < from.size(); ++i)
            if (const double o = evaluate(cases, a.candidate, in_si(a.candidate, from[i], scales), levels[l]).objective;
                o < least)
                least = o, start = i;
        auto fit = improve(cases, a.candidate, scales, from[start], levels[l], 12);
        a.evaluations += fit.evaluations;
        a.x[l] = fit.x;
        a.evaluation[l] = fit.evaluation;
        if (l == 1 && fit.information.size()) a.information = fit.information;
    }
    judge(a, nominal);
}

/// The fastest level at which the nominal joint clearly fails: there a fit is least troubled by what stick-slip
/// amplifies.
double screening_level(const Nominal& nominal)
{
    for (std::size_t l = 0; l < levels.size(); ++l) {
        double excess = 0;
        for (const auto& m : nominal.evaluation[l].records) excess = std::max({excess, m.position - 1, m.effort - 1});
        if (excess > 0.3) return levels[l];
    }
    return levels.back();
}

bool better(const Attribution& a, const Attribution& b)
{
    return a.score < b.score;
}

bool two_mass_edit(const Candidate& c)
{
    for (const auto* e : c.effects)
        if (e->name == "compliance" || e->name == "backlash") return true;
    return false;
}

}  // namespace

double mean_log_misfit(const std::array<Evaluation, levels.size()>& evaluations)
{
    double sum = 0, n = 0;
    for (const auto& level : evaluations)
        for (const auto& m : level.records) sum += std::log(std::max(1.0, m.position)), n += 1;
    for (const auto& m : evaluations[0].records) sum += std::log(std::max(1.0, m.effort)), n += 1;
    return n > 0 ? sum / n : 0;
}

Nominal judge_nominal(const std::vector<Case>& cases)
{
    Nominal nominal;
    const Candidate none;
    for (std::size_t l = 0; l < levels.size(); ++l) nominal.evaluation[l] = evaluate(cases, none, {}, levels[l]);
    nominal.score = mean_log_misfit(nominal.evaluation);
    constexpr double slow = 12;  // rad/s
    for (const auto& m : evaluate(cases, none, {}, slow).records)
        nominal.worst = std::max({nominal.worst, m.position, m.effort});
    return nominal;
}

void judge(Attribution& a, const Nominal& nominal)
{
    a.score = mean_log_misfit(a.evaluation) + price_of_parameter * static_cast<double>(a.candidate.parameter_count());
    const auto excess = [](const Evaluation& e) {
        double sum = 0;
        for (const auto& m : e.records) sum += std::max(0.0, m.position - 1) + std::max(0.0, m.effort - 1);
        return sum;
    };
    const double before = excess(nominal.evaluation[1]), after = excess(a.evaluation[1]);
    a.explained = before > 0 ? 1 - after / before : 0;
    bool fast = true;
    std::size_t middle = 0;
    const auto& records = a.evaluation[0].records;
    for (std::size_t i = 0; i < records.size(); ++i) {
        fast = fast && records[i].position < 1.12 && records[i].effort < 1.12;
        middle += a.evaluation[1].records[i].position < 1.15;
    }
    a.accepted = fast && 3 * middle >= 2 * records.size() && a.explained > 0.8;
}

std::vector<Candidate> single_candidates(const std::vector<Case>& cases, const Audit& audit)
{
    std::vector<Candidate> all;
    const bool logged = cases[0].ticks.source == CommandSource::logged;
    for (const auto& e : effects()) {
        if (e.name == "quantisation") continue;  // the audit reads it off the grid
        const bool of_controller = e.name == "gain-k_p" || e.name == "gain-k_v" || e.name == "velocity-filter";
        if (of_controller && (logged || audit.possible)) continue;
        for (const auto& f : e.forms) {
            if (f.own > 0 && cases.size() < 2) continue;
            Candidate c{{&e}, {&f}, cases.size()};
            if (c.applies(cases[0].joint)) all.push_back(c);
        }
    }
    return all;
}

std::vector<Attribution> fit_singles(const std::vector<Case>& cases, const Scales& scales, const Nominal& nominal,
                                     const std::vector<Candidate>& candidates, const ParallelFor& parallel)
{
    const double omega = screening_level(nominal);
    std::vector<Attribution> best;
    const auto screen = [&](const std::vector<Candidate>& some) {
        std::vector<Attribution> forms(some.size());
        parallel(some.size(), [&](std::size_t i) {
            const auto from = starts(cases, scales, some[i], {}, {});
            if (from.empty()) return;
            forms[i] = as_screened(cases, scales, nominal, some[i], best_of(cases, scales, some[i], from, omega));
        });
        for (auto& f : forms) {
            if (f.x[0].size() == 0) continue;
            const auto same = std::find_if(best.begin(), best.end(),
                                           [&](const auto& b) { return b.candidate.effects == f.candidate.effects; });
            if (same == best.end())
                best.push_back(std::move(f));
            else if (better(f, *same))
                *same = std::move(f);
        }
        std::stable_sort(best.begin(), best.end(), better);
    };
    const auto refine_best = [&] {
        const std::size_t n = std::min(refined_singles, best.size());
        parallel(n, [&](std::size_t i) {
            if (!best[i].refined) refine(cases, scales, nominal, best[i]);
            best[i].refined = true;
        });
        std::stable_sort(best.begin(), best.end(), better);
    };
    std::vector<Candidate> simple, divided;
    for (const auto& c : candidates) (two_mass_edit(c) ? divided : simple).push_back(c);
    screen(simple);
    refine_best();
    if (!best.empty() && best[0].accepted) {
        // two masses cost ten times as much: only those that could be mistaken for the winner
        const auto& mistaken = best[0].candidate.effects[0]->confusable;
        std::erase_if(divided, [&](const Candidate& c) {
            return std::find(mistaken.begin(), mistaken.end(), c.effects[0]->name) == mistaken.end();
        });
    }
    if (!divided.empty()) {
        screen(divided);
        refine_best();
    }
    return best;
}

std::vector<Attribution> fit_pairs(const std::vector<Case>& cases, const Scales& scales, const Nominal& nominal,
                                   const std::vector<Attribution>& singles, std::size_t partners,
                                   const ParallelFor& parallel)
{
    const double omega = screening_level(nominal);
    struct Task {
        const Attribution *first, *second;
    };
    std::vector<Task> tasks;
    for (std::size_t i = 0; i < std::min(partners, singles.size()); ++i)
        for (std::size_t j = i + 1; j < singles.size(); ++j) {
            if (two_mass_edit(singles[i].candidate) && two_mass_edit(singles[j].candidate)) continue;
            // divided masses cost ten times as much: only the best single looks for one
            if (i > 0 && (two_mass_edit(singles[i].candidate) || two_mass_edit(singles[j].candidate))) continue;
            tasks.push_back({&singles[i], &singles[j]});
        }
    std::vector<Attribution> pairs(tasks.size());
    parallel(tasks.size(), [&](std::size_t i) {
        const auto &a = *tasks[i].first, &b = *tasks[i].second;
        // catalogue order: edits that change the model of the joint come last
        const bool swap = a.candidate.effects[0] > b.candidate.effects[0];
        const auto& first = swap ? b : a;
        const auto& second = swap ? a : b;
        Candidate both{{first.candidate.effects[0], second.candidate.effects[0]},
                       {first.candidate.forms[0], second.candidate.forms[0]},
                       cases.size()};
        std::vector<Eigen::VectorXd> from;
        const auto join = [&](const Eigen::VectorXd& p, const Eigen::VectorXd& q) {
            Eigen::VectorXd x(p.size() + q.size());
            x << p, q;
            from.push_back(x);
        };
        join(first.x[0], second.x[0]);
        // the second of the two, started afresh on what the better one leaves
        const std::vector<double> held = in_si(a.candidate, a.x[0], scales);
        const auto fresh = starts(cases, scales, b.candidate, a.candidate, held);
        double least = infinity;
        Eigen::VectorXd chosen;
        for (const auto& x : fresh) {
            Eigen::VectorXd joint(first.x[0].size() + second.x[0].size());
            if (swap)
                joint << x, a.x[0];
            else
                joint << a.x[0], x;
            const double objective = evaluate(cases, both, in_si(both, joint, scales), omega).objective;
            if (objective < least) least = objective, chosen = joint;
        }
        if (chosen.size()) from.push_back(chosen);
        pairs[i] = as_screened(cases, scales, nominal, both, best_of(cases, scales, both, from, omega));
    });
    std::stable_sort(pairs.begin(), pairs.end(), better);
    const std::size_t n = std::min(refined_pairs, pairs.size());
    parallel(n, [&](std::size_t i) {
        refine(cases, scales, nominal, pairs[i]);
        pairs[i].refined = true;
    });
    std::stable_sort(pairs.begin(), pairs.end(), better);
    return pairs;
}

}  // namespace stickslip::gap
