#include "analysis/diagnosis/fit/excerpt.h"
#include "analysis/diagnosis/search/search.h"

#include <algorithm>
#include <optional>

namespace stickslip::gap {
namespace {

/// A member of a pair by itself, with the numbers that it has there at every level.
Attribution member_of(const Attribution& pair, std::size_t member)
{
    Attribution alone;
    alone.candidate = {{pair.candidate.effects[member]}, {pair.candidate.forms[member]}, pair.candidate.records};
    std::size_t first = 0;
    for (std::size_t i = 0; i < member; ++i) first += pair.candidate.count_of(*pair.candidate.forms[i]);
    const auto count = static_cast<Eigen::Index>(alone.candidate.parameter_count());
    for (std::size_t l = 0; l < levels.size(); ++l)
        alone.x[l] = pair.x[l].segment(static_cast<Eigen::Index>(first), count);
    return alone;
}

/// The two forms that come near this one, together; nothing of a form without two.
std::optional<Candidate> parts_of(const Attribution& single)
{
    Candidate pair;
    pair.records = single.candidate.records;
    for (const auto& part : single.candidate.forms[0]->parts) {
        const Effect* effect = effect_named(part.effect);
        pair.effects.push_back(effect);
        pair.forms.push_back(&*std::ranges::find(effect->forms, part.form, &EffectForm::name));
    }
    if (pair.effects.size() < 2) return {};
    return pair;
}

}  // namespace

std::vector<Attribution> fit_parts(const Fit& fit, const std::vector<Attribution>& singles)
{
    constexpr std::size_t leading = 3;
    const double omega = screening_level(fit.nominal);
    const auto brief = excerpts(fit.cases, omega, brief_ticks, coarse);
    std::vector<Attribution> pairs;
    for (std::size_t i = 0; i < std::min(leading, singles.size()); ++i)
        if (const auto pair = parts_of(singles[i]))
            pairs.push_back(
                as_screened(fit, *pair, improve({brief, *pair, fit.scales, omega}, singles[i].x[0], full_effort)));
    refine_best(fit, pairs, pairs.size());
    return pairs;
}

void fit_members_alone(const Fit& fit, std::vector<Attribution>& singles, const std::vector<Attribution>& pairs)
{
    if (pairs.empty() || !pairs[0].refined) return;
    const double omega = screening_level(fit.nominal);
    const auto brief = excerpts(fit.cases, omega, brief_ticks, coarse), whole = uncut(fit.cases, coarse);
    std::vector<Attribution> members;
    for (std::size_t i = 0; i < pairs[0].candidate.effects.size(); ++i) members.push_back(member_of(pairs[0], i));
    fit.parallel(members.size(), [&](std::size_t i) {
        Attribution& a = members[i];
        const auto& part = needs_history(a.candidate) ? whole : brief;
        a = as_screened(fit, a.candidate, improve({part, a.candidate, fit.scales, omega}, a.x[1], full_effort));
    });
    refine_best(fit, members, members.size());
    for (auto& member : members) {
        const auto same = std::find_if(singles.begin(), singles.end(),
                                       [&](const auto& s) { return s.candidate.effects == member.candidate.effects; });
        if (same == singles.end())
            singles.push_back(std::move(member));
        else if (better(member, *same))
            *same = std::move(member);
    }
    std::stable_sort(singles.begin(), singles.end(), better);
}

}  // namespace stickslip::gap
