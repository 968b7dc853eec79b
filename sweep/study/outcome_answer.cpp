#include "sweep/study/outcome_answer.h"

#include "analysis/diagnosis/outcomes/share.h"
#include "analysis/diagnosis/outcomes/side.h"
#include "sweep/study/samples.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace stickslip {
namespace {

using gap::LawFit;
using gap::OutcomeAnswer;

constexpr std::size_t most_maps = 4;

/// Where a law changes side along the stiffness, neighbours joined while they are as many; NaN between pieces.
Curve boundary_of(const Joint& at, const LawFit& fit, const std::vector<double>& velocities,
                  const std::vector<double>& stiffnesses)
{
    Curve line;
    const auto side = [&](double V, double k) {
        Joint joint = fit.rival ? gap::with_law(at, fit.law) : at;
        joint.control.V0 = V, joint.control.k_p = k;
        return gap::distance_to_stick_slip(joint);
    };
    std::vector<double> before;
    double V_before = 0;
    for (const double V : velocities) {
        std::vector<double> crossings;
        double last = side(V, stiffnesses.front());
        for (std::size_t i = 1; i < stiffnesses.size(); ++i) {
            const double here = side(V, stiffnesses[i]);
            if ((last > 0) != (here > 0)) {
                double low = stiffnesses[i - 1], high = stiffnesses[i];
                constexpr int halvings = 10;
                for (int n = 0; n < halvings; ++n) {
                    const double middle = std::sqrt(low * high);
                    ((side(V, middle) > 0) == (last > 0) ? low : high) = middle;
                }
                crossings.push_back(std::sqrt(low * high));
            }
            last = here;
        }
        if (crossings.size() == before.size())
            for (std::size_t i = 0; i < crossings.size(); ++i) {
                line.x.insert(line.x.end(), {V_before, V, not_set});
                line.y.insert(line.y.end(), {before[i], crossings[i], not_set});
            }
        before = crossings, V_before = V;
    }
    return line;
}

/// Axes around all rows.
OutcomeMap empty_map(const OutcomeAnswer& a)
{
    double low_V = infinity, high_V = 0, low_k = infinity, high_k = 0;
    for (const auto& j : a.outcomes.joints) {
        low_V = std::min(low_V, j.control.V0), high_V = std::max(high_V, j.control.V0);
        low_k = std::min(low_k, j.control.k_p), high_k = std::max(high_k, j.control.k_p);
    }
    constexpr double room = 1.6;
    constexpr int nodes = 41;
    OutcomeMap map;
    map.x = {"control.V0",       "V_{0}", "commanded velocity",
             Quantity::velocity, true,    log_steps(low_V / room, high_V * room, nodes)};
    map.y = {"control.k_p",           "k_{p}", "position gain",
             Quantity::position_gain, true,    log_steps(low_k / room, high_k * room, nodes)};
    return map;
}

OutcomeMap map_at(const OutcomeAnswer& a, const Joint& nominal, double k_v)
{
    OutcomeMap map = empty_map(a);
    map.k_v = k_v;
    const LawFit& best = a.laws.front();
    Joint at = nominal;
    at.control.k_v = k_v;
    at.control.force_rate = not_set;
    for (const double k : map.y.values)
        for (const double V : map.x.values) {
            Joint joint = gap::with_law(at, best.law);
            joint.control.k_p = k, joint.control.V0 = V;
            map.sticks.push_back(gap::distance_to_stick_slip(joint) > 0 ? 1 : 0);
        }
    map.boundary = boundary_of(at, best, map.x.values, map.y.values);
    const auto other = std::find_if(a.laws.begin() + 1, a.laws.end(),
                                    [&](const auto& f) { return f.rival->memory != best.rival->memory; });
    if (other != a.laws.end()) {
        map.other = &*other;
        map.other_boundary = boundary_of(at, *other, map.x.values, map.y.values);
    }
    return map;
}

}  // namespace

OutcomeMaps outcome_maps(const OutcomeAnswer& a, const Joint& nominal)
{
    // maps with both outcomes show a boundary; those with more rows show it better
    std::map<double, std::pair<int, int>> dampings;
    for (std::size_t i = 0; i < a.outcomes.size(); ++i) {
        auto& [sticks, slides] = dampings[a.outcomes.joints[i].control.k_v];
        ++(a.outcomes.table.rows[i].stick_slip ? sticks : slides);
    }
    std::vector<std::tuple<int, int, double>> fullest;
    for (const auto& [k_v, rows] : dampings)
        fullest.emplace_back(-std::min(rows.first, rows.second), -rows.first - rows.second, k_v);
    std::sort(fullest.begin(), fullest.end());
    OutcomeMaps maps{{}, fullest.size()};
    for (std::size_t i = 0; i < std::min(most_maps, fullest.size()); ++i)
        maps.maps.push_back(map_at(a, nominal, std::get<2>(fullest[i])));
    return maps;
}

}  // namespace stickslip
