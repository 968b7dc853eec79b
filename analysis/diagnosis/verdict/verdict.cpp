// In one file: the decision between causes and the checks that it relies on, in their order.
#include "analysis/diagnosis/verdict/verdict.h"

#include "analysis/diagnosis/fit/moment.h"
#include "analysis/diagnosis/ladder/plausible.h"
#include "analysis/diagnosis/policy/policy.h"
#include "analysis/diagnosis/search/search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

namespace stickslip::gap {
namespace {

constexpr int runs = 3;

/// Two free functions of position, or of time, are a short Fourier series: together they come near any smooth force.
bool flexible(const Attribution& a)
{
    constexpr std::array<std::string_view, 5> shapes{"gravity", "cogging", "sensor-offset",
                                                     "position-dependent-friction", "periodic-disturbance"};
    std::size_t n = 0;
    for (const auto* e : a.candidate.effects)
        n += static_cast<std::size_t>(std::count(shapes.begin(), shapes.end(), e->name));
    return n > 1;
}

/// Whether a partner beside backlash or a spring takes most of what that one leaves alone. The contact of real backlash
/// is none of the ones that can be simulated, so a rest remains of both.
bool completes(const Attribution& pair, const Attribution& single)
{
    const bool holds = std::ranges::count(pair.candidate.effects, single.candidate.effects[0]) > 0;
    return holds && two_mass_edit(single.candidate) && pair.explained > policy::completed && !flexible(pair) &&
           1 - pair.explained < (1 - policy::taken_by_partner) * (1 - single.explained);
}

/// Best score first. Of the leading ones that explain to within noise, within the margin, the likeliest: their scores
/// are those of the floor, and tell nothing.
void put_likeliest_first(std::vector<Attribution>& ranked)
{
    std::stable_sort(ranked.begin(), ranked.end(), better);
    const auto end = std::find_if(ranked.begin(), ranked.end(), [&](const auto& a) {
        return !a.accepted || !a.refined || a.score > ranked[0].score + policy::margin_of_score;
    });
    const auto priced = [](const Attribution& a) {
        return a.evidence + policy::price_of_parameter * static_cast<double>(a.candidate.parameter_count());
    };
    std::stable_sort(ranked.begin(), end, [&](const auto& a, const auto& b) { return priced(a) < priced(b); });
}

double worst_at(const Attribution& a, std::size_t level)
{
    double worst = 0;
    for (const auto& m : a.evaluation[level].records) worst = std::max({worst, m.position, m.effort});
    return worst;
}

/// How much of a rival's misfit may be a lost step. Where anything but noise is left, all of it counts.
double by_chance(const Attribution& winner, const Attribution& rival)
{
    return winner.accepted && rival.accepted ? hangs_on_a_moment(winner.evaluation, rival.evaluation, exact_square) : 0;
}

/// Parameters that the rival has and does not need where the winner does as well. None where the rival makes the
/// winner's very motion without them: then they tell nothing.
double needless_parameters(const Attribution& winner, const Attribution& rival)
{
    const Candidate &one = winner.candidate, &other = rival.candidate;
    const auto parameters = [](const Candidate& c) { return static_cast<double>(c.parameter_count()); };
    const auto only_in = [](const Candidate& c, const Candidate& not_in) {
        std::vector<std::size_t> members;
        for (std::size_t i = 0; i < c.effects.size(); ++i)
            if (std::ranges::count(not_in.effects, c.effects[i]) == 0) members.push_back(i);
        return members;
    };
    const auto own = only_in(one, other), others = only_in(other, one);
    if (own.size() == 1 && others.size() == 1 &&
        std::ranges::count(other.forms[others[0]]->same_motion, one.effects[own[0]]->name) > 0)
        return 0;
    return std::max(0.0, parameters(other) - parameters(one));
}

/// Of a rival against the winner: the likelihood of their innovations over so many rows, less for needless parameters.
double odds_against(const Attribution& winner, const Attribution& rival, double rows)
{
    const double width = std::max(2 * policy::rows_per_reading / rows, policy::relative_temperature * winner.score);
    const double worse = rival.evidence - winner.evidence - by_chance(winner, rival);
    return std::exp(-std::max(0.0, worse) / width) *
           std::pow(policy::needless_parameter, -needless_parameters(winner, rival));
}

}  // namespace

bool at_floor(const std::vector<Case>& cases, const Attribution& a, const Nominal& nominal, const Scales& scales,
              const ParallelFor& parallel)
{
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

void confirm(const std::vector<Case>& cases, std::vector<Attribution>& ranked, const Nominal& nominal,
             const Scales& scales, const ParallelFor& parallel)
{
    constexpr std::size_t few = 2;
    put_likeliest_first(ranked);
    for (std::size_t i = 0; i < std::min(few, ranked.size()); ++i) {
        Attribution& a = ranked[i];
        if (a.accepted && flexible(a) && bends_only(a.candidate, a.x[1], scales)) {
            a.accepted = false;
            continue;
        }
        if (!a.refined || (a.accepted && a.score < clear_score)) continue;
        const auto si = in_si(a.candidate, a.x[1], scales);
        if (flexible(a)) {
            a.accepted = !bends_only(a.candidate, a.x[1], scales) &&
                         within(spread_of(cases, a.candidate, si, runs, parallel), a.evaluation, levels.size());
            continue;
        }
        a.accepted = at_floor(cases, a, nominal, scales, parallel);
        if (!a.accepted && a.explained > policy::nameable)
            a.explained = explained_beyond(spread_of(cases, a.candidate, si, runs, parallel), a.evaluation[1], nominal);
    }
    put_likeliest_first(ranked);
}

Decision decide(const std::vector<Attribution>& singles, const std::vector<Attribution>& pairs, double rows)
{
    Decision d;
    const std::vector<Attribution>* from = nullptr;
    const bool single = !singles.empty() && (singles[0].accepted || pairs.empty());
    const Attribution* best_single = singles.empty() ? nullptr : &singles[0];
    const Attribution* best_pair = pairs.empty() ? nullptr : &pairs[0];
    if (best_single) d.best_explained = best_single->explained;
    // two free shapes that are not accepted come near anything: that explains nothing
    if (best_pair && (best_pair->accepted || !flexible(*best_pair)))
        d.best_explained = std::max(d.best_explained, best_pair->explained);
    if (single && best_single->accepted) {
        d.winner = best_single;
        from = &singles;
    } else if (best_pair &&
               (best_pair->accepted || (best_pair->explained > policy::explained_pair && !flexible(*best_pair)) ||
                (best_single && completes(*best_pair, *best_single)))) {
        // a second effect must earn its place: else the first alone is the answer with a rest
        const bool all_but = best_single && two_mass_edit(best_single->candidate) &&
                             best_single->explained > policy::explained_by_backlash;
        const auto worth = best_pair->accepted && !all_but ? policy::worth_a_partner : policy::worth_a_doubted_partner;
        const bool alone =
            best_single &&
            best_single->explained > (best_pair->accepted ? policy::explained_single : policy::mostly_explained) &&
            best_single->score < best_pair->score + worth;
        d.winner = alone ? best_single : best_pair;
        from = alone ? &singles : &pairs;
    } else if (best_single &&
               best_single->explained >
                   (two_mass_edit(best_single->candidate) ? policy::nameable : policy::explained_single)) {
        d.winner = best_single;
        from = &singles;
    }
    d.named = d.winner != nullptr;
    if (d.named)
        for (const auto& rival : *from)
            if (&rival != d.winner && rival.refined &&
                odds_against(*d.winner, rival, rows) >= policy::odds_of_indistinguishable)
                d.ambiguous.push_back(&rival);
    return d;
}

std::vector<Ranked> rank(const std::vector<Attribution>& singles, const std::vector<Attribution>& pairs,
                         const Decision& decision, double rows)
{
    std::vector<Ranked> all;
    const bool pair_wins = decision.named && decision.winner->candidate.effects.size() > 1;
    for (const auto& s : singles) all.push_back({&s, 0});
    for (const auto& p : pairs)
        if (pair_wins || !decision.named) all.push_back({&p, 0});
    std::stable_sort(all.begin(), all.end(), [&](const Ranked& a, const Ranked& b) {
        const bool wa = a.attribution == decision.winner, wb = b.attribution == decision.winner;
        if (wa != wb) return wa;
        return a.attribution->score < b.attribution->score;
    });
    if (all.empty()) return all;
    const Attribution& first = *all.front().attribution;
    double sum = 0;
    for (auto& r : all) {
        r.probability = odds_against(first, *r.attribution, rows);
        sum += r.probability;
    }
    std::stable_sort(all.begin() + 1, all.end(),
                     [](const Ranked& a, const Ranked& b) { return a.probability > b.probability; });
    // what the best leaves unexplained is the chance that it is something else
    const double unexplained = std::clamp(1 - first.explained, 0.0, 1.0);
    const double else_ = !decision.named  ? 1 - policy::believed_unnamed
                         : first.accepted ? policy::doubt_of_accepted + 0.5 * unexplained
                                          : std::min(policy::most_doubt, policy::doubt + unexplained);
    for (auto& r : all) r.probability *= (1 - else_) / sum;
    return all;
}

Quality quality_of(const std::vector<Case>& cases, const Attribution& a, const Scales& scales)
{
    Quality q;
    const auto n = static_cast<Eigen::Index>(a.candidate.parameter_count());
    q.standard_error.assign(static_cast<std::size_t>(n), not_set);
    const auto si = in_si(a.candidate, a.x[1], scales);
    if (a.information.rows() == n && n > 0 && a.information.diagonal().maxCoeff() > 0) {
        // weights are one over the rows of a record: undo that, and scale with what is left
        const double per_record = rows_of(cases) / static_cast<double>(cases.size());
        double left = 0;
        for (const auto& m : a.evaluation[1].records) left = std::max(left, m.position);
        q.covariance = (a.information * per_record).completeOrthogonalDecomposition().pseudoInverse();
        q.covariance *= std::max(1.0, left);
        for (Eigen::Index i = 0; i < n; ++i) {
            // nothing depends on it, on a friction corrected to nothing, say: the others keep their errors
            if (!(a.information(i, i) > 0)) q.covariance(i, i) = infinity;
            const auto& p = a.candidate.parameter(static_cast<std::size_t>(i));
            const double error = std::sqrt(std::max(0.0, q.covariance(i, i)));
            // wider than its bounds: these records cannot distinguish it from another parameter
            const double widest = p.logarithmic ? std::log(p.high / p.low) : p.high - p.low;
            if (!(error < widest)) continue;
            q.standard_error[static_cast<std::size_t>(i)] =
                p.logarithmic ? error * si[static_cast<std::size_t>(i)] : error * unit_of(p.scale, scales);
        }
    }
    for (Eigen::Index i = 0; i < n; ++i) {
        const auto& p = a.candidate.parameter(static_cast<std::size_t>(i));
        const double value = p.logarithmic ? std::exp(a.x[1][i]) : a.x[1][i];
        if (at_bound(p, value) || (!p.logarithmic && p.prior > 0 &&
                                   std::abs(value) > policy::implausible_size * std::max(p.prior, policy::least_prior)))
            q.plausible = false;
    }
    // the pattern that the effect takes out of the residual, against the residual itself, second by second
    int acts = 0, found = 0;
    Innovation before, after;
    for (const auto& c : cases) {
        const Plant one = flatten(c.joint), two = flatten(edited(c.joint, a.candidate, si, c.number));
        predict(one, c.ticks, known_command(one, c.ticks), levels[1], before);
        predict(two, c.ticks, known_command(two, c.ticks), levels[1], after);
        const auto block = static_cast<std::size_t>(std::max(10.0, 1 / c.row_step));
        for (std::size_t b = 0; b + block <= c.ticks.size(); b += block) {
            double mm = 0, rr = 0, mr = 0;
            for (std::size_t k = b; k < b + block; ++k) {
                if (!c.ticks.logged[k]) continue;
                double r = before.position[k] / c.sigma, m = r - after.position[k] / c.sigma;
                if (c.effort_sigma > 0 && std::isfinite(before.effort[k])) {
                    const double er = before.effort[k] / c.effort_sigma, em = er - after.effort[k] / c.effort_sigma;
                    mm += em * em, rr += er * er, mr += em * er;
                }
                mm += m * m, rr += r * r, mr += m * r;
            }
            if (mm < policy::acting_square * static_cast<double>(block)) continue;  // does not act here
            ++acts;
            found += mr > policy::signature_correlation * std::sqrt(mm * rr);
        }
    }
    q.signature = acts > 0 ? 3 * found >= 2 * acts : a.explained > policy::mostly_explained;
    return q;
}

bool could_have_shown(const std::vector<Case>& cases, const Scales& scales, const ParallelFor& parallel)
{
    std::vector<Candidate> all;
    for (const auto& e : effects())
        for (const auto& f : e.forms) {
            Candidate c{{&e}, {&f}, cases.size()};
            if (c.applies(cases[0].joint) && e.name != "backlash" && e.name != "compliance" && e.name != "quantisation")
                all.push_back(c);
        }
    std::vector<double> shown(all.size(), 0);
    parallel(all.size(), [&](std::size_t i) {
        std::vector<double> usual;
        for (std::size_t p = 0; p < all[i].parameter_count(); ++p) usual.push_back(all[i].parameter(p).prior);
        if (all[i].effects[0]->name == "inertia" || all[i].effects[0]->name == "effort-gain") usual[0] = 1 + usual[0];
        const auto si = in_si(all[i], to_fit(all[i], usual), scales);
        for (const auto& m : evaluate(cases, all[i], si, levels.back()).records)
            shown[i] = std::max({shown[i], m.position, m.effort});
    });
    return *std::max_element(shown.begin(), shown.end()) > policy::shown * policy::shown;
}

}  // namespace stickslip::gap
