#include "analysis/gap/attribute.h"

#include "analysis/gap/seeds.h"

#include <algorithm>
#include <cmath>

namespace stickslip::gap {
namespace {

constexpr int iterations = 12;

/// Descends from every start at the fastest level, then carries the best on to the slower ones.
Attribution fit(const std::vector<Case>& cases, const Scales& scales, const Nominal& nominal,
                const Candidate& candidate, const std::vector<Eigen::VectorXd>& from, int iterations_)
{
    Attribution a;
    a.candidate = candidate;
    bool rough = false;
    for (const auto* f : candidate.forms) rough = rough || f->rough;
    std::vector<LevelFit> kept;
    if (rough) {
        // try all starts, go on from the two best
        std::vector<std::pair<double, std::size_t>> order;
        for (std::size_t i = 0; i < from.size(); ++i) {
            order.emplace_back(evaluate(cases, candidate, in_si(candidate, from[i], scales), levels[0]).objective, i);
            ++a.evaluations;
        }
        std::sort(order.begin(), order.end());
        for (std::size_t i = 0; i < std::min<std::size_t>(2, order.size()); ++i) {
            const int budget = 25 * static_cast<int>(candidate.parameter_count());
            kept.push_back(search_rough(cases, candidate, scales, from[order[i].second], levels[0], budget));
        }
    } else {
        for (const auto& start : from) kept.push_back(descend(cases, candidate, scales, start, levels[0], iterations_));
    }
    for (const auto& k : kept) a.evaluations += k.evaluations;
    std::sort(kept.begin(), kept.end(),
              [](const auto& p, const auto& q) { return p.evaluation.objective < q.evaluation.objective; });
    if (kept.size() > 2) kept.resize(2);
    for (std::size_t l = 0; l < levels.size(); ++l) {
        if (l > 0) {
            for (auto& k : kept) {
                k = rough ? search_rough(cases, candidate, scales, k.x, levels[l],
                                         12 * static_cast<int>(candidate.parameter_count()))
                          : descend(cases, candidate, scales, k.x, levels[l], iterations_);
                a.evaluations += k.evaluations;
            }
        }
        const auto best = std::min_element(kept.begin(), kept.end(), [](const auto& p, const auto& q) {
            return p.evaluation.objective < q.evaluation.objective;
        });
        a.x[l] = best->x;
        a.evaluation[l] = best->evaluation;
        if (l == 1) a.information = best->information;
    }
    judge(a, nominal);
    return a;
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
            Candidate c{{&e}, {&f}};
            if (c.applies(cases[0].joint)) all.push_back(c);
        }
    }
    return all;
}

std::vector<Attribution> fit_singles(const std::vector<Case>& cases, const Scales& scales, const Nominal& nominal,
                                     const std::vector<Candidate>& candidates, const ParallelFor& parallel)
{
    std::vector<Attribution> forms(candidates.size());
    parallel(candidates.size(), [&](std::size_t i) {
        const auto from = starts(cases, scales, *candidates[i].forms[0], {}, {});
        forms[i] = fit(cases, scales, nominal, candidates[i], from, iterations);
    });
    std::vector<Attribution> best;
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
    return best;
}

std::vector<Attribution> fit_pairs(const std::vector<Case>& cases, const Scales& scales, const Nominal& nominal,
                                   const std::vector<Attribution>& singles, std::size_t partners,
                                   const ParallelFor& parallel)
{
    struct Task {
        const Attribution *first, *second;
    };
    std::vector<Task> tasks;
    for (std::size_t i = 0; i < std::min(partners, singles.size()); ++i)
        for (std::size_t j = i + 1; j < singles.size(); ++j) {
            if (two_mass_edit(singles[i].candidate) && two_mass_edit(singles[j].candidate)) continue;
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
                       {first.candidate.forms[0], second.candidate.forms[0]}};
        std::vector<Eigen::VectorXd> from;
        const auto join = [&](const Eigen::VectorXd& p, const Eigen::VectorXd& q) {
            Eigen::VectorXd x(p.size() + q.size());
            x << p, q;
            from.push_back(x);
        };
        join(first.x[0], second.x[0]);
        // the second of the two, started afresh on what the better one leaves
        const std::vector<double> held = in_si(a.candidate, a.x[0], scales);
        const auto fresh = starts(cases, scales, *b.candidate.forms[0], a.candidate, held);
        double least = infinity;
        Eigen::VectorXd chosen;
        for (const auto& x : fresh) {
            Eigen::VectorXd joint(first.x[0].size() + second.x[0].size());
            if (swap)
                joint << x, a.x[0];
            else
                joint << a.x[0], x;
            const double objective = evaluate(cases, both, in_si(both, joint, scales), levels[0]).objective;
            if (objective < least) least = objective, chosen = joint;
        }
        if (chosen.size()) from.push_back(chosen);
        pairs[i] = fit(cases, scales, nominal, both, from, iterations);
    });
    std::stable_sort(pairs.begin(), pairs.end(), better);
    return pairs;
}

}  // namespace stickslip::gap
