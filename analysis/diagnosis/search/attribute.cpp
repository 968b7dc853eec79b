#include "analysis/diagnosis/search/attribute.h"

#include "analysis/diagnosis/effects/catalogue.h"
#include "analysis/diagnosis/policy/ladder.h"
#include "analysis/diagnosis/policy/search.h"

#include <algorithm>
#include <cmath>

namespace stickslip::gap {

namespace {

double mean_log(const std::array<Evaluation, levels.size()>& evaluations, double least)
{
    double sum = 0, n = 0;
    for (const auto& level : evaluations)
        for (const auto& m : level.records) sum += std::log(std::max(least, m.position)), n += 1;
    for (const auto& m : evaluations[0].records) sum += std::log(std::max(least, m.effort)), n += 1;
    return n > 0 ? sum / n : 0;
}

}  // namespace

double mean_log_misfit(const std::array<Evaluation, levels.size()>& evaluations)
{
    return mean_log(evaluations, noise_square);
}

double mean_log_square(const std::array<Evaluation, levels.size()>& evaluations)
{
    return mean_log(evaluations, exact_square);
}

Nominal judge_nominal(const std::vector<Case>& cases)
{
    Nominal nominal;
    const Candidate none;
    for (std::size_t l = 0; l < levels.size(); ++l) nominal.evaluation[l] = evaluate(cases, none, {}, levels[l]);
    nominal.score = mean_log_misfit(nominal.evaluation);
    for (const auto& m : evaluate(cases, none, {}, slow_observer).records)
        nominal.worst = std::max({nominal.worst, m.position, m.effort});
    return nominal;
}

void judge(Attribution& a, const Nominal& nominal)
{
    a.score =
        mean_log_misfit(a.evaluation) + policy::price_of_parameter * static_cast<double>(a.candidate.parameter_count());
    a.evidence = mean_log_square(a.evaluation);
    const auto excess = [](const Evaluation& e) {
        double sum = 0;
        for (const auto& m : e.records) sum += std::max(0.0, m.position - 1) + std::max(0.0, m.effort - 1);
        return sum;
    };
    // noise as coarse as a grid hides a gap that only the longest horizon shows
    const std::size_t shown_at = excess(nominal.evaluation[1]) > 0 ? 1 : 2;
    const double before = excess(nominal.evaluation[shown_at]), after = excess(a.evaluation[shown_at]);
    a.explained = before > 0 ? 1 - after / before : 0;
    bool fast = true;
    std::size_t middle = 0;
    const auto& records = a.evaluation[0].records;
    for (std::size_t i = 0; i < records.size(); ++i) {
        fast = fast && records[i].position < policy::accepted_fast && records[i].effort < policy::accepted_fast;
        middle += a.evaluation[1].records[i].position < policy::accepted_middle;
    }
    const bool most = static_cast<double>(middle) >= policy::most_records * static_cast<double>(records.size());
    a.accepted = fast && most && a.explained > policy::accepted_part;
}

std::vector<Candidate> single_candidates(const std::vector<Case>& cases, const Audit& audit)
{
    std::vector<Candidate> all;
    // the commands of noisy rows are computed: then the controller shows in the motion alone
    const bool logged = cases[0].ticks.source == CommandSource::logged && !cases[0].ticks.noisy_rows;
    const bool behind_effort = cases[0].ticks.source == CommandSource::measured;
    const bool effort = std::ranges::any_of(cases, [](const Case& c) { return c.ticks.has_effort; });
    for (const auto& e : effects()) {
        if (e.read_off) continue;
        if (e.in_command && (logged || behind_effort || audit.possible)) continue;
        if (behind_effort && e.stage == Stage::actuator && !e.scales_reading) continue;  // it acts before the sensor
        if (e.name == "velocity-filter" && audit.filter_seen) continue;
        for (const auto& f : e.forms) {
            if (f.own > 0 && cases.size() < 2) continue;
            if (!effort && f.effort_alone) continue;
            Candidate c{{&e}, {&f}, cases.size()};
            if (c.applies(cases[0].joint)) all.push_back(c);
        }
    }
    return all;
}

}  // namespace stickslip::gap
