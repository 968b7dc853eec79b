#include "analysis/diagnosis/fit/excerpt.h"
#include "analysis/diagnosis/fit/seeds.h"
#include "analysis/diagnosis/policy/search.h"
#include "analysis/diagnosis/search/search.h"

#include <algorithm>
#include <optional>

namespace stickslip::gap {
namespace {

constexpr std::size_t refined_singles = 8;
/// So many candidates are fitted side by side: fewer leave lanes empty, more leave threads without work at the end.
constexpr std::size_t at_once = 4;
constexpr std::size_t two_masses_at_once = 2;  // which have more starts each

/// What the records are searched on.
struct Parts {
    std::vector<Case> brief, whole;
    const std::vector<Case>& of(const Candidate& c) const { return needs_history(c) ? whole : brief; }
};

/// A first look at some candidates, those of these numbers; nothing of one without a start.
void look_at(const Fit& fit, const std::vector<Candidate>& some, std::span<const std::size_t> which, const Parts& parts,
             double omega, std::vector<std::optional<Attribution>>& looked)
{
    std::vector<Fitting<LevelFit>> fits;
    std::vector<std::size_t> own;  // fits of each candidate
    for (const std::size_t i : which) {
        const Candidate& candidate = some[i];
        // frequencies are found on whole records: gaps would blur their spectra
        const auto from = starts(fit.cases, fit.scales, candidate, {}, {});
        own.push_back(0);
        if (from.empty()) continue;
        for (auto& f : fits_from({parts.of(candidate), candidate, fit.scales, omega}, from))
            fits.push_back(std::move(f)), ++own.back();
    }
    auto found = side_by_side(std::move(fits));
    std::span<LevelFit> left(found);
    for (std::size_t k = 0; k < which.size(); ++k) {
        if (own[k] > 0) looked[which[k]] = as_screened(fit, some[which[k]], best_of(left.first(own[k])));
        left = left.subspan(own[k]);
    }
}

}  // namespace

std::vector<Attribution> fit_singles(const Fit& fit, const std::vector<Candidate>& candidates)
{
    const double omega = screening_level(fit.nominal);
    const Parts parts{excerpts(fit.cases, omega, brief_ticks, coarse), uncut(fit.cases, coarse)};
    std::vector<Attribution> best;
    const auto screen = [&](const std::vector<Candidate>& some) {
        std::vector<double> costs;
        for (const auto& candidate : some) costs.push_back(cost_of(candidate));
        const auto groups = in_groups(costs, std::ranges::any_of(some, two_mass_edit) ? two_masses_at_once : at_once);
        std::vector<std::optional<Attribution>> looked(some.size());
        fit.parallel(groups.size(), [&](std::size_t g) { look_at(fit, some, groups[g], parts, omega, looked); });
        for (auto& form : looked) {
            if (!form) continue;
            const auto same = std::find_if(best.begin(), best.end(), [&](const auto& b) {
                return b.candidate.effects == form->candidate.effects;
            });
            if (same == best.end())
                best.push_back(std::move(*form));
            else if (better(*form, *same))
                *same = std::move(*form);
        }
        std::stable_sort(best.begin(), best.end(), better);
        refine_best(fit, best, refined_singles);
    };
    std::vector<Candidate> simple, divided;
    for (const auto& c : candidates) (two_mass_edit(c) ? divided : simple).push_back(c);
    screen(simple);
    if (!best.empty() && best[0].accepted) {
        // two masses cost ten times as much: only those that could be mistaken for the winner
        const auto& mistaken = best[0].candidate.effects[0]->confusable;
        std::erase_if(divided, [&](const Candidate& c) {
            return std::find(mistaken.begin(), mistaken.end(), c.effects[0]->name) == mistaken.end();
        });
    }
    // where the encoder sits is documented more surely than what lies between it and the motor
    std::vector<Candidate> moved;
    std::erase_if(divided, [&](const Candidate& c) {
        if (moves_encoder(c)) moved.push_back(c);
        return moves_encoder(c);
    });
    if (!divided.empty()) screen(divided);
    if (!moved.empty() && !(best.size() > 0 && best[0].accepted)) screen(moved);
    if (!best.empty() && jagged(best[0].candidate) && best[0].score > policy::clear_score) polish_best(fit, best, 1);
    return best;
}

}  // namespace stickslip::gap
