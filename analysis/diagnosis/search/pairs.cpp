// In one file: one search for pairs, from first looks to finalists.
#include "analysis/diagnosis/effects/catalogue.h"
#include "analysis/diagnosis/fit/excerpt.h"
#include "analysis/diagnosis/fit/problem.h"
#include "analysis/diagnosis/fit/seeds.h"
#include "analysis/diagnosis/policy/search.h"
#include "analysis/diagnosis/search/search.h"

#include <algorithm>
#include <array>
#include <map>

namespace stickslip::gap {
namespace {

constexpr std::size_t refined_pairs = 6, polished_pairs = 2;
constexpr int first_look = 3, first_effort = 8;                      // iterations; evaluations a parameter
constexpr std::size_t simple_finalists = 16, divided_finalists = 6;  // that go on from a first look

struct Pair {
    const Attribution *a, *b;  ///< the better single first
    Candidate both;
    LevelFit fit;
    double omega;  ///< level of the first look
};

/// Both effects in the order of the catalogue: edits that change the model of the joint come last.
Pair pair_of(const Attribution& a, const Attribution& b, std::size_t records, double omega)
{
    const bool swap = a.candidate.effects[0] > b.candidate.effects[0];
    const auto &first = (swap ? b : a).candidate, &second = (swap ? a : b).candidate;
    return {&a, &b, {{first.effects[0], second.effects[0]}, {first.forms[0], second.forms[0]}, records}, {}, omega};
}

Eigen::VectorXd join(const Pair& p, const Eigen::VectorXd& of_a, const Eigen::VectorXd& of_b)
{
    const bool swap = p.both.effects[0] != p.a->candidate.effects[0];
    Eigen::VectorXd x(of_a.size() + of_b.size());
    x << (swap ? of_b : of_a), (swap ? of_a : of_b);
    return x;
}

/// A change from nothing, or a factor: a part of it is less of the effect.
bool has_parts(const EffectParameter& p)
{
    return !p.logarithmic || p.scale == Scale::one;
}

/// A first look: from where both came to alone, from the second started afresh on what the first leaves, and, beside
/// backlash or a limit, from a part of a second that has one number. Backlash and limits are searched while the first
/// keeps its values.
void look_at(Pair& p, const std::vector<Case>& brief, const Scales& scales)
{
    using Start = std::pair<double, Eigen::VectorXd>;
    std::vector<Start> from;
    const FitProblem problem{brief, p.both, scales, p.omega};
    const auto start = [&](const Eigen::VectorXd& of_b) -> Start {
        const Eigen::VectorXd x = join(p, p.a->x[0], of_b);
        return {problem.at(x).objective, x};
    };
    const auto nearer = [](const Start& a, const Start& b) { return a.first < b.first; };
    const auto held = in_si(p.a->candidate, p.a->x[0], scales);
    const Eigen::VectorXd& alone = p.b->x[0];
    for (const auto& x : starts(brief, scales, p.b->candidate, p.a->candidate, held)) from.push_back(start(x));
    std::stable_sort(from.begin(), from.end(), nearer);
    const bool second_jagged = jagged(p.b->candidate);
    from.resize(std::min<std::size_t>(second_jagged ? 2 : 1, from.size()));
    if (jagged(p.a->candidate) && alone.size() == 1 && has_parts(p.b->candidate.parameter(0))) {
        // alone, the second stood in for the first, too: beside it there is less of it, and the slope to that is hidden
        const std::array less{start(0.25 * alone), start(0.5 * alone), start(0.75 * alone)};
        from.push_back(*std::min_element(less.begin(), less.end(), nearer));
    }
    from.push_back(start(alone));
    Kept kept;
    for (std::size_t i = 0; i < p.both.effects.size(); ++i)
        kept.resize(kept.size() + p.both.count_of(*p.both.forms[i]), p.both.effects[i] == p.a->candidate.effects[0]);
    int evaluations = 0;
    for (const auto& [objective, x] : from) {
        LevelFit fit;
        if (second_jagged)
            fit = search_rough(problem, x, 2 * first_effort * static_cast<int>(p.b->candidate.parameter_count()), 0.3,
                               kept);
        else
            fit = descend(problem, x, first_look, jagged(p.a->candidate) ? kept : Kept{});
        evaluations += fit.evaluations;
        if (p.fit.x.size() == 0 || fit.evaluation.objective < p.fit.evaluation.objective) p.fit = fit;
    }
    p.fit.evaluations = evaluations + static_cast<int>(from.size());
}

/// The best singles in their other forms: which form one has may show only beside its partner. Where the best is
/// backlash or a spring that holds for everything in the mechanism: alone, each inertia stands in for the other.
std::vector<Attribution> other_forms(const Fit& fit, const std::vector<Attribution>& singles, std::size_t partners,
                                     const std::vector<Case>& brief, double omega)
{
    const std::size_t records = fit.cases.size();
    std::vector<Attribution> others;
    const bool effort = std::ranges::any_of(brief, [](const Case& c) { return c.ticks.has_effort; });
    for (std::size_t i = 0; i < singles.size(); ++i) {
        const Candidate& best = singles[i].candidate;
        const bool beside_backlash = two_mass_edit(singles[0].candidate) && best.effects[0]->stage == Stage::mechanism;
        if (two_mass_edit(best) || (i >= partners && !beside_backlash)) continue;
        for (const auto& form : best.effects[0]->forms) {
            Attribution other;
            other.candidate = {best.effects, {&form}, records};
            const bool own = form.own > 0 && records < 2;
            if (form.effort_alone && !effort) continue;
            if (&form != best.forms[0] && !own && other.candidate.applies(brief[0].joint)) others.push_back(other);
        }
    }
    fit.parallel(others.size(), [&](std::size_t i) {
        const auto from = starts(brief, fit.scales, others[i].candidate, {}, {});
        if (!from.empty()) others[i].x.fill(best_of({brief, others[i].candidate, fit.scales, omega}, from).x);
    });
    std::erase_if(others, [](const Attribution& a) { return a.x[0].size() == 0; });
    return others;
}

/// Pairs of singles: looked at on excerpts, the likely ones improved, the best refined on the whole records.
class PairSearch {
  public:
    PairSearch(const Fit& fit, const std::vector<Attribution>& singles, std::size_t partners)
        : fit_(fit),
          singles_(singles),
          partners_(partners),
          omega_(screening_level(fit.nominal)),
          brief_(excerpts(fit.cases, omega_, brief_ticks, coarse)),
          whole_(uncut(fit.cases, coarse)),
          forms_(other_forms(fit, singles, partners, brief_, omega_))
    {
    }

    std::vector<Attribution> run();

  private:
    const std::vector<Case>& part(const Pair& p) const { return needs_history(p.both) ? whole_ : brief_; }
    void add(std::vector<Pair>& to, const Attribution& a, const Attribution& b) const;
    void add_other_forms(std::vector<Pair>& simple, std::vector<Pair>& divided) const;
    void add_partners(std::vector<Pair>& simple, std::vector<Pair>& divided) const;
    std::vector<Pair> beside_members_of(const Attribution& pair) const;
    Attribution improved(Pair& p) const;
    void screen(std::vector<Pair>& some, std::size_t finalists);

    const Fit& fit_;
    const std::vector<Attribution>& singles_;
    std::size_t partners_;
    double omega_;
    std::vector<Case> brief_, whole_;
    std::vector<Attribution> forms_;
    std::vector<Attribution> pairs_;  ///< what the screening found, best first
};

void PairSearch::add(std::vector<Pair>& to, const Attribution& a, const Attribution& b) const
{
    to.push_back(pair_of(a, b, fit_.cases.size(), omega_));
    // with known masses the slope towards the right backlash is longer over a longer horizon, while what sticks and
    // slips beside it shows over a short one
    if (needs_history(to.back().both) && omega_ > levels[1]) to.push_back(pair_of(a, b, fit_.cases.size(), levels[1]));
}

void PairSearch::add_other_forms(std::vector<Pair>& simple, std::vector<Pair>& divided) const
{
    for (const auto& form : forms_) {
        bool behind = true;  // of the effect in its best form
        for (const auto& single : singles_) {
            if (single.candidate.effects == form.candidate.effects) {
                behind = false;
                continue;
            }
            const bool best = form.candidate.effects == singles_[0].candidate.effects;
            if (two_mass_edit(single.candidate))
                add(divided, behind ? single : form, behind ? form : single);
            else if (best)
                add(simple, form, single);
        }
    }
}

void PairSearch::add_partners(std::vector<Pair>& simple, std::vector<Pair>& divided) const
{
    for (std::size_t i = 0; i < std::min(partners_, singles_.size()); ++i)
        for (std::size_t j = i + 1; j < singles_.size(); ++j) {
            const bool a = two_mass_edit(singles_[i].candidate), b = two_mass_edit(singles_[j].candidate);
            // divided masses cost ten times as much: they look for a partner only where they are best
            if ((a && b) || (i > 0 && divides_mass(singles_[i].candidate))) continue;
            add(a || b ? divided : simple, singles_[i], singles_[j]);
        }
}

/// Alone, an effect that another one hides may rank low; the best pair shows that it is there.
std::vector<Pair> PairSearch::beside_members_of(const Attribution& pair) const
{
    std::vector<Pair> further;
    for (std::size_t i = partners_; i < singles_.size(); ++i) {
        if (std::ranges::count(pair.candidate.effects, singles_[i].candidate.effects[0]) == 0) continue;
        for (std::size_t j = partners_; j < singles_.size(); ++j)
            if (j != i && !two_mass_edit(singles_[i].candidate) && !two_mass_edit(singles_[j].candidate))
                add(further, singles_[std::min(i, j)], singles_[std::max(i, j)]);
    }
    return further;
}

Attribution PairSearch::improved(Pair& p) const
{
    const int looked = p.fit.evaluations;
    p.fit = improve({part(p), p.both, fit_.scales, p.omega}, p.fit.x, full_effort);
    p.fit.evaluations += looked;
    Attribution found = as_screened(fit_, p.both, p.fit);
    if (!jagged(p.both)) return found;
    // excerpts may mislead a backlash; what both came to alone, refined on more, may be nearer
    for (std::size_t l = 0; l < levels.size(); ++l) {
        if (l > 0 && p.a->x[l] == p.a->x[l - 1] && p.b->x[l] == p.b->x[l - 1]) continue;
        LevelFit alone;
        alone.x = join(p, p.a->x[l], p.b->x[l]);
        auto as_alone = as_screened(fit_, p.both, alone);
        as_alone.evaluations += found.evaluations;
        if (better(as_alone, found)) found = std::move(as_alone);
    }
    return found;
}

void PairSearch::screen(std::vector<Pair>& some, std::size_t finalists)
{
    fit_.parallel(some.size(), [&](std::size_t i) { look_at(some[i], part(some[i]), fit_.scales); });
    std::stable_sort(some.begin(), some.end(), [](const Pair& a, const Pair& b) {
        return a.fit.evaluation.objective < b.fit.evaluation.objective;
    });
    std::map<std::pair<double, bool>, std::size_t> taken;  // objectives compare on one level of one kind of data
    std::erase_if(some, [&](const Pair& p) { return ++taken[{p.omega, needs_history(p.both)}] > finalists; });
    std::vector<Attribution> found(some.size());
    fit_.parallel(some.size(), [&](std::size_t i) { found[i] = improved(some[i]); });
    pairs_.insert(pairs_.end(), found.begin(), found.end());
    std::stable_sort(pairs_.begin(), pairs_.end(), better);
    refine_best(fit_, pairs_, refined_pairs);
}

std::vector<Attribution> PairSearch::run()
{
    std::vector<Pair> simple, divided;
    add_other_forms(simple, divided);
    add_partners(simple, divided);
    screen(simple, simple_finalists);
    if (!pairs_.empty()) {
        auto further = beside_members_of(pairs_[0]);
        screen(further, simple_finalists);
    }
    if (!divided.empty() && (pairs_.empty() || !pairs_[0].accepted)) {
        screen(divided, divided_finalists);
        if (pairs_[0].score > policy::clear_score) polish_best(fit_, pairs_, polished_pairs);
    }
    // of every pair its best form: the others are no rivals
    std::vector<Attribution> best;
    for (auto& p : pairs_)
        if (std::none_of(best.begin(), best.end(),
                         [&](const auto& b) { return b.candidate.effects == p.candidate.effects; }))
            best.push_back(std::move(p));
    return best;
}

}  // namespace

std::vector<Attribution> fit_pairs(const Fit& fit, const std::vector<Attribution>& singles, std::size_t partners)
{
    return PairSearch(fit, singles, partners).run();
}

}  // namespace stickslip::gap
