// What fits leave, against the noise that a joint of the kind would leave itself.
#include "analysis/diagnosis/verdict/decide.h"

#include "analysis/diagnosis/policy/ladder.h"
#include "analysis/diagnosis/policy/page_and_plan.h"
#include "analysis/diagnosis/policy/search.h"
#include "analysis/diagnosis/policy/verdict.h"
#include "analysis/diagnosis/search/search.h"
#include "analysis/diagnosis/verdict/quality.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <string_view>

namespace stickslip::gap {
namespace {

constexpr int runs = 3;

/// Best score first. Of the leading ones that explain to within noise, within the margin, those with plausible numbers,
/// and of these the likeliest: their scores are those of the floor, and tell nothing.
void put_likeliest_first(std::vector<Attribution>& ranked)
{
    std::stable_sort(ranked.begin(), ranked.end(), better);
    const auto end = std::find_if(ranked.begin(), ranked.end(), [&](const auto& a) {
        return !a.accepted || !a.refined || a.score > ranked[0].score + policy::margin_of_score;
    });
    const auto priced = [](const Attribution& a) {
        return a.evidence + policy::price_of_parameter * static_cast<double>(a.candidate.parameter_count());
    };
    std::stable_sort(ranked.begin(), end, [&](const auto& a, const auto& b) {
        return std::pair(!plausible_numbers(a), priced(a)) < std::pair(!plausible_numbers(b), priced(b));
    });
}

double worst_at(const Attribution& a, std::size_t level)
{
    double worst = 0;
    for (const auto& m : a.evaluation[level].records) worst = std::max({worst, m.position, m.effort});
    return worst;
}

}  // namespace

bool two_free_shapes(const Attribution& a)
{
    constexpr std::array<std::string_view, 5> shapes{"gravity", "cogging", "sensor-offset",
                                                     "position-dependent-friction", "periodic-disturbance"};
    std::size_t n = 0;
    for (const auto* e : a.candidate.effects)
        n += static_cast<std::size_t>(std::count(shapes.begin(), shapes.end(), e->name));
    return n > 1;
}

bool at_floor(const Fit& fit, const Attribution& a)
{
    const auto& [cases, scales, nominal, parallel] = fit;
    if (a.candidate.effects.empty() &&
        (nominal.worst <= 1 + policy::slack_of_floor || closed_loop_at_floor(cases, {}, {}, parallel)))
        return true;
    const auto si = a.candidate.effects.empty() ? std::vector<double>{} : in_si(a.candidate, a.x[1], scales);
    if (!a.candidate.effects.empty() && a.explained > policy::mostly_explained &&
        closed_loop_at_floor(cases, a.candidate, si, parallel))
        return true;
    if (worst_at(a, 0) > policy::hopeless) return false;
    return within(spread_of(cases, a.candidate, si, runs, parallel), a.evaluation, levels.size());
}

double explained_beyond(const NoiseSpread& own, const Evaluation& middle, const Nominal& nominal)
{
    constexpr std::size_t level = 1;
    double before = 0, after = 0;
    for (std::size_t i = 0; i < middle.records.size(); ++i) {
        const auto &was = nominal.evaluation[level].records[i], &is = middle.records[i], &noise = own.mean[level][i];
        before += std::max(0.0, was.position - 1) + std::max(0.0, was.effort - 1);
        after += std::max(0.0, is.position - std::max(1.0, noise.position)) +
                 std::max(0.0, is.effort - std::max(1.0, noise.effort));
    }
    return before > 0 ? 1 - after / before : 0;
}

bool bends_only(const Candidate& candidate, const Eigen::VectorXd& x, const Scales& scales)
{
    const auto si = in_si(candidate, x, scales);
    for (std::size_t i = 0; i < si.size(); ++i) {
        const FrequencyGrid grid = candidate.parameter(i).grid;
        if (grid == FrequencyGrid::none) continue;
        const double seen = grid == FrequencyGrid::time ? si[i] * scales.duration
                                                        : si[i] / unit_of(candidate.parameter(i).scale, scales);
        if (seen < policy::turned_back * 2 * std::numbers::pi) return true;
    }
    return false;
}

void confirm(const Fit& fit, std::vector<Attribution>& ranked)
{
    constexpr std::size_t few = 2;
    const auto& [cases, scales, nominal, parallel] = fit;
    put_likeliest_first(ranked);
    for (std::size_t i = 0; i < std::min(few, ranked.size()); ++i) {
        Attribution& a = ranked[i];
        if (a.accepted && two_free_shapes(a) && bends_only(a.candidate, a.x[1], scales)) {
            a.accepted = false;
            continue;
        }
        if (!a.refined || (a.accepted && a.score < policy::clear_score)) continue;
        const auto si = in_si(a.candidate, a.x[1], scales);
        if (two_free_shapes(a)) {
            a.accepted = !bends_only(a.candidate, a.x[1], scales) &&
                         within(spread_of(cases, a.candidate, si, runs, parallel), a.evaluation, levels.size());
            continue;
        }
        a.accepted = at_floor(fit, a);
        if (!a.accepted && a.explained > policy::nameable)
            a.explained = explained_beyond(spread_of(cases, a.candidate, si, runs, parallel), a.evaluation[1], nominal);
    }
    put_likeliest_first(ranked);
}

bool could_have_shown(const Fit& fit)
{
    const auto& cases = fit.cases;
    std::vector<Candidate> all;
    for (const auto& e : effects())
        for (const auto& f : e.forms) {
            Candidate c{{&e}, {&f}, cases.size()};
            if (c.applies(cases[0].joint) && !e.of_transmission && !e.read_off) all.push_back(c);
        }
    std::vector<double> shown(all.size(), 0);
    fit.parallel(all.size(), [&](std::size_t i) {
        std::vector<double> usual;
        for (std::size_t p = 0; p < all[i].parameter_count(); ++p) usual.push_back(all[i].parameter(p).prior);
        if (all[i].effects[0]->name == "inertia" || all[i].effects[0]->name == "effort-gain") usual[0] = 1 + usual[0];
        const auto si = in_si(all[i], to_fit(all[i], usual), fit.scales);
        for (const auto& m : evaluate(cases, all[i], si, levels.back()).records)
            shown[i] = std::max({shown[i], m.position, m.effort});
    });
    return *std::max_element(shown.begin(), shown.end()) > policy::shown * policy::shown;
}

}  // namespace stickslip::gap
