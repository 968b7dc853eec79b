#include "analysis/diagnosis/fit/jumps.h"

namespace stickslip::gap {

bool settle_jumps(std::vector<Case>& cases, const Candidate& candidate, const std::vector<double>& si)
{
    constexpr double omega = 50;     // numerical: rad/s
    constexpr double moments = 0.1;  // numerical: s; the observer has forgotten the jump by then
    bool moved = false;
    for (auto& c : cases) {
        Ticks& t = c.ticks;
        const int m = t.ticks_per_row;
        if (m < 2 || t.jumps.empty()) continue;
        const Plant plant = flatten(edited(c.joint, candidate, si, c.number));
        const std::vector<double> before = t.reference, rate_before = t.reference_rate;
        std::vector<double> least(t.jumps.size(), infinity);
        std::vector<int> best(t.jumps.size(), m);
        Innovation innovation;
        for (int after = 1; after <= m; ++after) {
            for (std::size_t j = 0; j < t.jumps.size(); ++j) place_jump(t, c.joint.control, j, after);
            predict(plant, t, known_command(plant, t), omega, innovation);
            for (std::size_t j = 0; j < t.jumps.size(); ++j) {
                double sum = 0;
                for (std::size_t k = t.jumps[j]; k < t.size() && t.time[k] < t.time[t.jumps[j]] + moments; ++k)
                    if (t.logged[k]) sum += innovation.position[k] * innovation.position[k];
                if (sum < least[j]) least[j] = sum, best[j] = after;
            }
        }
        for (std::size_t j = 0; j < t.jumps.size(); ++j) place_jump(t, c.joint.control, j, best[j]);
        moved = moved || t.reference != before || t.reference_rate != rate_before;
    }
    return moved;
}

}  // namespace stickslip::gap
