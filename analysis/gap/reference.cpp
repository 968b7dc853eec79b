#include "analysis/gap/reference.h"

#include "analysis/gap/controller.h"

#include <cmath>

namespace stickslip::gap {
namespace {

/// k_p r + k_v ṙ at every tick; empty where nothing usable was logged.
std::vector<double> wanted(const Case& c)
{
    const Ticks& t = c.ticks;
    const Control& control = c.joint.control;
    Controller controller(control);
    std::vector<double> sum(t.size(), not_set);
    std::size_t last = t.size();
    for (std::size_t k = 0; k < t.size(); ++k) {
        const double exact = is_set(t.velocity[k]) ? t.velocity[k] : 0;
        controller.read(t.position[k], k == 0 ? t.step[0] : t.step[k - 1], exact);
        if (t.has_velocity && !t.rebuilt && is_set(t.velocity[k])) controller.believe(t.velocity[k]);
        if (!t.logged[k] || !is_set(t.command[k]) || std::abs(t.command[k]) > 0.999 * control.effort_limit) continue;
        sum[k] = t.command[k] + control.k_p * t.position[k] + control.k_v * controller.velocity();
        const double before = last < t.size() ? sum[last] : sum[k];
        const std::size_t from = last < t.size() ? last + 1 : 0;
        for (std::size_t i = from; i < k; ++i)
            sum[i] = before + (sum[k] - before) * static_cast<double>(i + 1 - from) / static_cast<double>(k + 1 - from);
        last = k;
    }
    if (last == t.size()) return {};
    for (std::size_t i = last + 1; i < t.size(); ++i) sum[i] = sum[last];
    return sum;
}

}  // namespace

bool rebuild_reference(Case& c)
{
    Ticks& t = c.ticks;
    const Control& control = c.joint.control;
    if (t.has_reference || t.source != CommandSource::logged || t.size() < 2 || control.k_p == 0 ||
        control.kind != ControlKind::position || (t.ticks_per_row > 1 && !t.rebuilt && !t.has_velocity))
        return false;
    const auto sum = wanted(c);
    if (sum.empty()) return false;
    const bool follows_rate = control.reference_velocity && control.k_v != 0;
    t.reference[0] = sum[0] / control.k_p;
    t.reference_rate[0] = 0;
    for (std::size_t k = 1; k < t.size(); ++k) {
        if (!follows_rate) {
            t.reference[k] = sum[k] / control.k_p;
            t.reference_rate[k] = 0;
            continue;
        }
        // trapezoidal rule on k_v ṙ = sum − k_p r
        const double half = 0.5 * t.step[k - 1];
        t.reference[k] = (t.reference[k - 1] + half * (t.reference_rate[k - 1] + sum[k] / control.k_v)) /
                         (1 + half * control.k_p / control.k_v);
        t.reference_rate[k] = (sum[k] - control.k_p * t.reference[k]) / control.k_v;
    }
    t.has_reference = true;
    return true;
}

}  // namespace stickslip::gap
