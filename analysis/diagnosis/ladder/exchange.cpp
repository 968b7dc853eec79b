// How a set that a climb has found is changed: a cause exchanged, a number freed, a family's flexible member tried.
#include "analysis/diagnosis/ladder/climber.h"

#include "analysis/diagnosis/ladder/plausible.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace stickslip::gap {

FittedSet Climber::unfitted_without(const FittedSet& set, std::size_t member) const
{
    Candidate causes;
    causes.records = set.causes.records;
    Eigen::VectorXd x;
    for (std::size_t i = 0; i < set.causes.effects.size(); ++i)
        if (i != member) x = insert(causes, set.causes.effects[i], set.causes.forms[i], x, set.of_member(i));
    return fitter_.unfitted(causes, set, x);
}

FittedSet Climber::without(const FittedSet& set, std::size_t member) const
{
    const FittedSet less = unfitted_without(set, member);
    return fitter_.fit_rest(less.causes, less.fit.x);
}

FittedSet Climber::with(const FittedSet& less, const FittedSet& set, std::size_t member) const
{
    Candidate causes = less.causes;
    const auto x = insert(causes, set.causes.effects[member], set.causes.forms[member], less.of_causes(less.fit.x),
                          set.of_member(member));
    return fitter_.fit(causes, fitter_.start(causes, less, x));
}

bool Climber::worth_an_exchange(const FittedSet& set, const FittedSet& below, const Effect& other) const
{
    if (std::ranges::count(set.causes.effects, &other) > 0) return false;
    auto effects = below.causes.effects;
    effects.insert(std::ranges::upper_bound(effects, &other), &other);
    const auto holds = [&](const FittedSet& s) { return std::ranges::count(s.causes.effects, &other) > 0; };
    const auto same = [&](const FittedSet& s) { return s.causes.effects == effects; };
    return std::ranges::any_of(pool_, holds) && std::ranges::none_of(pool_, same);
}

std::vector<FittedSet> Climber::exchanged(const FittedSet& set)
{
    constexpr std::size_t most = 3;  // go on after a first look
    std::vector<FittedSet> less;
    for (std::size_t i = 0; i < set.causes.effects.size(); ++i) less.push_back(unfitted_without(set, i));
    std::vector<std::pair<Start, const FittedSet*>> looks;
    for (const auto& below : less)
        for (const auto& single : singles_) {
            const Candidate& other = single.candidate;
            if (divides_mass(other) || !worth_an_exchange(set, below, *other.effects[0])) continue;
            looks.emplace_back(Start{below.causes, other.effects[0], other.forms[0], single.x}, &below);
            looks.back().first.causes.records = other.records;
        }
    std::vector<Look> all;
    for (auto& [start, below] : looks) all.push_back({&start, below});
    look_at(all);
    std::vector<Start> starts;
    for (auto& [start, below] : looks)
        if (start.x0.size() > 0) starts.push_back(std::move(start));
    std::ranges::stable_sort(starts, {}, &Start::objective);
    if (starts.size() > most) starts.resize(most);
    return judged(starts);
}

std::optional<FittedSet> Climber::without_correction(const FittedSet& below, const std::vector<FittedSet>& tried)
{
    const auto with = std::ranges::find_if(tried, [&](const FittedSet& t) {
        return t.plausible && t.correction && t.causes.effects.size() > 1 && earns(below, t, rules_);
    });
    if (with == tried.end()) return std::nullopt;
    FittedSet less = without(*with, *with->correction);
    if (!less.plausible || less.correction || !(less.misfit < below.misfit)) return std::nullopt;
    pool_.push_back(less);
    return less;
}

FittedSet Climber::freed(FittedSet set)
{
    for (std::size_t i = 0, at = 0; i < set.model.corrections;) {
        const Candidate& all = set.model.candidate;
        const bool bound = Corrections::at_its_bound(all, i, at, set.fit.x);
        const auto single = std::ranges::find_if(
            singles_, [&](const Attribution& s) { return s.candidate.effects[0]->name == all.effects[i]->name; });
        at += all.count_of(*all.forms[i++]);
        if (!bound || all.forms[i - 1]->own > 0 || Corrections::is_small_term(*all.effects[i - 1]) ||
            single == singles_.end())
            continue;
        const Effect* effect = single->candidate.effects[0];
        Start start{set.causes, effect, &effect->forms[0], single->x};
        look_at(std::vector<Look>{{&start, &set}});
        if (start.x0.size() == 0) continue;
        FittedSet more = judged({start})[0];
        if (more.plausible && !more.correction && more.misfit < set.misfit) set = std::move(more), i = at = 0;
    }
    return set;
}

FittedSet Climber::reformed(FittedSet set)
{
    for (std::size_t i = 0; i < set.causes.effects.size(); ++i) {
        const auto starts = in_other_forms(set, *set.causes.effects[i]);
        if (starts.empty()) continue;
        FittedSet other = judged(starts)[0];
        if (other.plausible && !other.correction && other.misfit < set.misfit) set = std::move(other);
    }
    return set;
}

FittedSet Climber::flexed(FittedSet set)
{
    for (std::size_t i = 0; i < set.causes.effects.size(); ++i) {
        const auto starts = with_flexible_member(set, i);
        if (starts.empty()) continue;
        FittedSet more = judged(starts)[0];
        if (more.plausible && earns(set, more, rules_)) set = std::move(more);
    }
    return set;
}

std::vector<Start> Climber::parts_of(const FittedSet& set, std::size_t member) const
{
    const FittedSet others = unfitted_without(set, member);
    const Eigen::VectorXd own = set.of_member(member), of_others = others.of_causes(others.fit.x);
    Eigen::Index at = 0;
    std::vector<Start> starts;
    const auto add = [&](const Candidate& causes, const Eigen::VectorXd& x) {
        starts.push_back({causes, nullptr, nullptr, {}, 0, fitter_.start(causes, set, x)});
    };
    Candidate all = others.causes;
    Eigen::VectorXd of_all = of_others;
    for (const auto& part : set.causes.forms[member]->parts) {
        const Effect* effect = effect_named(part.effect);
        if (std::ranges::count(others.causes.effects, effect) > 0) return {};
        const EffectForm* form = &*std::ranges::find(effect->forms, part.form, &EffectForm::name);
        const auto count = static_cast<Eigen::Index>(set.causes.count_of(*form));
        const Eigen::VectorXd numbers = own.segment(at, count);
        at += count;
        Candidate alone = others.causes;
        const Eigen::VectorXd x = insert(alone, effect, form, of_others, numbers);
        add(alone, x);
        of_all = insert(all, effect, form, of_all, numbers);
    }
    if (starts.size() > 1) add(all, of_all);
    return starts;
}

FittedSet Climber::in_parts(FittedSet set)
{
    for (std::size_t i = 0; i < set.causes.effects.size(); ++i) {
        const std::size_t causes = set.causes.effects.size();
        const auto tried = judged(parts_of(set, i));
        const auto stands = [](const FittedSet& t) { return t.plausible && !t.correction; };
        const auto alone = std::ranges::find_if(
            tried, [&](const FittedSet& t) { return stands(t) && t.causes.effects.size() == causes; });
        const auto both = std::ranges::find_if(
            tried, [&](const FittedSet& t) { return stands(t) && t.causes.effects.size() > causes; });
        if (alone != tried.end() && alone->misfit - set.misfit < least_gain(set, rules_)) {
            // no rival either: the two were held against each other
            std::erase_if(pool_, [&](const FittedSet& s) { return s.causes.forms == set.causes.forms; });
            set = *alone;
        } else if (both != tried.end() && causes < rules_.most_rungs &&
                   both->misfit < set.misfit - margin_of(*both, rules_)) {
            set = *both;
        }
    }
    return set;
}

namespace {

/// Which number of a form another one lacks, which is the same otherwise; none where it lacks more or has others.
std::optional<std::size_t> lacking(const EffectForm& form, const EffectForm& simpler)
{
    const auto &all = form.parameters, &fewer = simpler.parameters;
    if (fewer.size() + 1 != all.size() || form.own != simpler.own || form.encoder_on_link != simpler.encoder_on_link)
        return std::nullopt;
    std::size_t i = 0;
    while (i < fewer.size() && all[i].name == fewer[i].name) ++i;
    const bool rest = std::equal(fewer.begin() + static_cast<std::ptrdiff_t>(i), fewer.end(),
                                 all.begin() + static_cast<std::ptrdiff_t>(i) + 1, all.end(),
                                 [](const auto& a, const auto& b) { return a.name == b.name; });
    return rest ? std::optional(i) : std::nullopt;
}

}  // namespace

/// Where a spring hardens at efforts that it never carries, it is a linear one: a number at its bound may be absent.
std::vector<Start> Climber::in_simpler_forms(const FittedSet& set) const
{
    std::vector<Start> starts;
    for (std::size_t i = 0; i < set.causes.effects.size(); ++i) {
        const Effect& effect = *set.causes.effects[i];
        const EffectForm& form = *set.causes.forms[i];
        const Eigen::VectorXd own = set.of_member(i);
        for (const auto& simpler : effect.forms) {
            const auto gone = lacking(form, simpler);
            if (!gone || form.own > 0 || !Candidate{{&effect}, {&simpler}, set.causes.records}.applies(fitter_.joint()))
                continue;
            const auto at = static_cast<Eigen::Index>(*gone);
            const auto& number = form.parameters[*gone];
            if (!at_bound(number, number.logarithmic ? std::exp(own[at]) : own[at])) continue;
            Eigen::VectorXd rest(own.size() - 1);
            rest << own.head(at), own.tail(own.size() - at - 1);
            const FittedSet others = unfitted_without(set, i);
            Candidate causes = others.causes;
            const Eigen::VectorXd x = insert(causes, &effect, &simpler, others.of_causes(others.fit.x), rest);
            starts.push_back({causes, nullptr, nullptr, {}, 0, fitter_.start(causes, set, x)});
        }
    }
    return starts;
}

std::vector<Start> Climber::with_flexible_member(const FittedSet& set, std::size_t member) const
{
    const Effect& effect = *set.causes.effects[member];
    if (effect.flexible.empty() || set.causes.forms[member] != &effect.forms[0]) return {};
    const EffectForm& form = effect.flexible[0];
    const FittedSet others = unfitted_without(set, member);
    const auto count = static_cast<Eigen::Index>(effect.forms[0].parameters.size());
    Eigen::VectorXd own = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(form.parameters.size()));
    own.head(count) = set.of_member(member).head(count);
    std::vector<Start> starts;
    const auto add = [&](const Eigen::VectorXd& numbers) {
        Candidate causes = others.causes;
        const Eigen::VectorXd x = insert(causes, &effect, &form, others.of_causes(others.fit.x), numbers);
        starts.push_back({causes, nullptr, nullptr, {}, 0, fitter_.start(causes, set, x)});
    };
    add(own);
    constexpr Eigen::Index sizes = 2;  // sine and cosine, in front of the number of periods and behind it
    Eigen::VectorXd longer = own;
    longer.tail(sizes) = own.head(sizes), longer.head(sizes).setZero();
    longer[sizes] -= std::log(2.0);
    add(longer);
    return starts;
}

}  // namespace stickslip::gap
