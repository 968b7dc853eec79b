#include "analysis/diagnosis/ladder/ladder.h"

#include "analysis/diagnosis/ladder/climber.h"
#include "analysis/diagnosis/ladder/fit_set.h"
#include "analysis/diagnosis/search/search.h"

#include <algorithm>
#include <cmath>

namespace stickslip::gap {
namespace {

constexpr std::size_t known_pairs = 3;  // of a search of their own, that are tried as two rungs

/// Against a floor as high as the whole gap the prior weighs too much. What the first fit leaves is a lower floor,
/// which lets the next one go further, until both agree.
constexpr int most_rounds_of_floor = 5;
constexpr double settled_floor = 0.02;  // numerical: of mean log square, by which a round must lower it to go on

std::vector<Start> known_sets(const std::vector<Attribution>& pairs, const SetFitter& fitter, const FittedSet& below)
{
    std::vector<Start> known;
    for (std::size_t i = 0; i < std::min(known_pairs, pairs.size()); ++i)
        if (known.empty() || !divides_mass(pairs[i].candidate))
            known.push_back({pairs[i].candidate,
                             nullptr,
                             nullptr,
                             {},
                             0,
                             fitter.start(pairs[i].candidate, below, pairs[i].x[ladder_level])});
    return known;
}

}  // namespace

double margin_of(const FittedSet& better, const LadderRules& rules)
{
    double rows = 0, beyond = 0, all = 0;
    for (const auto& w : better.all_left()) {
        rows += w.rows(), beyond += w.beyond_noise();
        all += w.rows() * (w.position + (is_set(w.effort) ? w.effort : 0));
    }
    return rules.margin * std::clamp(beyond / std::max(all, 1e-300), 0.0, 1.0) +
           rules.rows_of_margin / std::max(rows, 1.0);
}

LadderSearch::LadderSearch(const Fit& fit, const std::vector<Attribution>& singles, const LadderRules& rules)
    : scales_(fit.scales),
      rules_(rules),
      parallel_(fit.parallel),
      corrections_(std::make_shared<Corrections>(fit.cases, fit.scales, rules.prior)),
      data_(fit.cases),
      fitter_(std::make_unique<SetFitter>(data_, fit.scales, *corrections_, rules.ranges)),
      climber_(std::make_unique<Climber>(singles, *fitter_, rules, fit.parallel))
{
    for (std::size_t f = 0; f < HeldOutData::folds; ++f)
        for (const auto& w : data_.judge(f, {}, {})) documented_.push_back(w);
    begin();
    if (singles.empty()) return;
    auto looks = climber_->looks(corrected_);
    find_small_terms(looks);
    first_ = climber_->judged(looks);
    wrong_numbers_ = climber_->wrong_numbers(corrected_, *corrections_, false);
}

/// The corrections as they are, fitted alone from the floor of the documented joint on.
void LadderSearch::begin()
{
    data_.raise_floor({}, {});
    fitter_->renew();
    correct(corrected_);
}

void LadderSearch::look_anew()
{
    begin();
    climber_->forget();
    first_ = climber_->judged(climber_->looks(corrected_));
    wrong_numbers_ = climber_->wrong_numbers(corrected_, *corrections_, false);
}

LadderSearch::~LadderSearch() = default;

void LadderSearch::correct(FittedSet& set)
{
    Eigen::VectorXd x = fitter_->start({}, set, {});
    double before = infinity;
    for (int round = 0; round < most_rounds_of_floor; ++round) {
        x = fitter_->refit({}, x).x;
        if (const double now = lower_floor(corrections_->beside({}), x); now < before - settled_floor)
            before = now;
        else
            break;
    }
    set = fitter_->fit({}, x);
}

double LadderSearch::lower_floor(const Corrected& model, const Eigen::VectorXd& x)
{
    const double left = data_.raise_floor(model.candidate, in_si(model.candidate, x, scales_));
    fitter_->renew();
    return left;
}

FittedSet LadderSearch::settled(FittedSet set)
{
    double before = infinity;
    for (int round = 0; round < most_rounds_of_floor; ++round) {
        const double now = lower_floor(set.model, set.fit.x);
        if (!(now < before - settled_floor)) break;
        before = now;
        set = climber_->compared({set});
    }
    return set;
}

Ladder LadderSearch::climb(const std::vector<Attribution>& pairs, std::size_t most_rungs, const OnlyNoise& only_noise)
{
    FittedSet set = climbed(pairs, most_rungs, only_noise);
    // a larger cause hides small terms: once it is found, they are found, too, and may change what is found with it
    while (set.causes.effects.size() < most_rungs && found_small_terms(set)) {
        look_anew();
        set = or_before(climbed(pairs, most_rungs, only_noise), set);
    }
    // each search leads further down a jagged misfit, and what is half way down leaves too much beside its last cause
    if (jagged(set.causes) && set.causes.effects.size() > 1) set = settled(std::move(set));
    return finished(std::move(set));
}

FittedSet LadderSearch::nearest_of(const std::vector<FittedSet>& tried, const FittedSet& next)
{
    std::vector<FittedSet> rivals{next};
    for (const auto& t : tried)
        if (&t != &next && t.plausible && !t.correction && t.causes.effects.size() == next.causes.effects.size() &&
            t.misfit < next.misfit + margin_of(next, rules_))
            rivals.push_back(t);
    lower_floor(next.model, next.fit.x);
    return climber_->compared(rivals);
}

FittedSet LadderSearch::in_best_forms(FittedSet found)
{
    const auto forms = found.causes.forms;
    found = climber_->flexed(climber_->reformed(std::move(found)));
    return found.causes.forms == forms ? found : settled(std::move(found));
}

FittedSet LadderSearch::without_idle(FittedSet set) const
{
    for (std::size_t i = 0; i < set.causes.effects.size() && set.causes.effects.size() > 1;) {
        FittedSet less = climber_->without(set, i);
        // each search leads further down a jagged misfit: from where the others went without it, so can all of them
        if (jagged(set.causes) && !earns(less, set, rules_))
            if (auto again = climber_->with(less, set, i); again.misfit < set.misfit) set = std::move(again);
        if (earns(less, set, rules_))
            ++i;
        else
            set = std::move(less), i = 0;
    }
    return set;
}

FittedSet LadderSearch::with_an_exchange(FittedSet set)
{
    if (set.causes.effects.size() < 2) return set;
    const auto others = climber_->exchanged(set);
    const auto better = std::ranges::find_if(
        others, [&](const auto& o) { return o.plausible && !o.correction && o.misfit < set.misfit; });
    // beside the right cause another one of the set may have nothing left to do
    return better == others.end() ? set : without_idle(in_best_forms(settled(*better)));
}

const FittedSet* LadderSearch::nearest_at_bounds(const std::vector<FittedSet>& tried, const FittedSet& below) const
{
    const auto nearest =
        std::ranges::find_if(tried, [](const auto& t) { return !t.correction && t.causes.effects.size() > 1; });
    const bool stuck = nearest != tried.end() && !nearest->plausible && earns(below, *nearest, rules_);
    return stuck ? &*nearest : nullptr;
}

FittedSet LadderSearch::climbed(const std::vector<Attribution>& pairs, std::size_t most_rungs,
                                const OnlyNoise& only_noise)
{
    FittedSet set = corrected_;
    const auto best_first = [](const auto& a, const auto& b) { return a.misfit < b.misfit; };
    const std::size_t most_rounds = 2 * most_rungs;  // an exchange may come back to where it was
    std::vector<std::vector<const Effect*>> ends;    // of rounds
    for (std::size_t round = 0; round < most_rounds && set.causes.effects.size() < most_rungs; ++round) {
        const bool at_start = set.causes.effects.empty();
        if (!at_start && only_noise && only_noise(set)) break;
        auto tried = at_start ? first_ : climber_->next(set);
        // what comes nearest in most windows may take nothing of a gap that a few windows hold: then another one does
        const auto earning = [&] {
            return std::ranges::find_if(
                tried, [&](const auto& t) { return t.plausible && !t.correction && earns(set, t, rules_); });
        };
        // what a search of pairs has found may be more than its parts
        if (set.causes.effects.size() == 1 || (at_start && earning() == tried.end())) {
            for (auto& s : climber_->judged(known_sets(pairs, *fitter_, set))) tried.push_back(std::move(s));
            std::stable_sort(tried.begin(), tried.end(), best_first);
        }
        if (at_start && most_rungs > 1) {
            for (auto& s : climber_->judged(climber_->with_hidden_backlash(first_))) tried.push_back(std::move(s));
            std::stable_sort(tried.begin(), tried.end(), best_first);
        }
        if (const auto best = earning(); const auto* stuck = nearest_at_bounds(tried, set)) {
            if (best == tried.end() || stuck->misfit + margin_of(*stuck, rules_) < best->misfit)
                for (auto& s : climber_->exchanged(*stuck)) tried.push_back(std::move(s));
            std::stable_sort(tried.begin(), tried.end(), best_first);
        }
        if (at_start)
            if (const auto best = earning(); auto numbers = nearer_numbers(best == tried.end() ? nullptr : &*best))
                tried.insert(tried.begin(), climber_->with_shared_scale(std::move(*numbers), *corrections_));
        const auto next = earning();
        const auto other = climber_->without_correction(set, tried);
        if (other && (next == tried.end() || other->misfit < next->misfit))
            set = in_best_forms(settled(*other));
        else if (next != tried.end())
            set = in_best_forms(nearest_of(tried, *next));
        else
            break;
        set = with_an_exchange(climber_->in_parts(without_idle(std::move(set))));
        // what of several numbers is left alone is compared with what was tried as one
        if (at_start && set.causes.effects.size() == 1 && next != tried.end() && next->causes.effects.size() > 1)
            if (const auto alone =
                    std::ranges::find_if(tried, [&](const auto& t) { return t.causes.effects == set.causes.effects; });
                alone != tried.end())
                set = in_best_forms(nearest_of(tried, *alone));
        // a second search may lead further down a jagged misfit; one that ends at the same causes again does not
        if (std::ranges::count(ends, set.causes.effects) > 0) break;
        ends.push_back(set.causes.effects);
    }
    if (!set.causes.effects.empty() && set.causes.effects.size() < most_rungs) set = climber_->freed(std::move(set));
    if (set.causes.effects.size() < rules_.most_rungs) set = climber_->with_shared_scale(std::move(set), *corrections_);
    return with_wrong_numbers(std::move(set), most_rungs);
}

}  // namespace stickslip::gap
