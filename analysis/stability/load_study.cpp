#include "analysis/stability/load_study.h"

#include <algorithm>
#include <cmath>

#include "analysis/stability/joint_spectrum.h"
#include "analysis/stability/steady.h"

namespace stickslip {
namespace {

LoadedVerdict at_load(Joint joint, double load)
{
    link_friction(joint).normal_load = load;
    LoadedVerdict v{load, missing, missing, missing, missing};
    if (steady_sliding(joint).reason != Reason::none) return v;
    v.velocity_only = velocity_only_growth_rate(joint);
    v.state_variable = growth_rate(joint);
    const auto point = linear_point(joint);
    v.k_cr = point.k_cr;
    v.k_v_min = point.k_v_min;
    return v;
}

}  // namespace

LoadStudy load_study(const Joint& joint, std::span<const double> loads, int levels)
{
    LoadStudy study;
    if (loads.empty()) return study;
    const auto [low, high] = std::minmax_element(loads.begin(), loads.end());
    study.low = *low, study.high = *high;
    if (study.low == study.high) levels = 1;
    for (int i = 0; i < levels; ++i)
        study.at.push_back(at_load(joint, i + 1 == levels && i > 0
                                              ? study.high
                                              : study.low + (study.high - study.low) * i / std::max(levels - 1, 1)));
    double simple = 0, memory = 0;
    for (const double load : loads) {
        const double place = levels == 1 ? 0 : (load - study.low) / (study.high - study.low) * (levels - 1);
        const int i = std::clamp(static_cast<int>(place), 0, std::max(levels - 2, 0)), k = std::min(i + 1, levels - 1);
        const double part = place - i;
        const auto& a = study.at[i];
        const auto& b = study.at[k];
        simple += a.velocity_only + part * (b.velocity_only - a.velocity_only) < 0;
        memory += a.state_variable + part * (b.state_variable - a.state_variable) < 0;
    }
    const auto count = static_cast<double>(loads.size());
    study.stable_velocity_only = simple / count;
    study.stable_state_variable = memory / count;
    for (const auto& v : study.at)
        if (std::isfinite(v.k_cr) && !(v.k_cr <= study.hardest_k_cr))
            study.hardest_k_cr = v.k_cr, study.hardest_load = v.load;
    return study;
}

}  // namespace stickslip
