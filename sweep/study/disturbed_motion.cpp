#include "sweep/study/disturbed_motion.h"

#include "analysis/stability/real_response.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stickslip {
namespace {

constexpr int samples = sampled_disturbance;

/// Ten times what the slowest mode needs to change by e, but no more than two hundred of its turns.
double shown_duration(const std::vector<std::complex<double>>& roots)
{
    double longest = 0;
    for (const auto& s : roots) {
        if (std::abs(s) == 0) continue;
        const double settled = 10 / std::abs(s.real()), turns = 200 * 2 * std::numbers::pi / std::abs(s);
        longest = std::max(longest, std::min(settled, turns));
    }
    return longest;
}

SampledForce force_of(const AskedDisturbance& asked, double duration, double omega)
{
    constexpr std::pair<const char*, ForceKind> kinds[] = {{"impulse", ForceKind::impulse},
                                                           {"step", ForceKind::step},
                                                           {"sine", ForceKind::sine},
                                                           {"noise", ForceKind::noise}};
    for (const auto& [name, kind] : kinds)
        if (asked.kind == name) return sampled_force(kind, asked.size, duration, duration / samples, omega, asked.seed);
    SampledForce force = sampled_force(ForceKind::step, 0, duration, duration / samples);
    force.value = asked.record->sampled(force.step, samples);
    for (double& d : force.value) d *= asked.size;
    return force;
}

}  // namespace

std::optional<DisturbedMotion> disturbed_motion(const Joint& joint, const AskedDisturbance& asked)
{
    const auto memory = LoopResponse::of(joint, Theory::state_variable);
    const auto simple = LoopResponse::of(joint, Theory::velocity_only);
    if (!memory || !simple) return std::nullopt;
    double duration = is_set(asked.duration) ? asked.duration
                      : asked.record         ? asked.record->duration()
                                             : shown_duration(memory->roots());
    const auto peak = memory->peak();
    const double omega = is_set(asked.omega) ? asked.omega : peak.omega > 0 ? peak.omega : 20 / duration;
    if (!is_set(asked.duration) && asked.kind == "sine") duration = std::max(duration, 12 * std::numbers::pi / omega);
    DisturbedMotion motion;
    motion.force = force_of(asked, duration, omega);
    motion.memory = memory->forced(motion.force);
    motion.velocity_only = simple->forced(motion.force);
    const auto& x = motion.memory.position;
    const auto largest =
        std::max_element(x.begin(), x.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
    motion.peak = std::abs(*largest);
    motion.peak_time = motion.memory.time[static_cast<std::size_t>(largest - x.begin())];
    return motion;
}

}  // namespace stickslip
