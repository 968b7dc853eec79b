#include "analysis/diagnosis/fit/excerpt.h"
#include "analysis/diagnosis/fit/seeds.h"
#include "analysis/diagnosis/search/search.h"

#include <algorithm>

namespace stickslip::gap {
namespace {

constexpr std::size_t refined_singles = 8;

}  // namespace

std::vector<Attribution> fit_singles(const Fit& fit, const std::vector<Candidate>& candidates)
{
    const auto& cases = fit.cases;
    const Scales& scales = fit.scales;
    const double omega = screening_level(fit.nominal);
    const auto brief = excerpts(cases, omega, brief_ticks, coarse), whole = uncut(cases, coarse);
    std::vector<Attribution> best;
    const auto screen = [&](const std::vector<Candidate>& some) {
        std::vector<Attribution> forms(some.size());
        fit.parallel(some.size(), [&](std::size_t i) {
            // frequencies are found on whole records: gaps would blur their spectra
            const auto from = starts(cases, scales, some[i], {}, {});
            if (from.empty()) return;
            const auto& part = needs_history(some[i]) ? whole : brief;
            forms[i] = as_screened(fit, some[i], best_of({part, some[i], scales, omega}, from));
        });
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
    if (!best.empty() && jagged(best[0].candidate) && best[0].score > clear_score) polish_best(fit, best, 1);
    return best;
}

}  // namespace stickslip::gap
