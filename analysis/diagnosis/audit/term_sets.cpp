#include "analysis/diagnosis/audit/term_sets.h"

#include "analysis/diagnosis/policy/audit.h"
#include "analysis/numerics/line_search.h"

namespace stickslip::gap {
namespace {

constexpr int zones = 28;

/// All sets of `size` of the possible terms, `visit`ed in order.
template <class Visit>
void each_set(const CommandTerms& all, std::size_t size, std::vector<int>& chosen, int from, const Visit& visit)
{
    if (chosen.size() == size) return visit(chosen);
    for (int i = from; i < linear_terms; ++i) {
        if (!all.possible[static_cast<std::size_t>(i)]) continue;
        chosen.push_back(i);
        each_set(all, size, chosen, i + 1, visit);
        chosen.pop_back();
    }
}

}  // namespace

Changed best_set(const CommandTerms& all, double dead_zone, std::size_t size)
{
    Changed best;
    best.dead_zone = dead_zone;
    std::vector<int> chosen;
    each_set(all, size, chosen, 0, [&](const std::vector<int>& set) {
        const auto fit = fit_terms(all, set);
        if (fit.misfit < best.fit.misfit) best.fit = fit, best.terms = set;
    });
    return best;
}

Changed best_zone(const std::vector<Case>& cases, double limit, double largest_error)
{
    const auto judged = [&](double zone) {
        const auto all = command_terms(cases, zone, limit);
        auto none = best_set(all, zone, 0);
        const auto one = best_set(all, zone, 1);
        return one.fit.misfit < policy::much_less * none.fit.misfit ? one : none;
    };
    Changed best = judged(0);
    double low = 0, high = 0;
    double last = 0;
    for (int i = 0; i < zones; ++i) {
        const double zone = largest_error * std::pow(10, -3.0 * (zones - 1 - i) / (zones - 1));
        const auto at = judged(zone);
        if (at.fit.misfit < best.fit.misfit) best = at, low = last, high = zone * std::pow(10, 3.0 / (zones - 1));
        last = zone;
    }
    if (high == 0) return best;
    const double refined = least_between(low, high, [&](double zone) { return judged(zone).fit.misfit; });
    const auto at = judged(refined);
    return at.fit.misfit < best.fit.misfit ? at : best;
}

}  // namespace stickslip::gap
