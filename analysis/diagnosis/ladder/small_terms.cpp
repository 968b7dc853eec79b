// The small terms that every machine has and no document: a ripple of the friction, a cogging, a drift. They are looked
// for in what the nearest cause leaves and in what a whole ladder leaves, and are corrections from then on.
#include "analysis/diagnosis/ladder/climber.h"

#include "analysis/diagnosis/fit/problem.h"
#include "analysis/diagnosis/fit/seeds.h"
#include "analysis/diagnosis/ladder/plausible.h"
#include "analysis/diagnosis/policy/ladder.h"
#include "analysis/diagnosis/search/search.h"

#include <algorithm>

namespace stickslip::gap {
namespace {

constexpr double omega = levels[ladder_level];  // numerical: rad/s
constexpr std::size_t fits_at_once = 4;         // of one term, from several starts
constexpr int steps = 2;                        // from a fit, a size is nearly linear

bool documented(const Joint& joint, std::string_view term)
{
    Joint copy = joint;
    const Friction& friction = main_friction(copy);
    if (term == "cogging") return joint.load.cogging.acts();
    if (term == "friction-drift") return friction.drift.change != 0;
    return friction.ripple.acts();
}

/// A term behind a fitted model.
struct Behind {
    const Scales& scales;
    const Candidate& model;
    const Eigen::VectorXd& x;
    const Candidate& term;
    const Candidate with = together(model, term);

    /// The model with the term from there: the term where it acts, its size and the model's numbers fitted. A wave not
    /// much shorter than the travel hides in numbers that were fitted without it.
    Fitting<LevelFit> fit(const std::vector<Case>& cases, const Eigen::VectorXd& own) const
    {
        Eigen::VectorXd all(x.size() + own.size());
        all << x, own;
        Kept kept(static_cast<std::size_t>(all.size()), 0);
        for (std::size_t i = 0; i < term.parameter_count(); ++i)
            kept[static_cast<std::size_t>(x.size()) + i] = term.parameter(i).quantity != Quantity::effort;
        return descending({cases, with, scales, omega}, all, steps, kept);
    }
    Fitting<LevelFit> fit_without(const std::vector<Case>& cases) const
    {
        return descending({cases, model, scales, omega}, x, steps);
    }
    static Candidate together(const Candidate& model, const Candidate& term)
    {
        Candidate both = model;
        both.effects.push_back(term.effects[0]), both.forms.push_back(term.forms[0]);
        return both;
    }
};

/// Whether a term pays on rows that nothing was fitted to: in all, and in every fold.
bool pays(const HeldOutData& data, const Behind& behind, const Eigen::VectorXd& own)
{
    double gain = 0;
    for (std::size_t fold = 0; fold < HeldOutData::folds; ++fold) {
        const auto judged = [&](const Candidate& model, const LevelFit& fit) {
            return mean_log(data.judge(fold, model, in_si(model, fit.x, behind.scales)));
        };
        const auto& rest = data.without(fold);
        std::vector<Fitting<LevelFit>> fits;
        fits.push_back(behind.fit_without(rest)), fits.push_back(behind.fit(rest, own));
        const auto found = side_by_side(std::move(fits));
        const double in_fold = judged(behind.model, found[0]) - judged(behind.with, found[1]);
        if (!(in_fold > 0)) return false;
        gain += in_fold / HeldOutData::folds;
    }
    return gain > policy::worth_a_small_term;
}

/// Adds to the corrections each small term that earns its place beside these causes with these numbers, which the
/// corrections stand in front of. What the causes or the document have is not looked for again.
void add_small_terms(Corrections& corrections, const HeldOutData& data, const Scales& scales, const LadderRules& rules,
                     const Candidate& causes, Eigen::VectorXd x, const ParallelFor& parallel)
{
    const auto& cases = data.fitted();
    for (const std::string_view name : Corrections::small_terms()) {
        const bool is_cause = std::ranges::any_of(causes.effects, [&](const auto* e) { return e->name == name; });
        if (is_cause || documented(cases[0].joint, name) || corrections.has(name)) continue;
        const Effect& effect = *effect_named(name);
        // a wave that does not repeat is a trend: it would take over a part of what the causes' own numbers explain
        const EffectForm form = with_physical_waves(effect, effect.forms[0], scales, rules.ranges);
        const Candidate term{{&effect}, {&form}, cases.size()};
        if (!term.applies(cases[0].joint)) continue;
        const Corrected model = corrections.beside(causes);
        auto from = starts(cases, scales, term, model.candidate, in_si(model.candidate, x, scales));
        std::erase_if(from,
                      [&](const auto& own) { return !plausible(term, own, scales, cases[0].joint, rules.ranges); });
        if (from.empty()) continue;
        const Behind behind{scales, model.candidate, x, term};
        std::vector<LevelFit> all(from.size());
        const auto groups = in_groups(std::vector<double>(from.size(), 1.0), fits_at_once);
        parallel(groups.size(), [&](std::size_t g) {
            std::vector<Fitting<LevelFit>> fits;
            for (const std::size_t i : groups[g]) fits.push_back(behind.fit(cases, from[i]));
            auto found = side_by_side(std::move(fits));
            for (std::size_t k = 0; k < found.size(); ++k) all[groups[g][k]] = std::move(found[k]);
        });
        const auto best =
            std::ranges::min_element(all, {}, [](const LevelFit& fit) { return fit.evaluation.objective; });
        const Eigen::VectorXd own = best->x.tail(from[0].size());
        if (!own.allFinite() || !pays(data, behind, own)) continue;
        corrections.add_small_term(effect, form, own);
        const Corrected with = corrections.beside(causes);
        Eigen::VectorXd next =
            Corrections::start(with, model, x, x.tail(x.size() - static_cast<Eigen::Index>(model.numbers)));
        next.segment(static_cast<Eigen::Index>(with.numbers) - own.size(), own.size()) = own;
        x = next;
    }
}

/// Whether a model leaves more than noise in one record at least.
bool more_than_noise(const std::vector<Case>& cases, const Candidate& model, const std::vector<double>& si)
{
    const auto left = evaluate(cases, model, si, omega);
    return std::ranges::any_of(
        left.records, [](const Misfit& m) { return std::max(m.position, m.effort) >= 1 + policy::slack_of_floor; });
}

}  // namespace

/// Beside a set that a climb has come to: whether the corrections have more of them now.
bool LadderSearch::found_small_terms(const FittedSet& set)
{
    if (set.causes.effects.empty()) return false;  // nothing hides them
    const auto si = in_si(set.model.candidate, set.fit.x, scales_);
    if (!more_than_noise(data_.cases(), set.model.candidate, si)) return false;
    data_.raise_floor(set.model.candidate, si);
    add_small_terms(*corrections_, data_, scales_, rules_, set.causes, set.fit.x, parallel_);
    return corrections_->beside(set.causes).numbers > set.model.numbers;
}

FittedSet LadderSearch::or_before(FittedSet anew, const FittedSet& before)
{
    // numbers of the document are looked for in every climb
    if (anew.causes.effects == before.causes.effects || fitter_->of_document(before) == before.causes.effects.size())
        return anew;
    const auto again = [&](const Candidate& causes, const Eigen::VectorXd& x) {
        return climber_->judged({{causes, nullptr, nullptr, {}, 0, x}})[0];
    };
    const auto own = before.fit.x.size() - static_cast<Eigen::Index>(before.model.numbers);
    const auto x = fitter_->start(before.causes, corrected_, before.fit.x.tail(own));
    lower_floor(corrections_->beside(before.causes), fitter_->refit(before.causes, x).x);
    const FittedSet kept = settled(again(before.causes, x));
    // both at the floor of what was kept: at a higher one what it takes would count for less
    const FittedSet other = anew.causes.effects.empty() ? corrected_ : again(anew.causes, anew.fit.x);
    return kept.plausible && earns(other, kept, rules_) ? kept : settled(std::move(anew));
}

std::optional<Ladder> LadderSearch::with_small_term(const Ladder& ladder, const std::vector<Attribution>& pairs,
                                                    const OnlyNoise& only_noise)
{
    if (ladder.rungs.size() < 2) return std::nullopt;
    const Candidate &all = ladder.last().causes, &below = ladder.rungs[ladder.rungs.size() - 2].causes;
    if (two_mass_edit(all)) return std::nullopt;  // ten times as dear to climb
    const auto is_new = [&](const Effect* e) { return std::ranges::count(below.effects, e) == 0; };
    // all of the rung or nothing of it
    if (std::ranges::any_of(all.effects, [&](const Effect* e) {
            return is_new(e) && (!Corrections::is_small_term(*e) || corrections_->has(e->name));
        }))
        return std::nullopt;
    for (std::size_t i = 0; i < all.effects.size(); ++i)
        if (is_new(all.effects[i]))
            corrections_->add_small_term(*all.effects[i], *all.forms[i], ladder.last().of_member(i));
    look_anew();
    return climb(pairs, rules_.most_rungs, only_noise);
}

/// In what the nearest of the first causes leaves, if that is more than noise. All of them, and the corrections alone,
/// have the terms from then on.
void LadderSearch::find_small_terms(std::vector<Start>& looks)
{
    if (looks.empty()) return;
    Start& nearest = looks[0];
    std::vector<Corrected> models;
    for (const auto& look : looks) models.push_back(corrections_->beside(look.causes));
    nearest.x0 = fitter_->refit(nearest.causes, nearest.x0).x;
    const auto si = in_si(models[0].candidate, nearest.x0, scales_);
    if (!more_than_noise(data_.cases(), models[0].candidate, si)) return;
    data_.raise_floor(models[0].candidate, si);
    const auto numbers = models[0].numbers;
    add_small_terms(*corrections_, data_, scales_, rules_, nearest.causes, nearest.x0, parallel_);
    if (corrections_->beside(nearest.causes).numbers == numbers) {
        lower_floor(corrected_.model, corrected_.fit.x);
        return;
    }
    for (std::size_t i = 0; i < looks.size(); ++i)
        looks[i].x0 =
            Corrections::start(corrections_->beside(looks[i].causes), models[i], looks[i].x0,
                               looks[i].x0.tail(looks[i].x0.size() - static_cast<Eigen::Index>(models[i].numbers)));
    correct(corrected_);
}

}  // namespace stickslip::gap
