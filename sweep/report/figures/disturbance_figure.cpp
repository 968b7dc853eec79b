#include "sweep/report/figures/disturbance_figure.h"

#include "analysis/results/text.h"
#include "analysis/stability/real_response.h"
#include "sweep/files/text/series_file.h"
#include "sweep/words/line_figure.h"

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

Series force_record(const AskedDisturbance& asked, Units units)
{
    return read_series(asked.kind, "force", SeriesQuantity{Quantity::effort, units});
}

SampledForce force_of(const AskedDisturbance& asked, double duration, double omega, Units units)
{
    constexpr std::pair<const char*, ForceKind> kinds[] = {{"impulse", ForceKind::impulse},
                                                           {"step", ForceKind::step},
                                                           {"sine", ForceKind::sine},
                                                           {"noise", ForceKind::noise}};
    for (const auto& [name, kind] : kinds)
        if (asked.kind == name) return sampled_force(kind, asked.size, duration, duration / samples, omega, asked.seed);
    SampledForce force = sampled_force(ForceKind::step, 0, duration, duration / samples);
    force.value = force_record(asked, units).sampled(force.step, samples);
    for (double& d : force.value) d *= asked.size;
    return force;
}

}  // namespace

bool is_force_file(const AskedDisturbance& asked)
{
    for (const char* name : {"", "impulse", "step", "sine", "noise"})
        if (asked.kind == name) return false;
    return true;
}

std::optional<DisturbedMotion> disturbed_motion(const Joint& joint, const AskedDisturbance& asked)
{
    const auto memory = LoopResponse::of(joint, Theory::state_variable);
    const auto simple = LoopResponse::of(joint, Theory::velocity_only);
    if (!memory || !simple) return std::nullopt;
    double duration = is_set(asked.duration) ? asked.duration
                      : is_force_file(asked) ? force_record(asked, units_of(joint)).duration()
                                             : shown_duration(memory->roots());
    const auto peak = memory->peak();
    const double omega = is_set(asked.omega) ? asked.omega : peak.omega > 0 ? peak.omega : 20 / duration;
    if (!is_set(asked.duration) && asked.kind == "sine") duration = std::max(duration, 12 * std::numbers::pi / omega);
    DisturbedMotion motion;
    motion.force = force_of(asked, duration, omega, units_of(joint));
    motion.memory = memory->forced(motion.force);
    motion.velocity_only = simple->forced(motion.force);
    const auto& x = motion.memory.position;
    const auto largest =
        std::max_element(x.begin(), x.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
    motion.peak = std::abs(*largest);
    motion.peak_time = motion.memory.time[static_cast<std::size_t>(largest - x.begin())];
    return motion;
}

Figure disturbance_figure(const Joint& joint, const AskedDisturbance& asked, const DisturbedMotion& motion)
{
    const Units units = units_of(joint);
    LineChart chart;
    chart.title = "Response to a disturbing force: " + asked.kind;
    chart.fixed =
        is_force_file(asked)
            ? "the file's force times " + plain_number(asked.size)
            : "size " + with_unit(asked.size, asked.kind == "impulse" ? Quantity::impulse : Quantity::effort, units);
    chart.x_label = axis_label("time t", Quantity::time, units);
    chart.y_label = axis_label("excess position x", Quantity::position, units);
    // an unstable answer would squeeze the other one into a line
    const auto shown = [&](const ForcedResponse& r) {
        LineChart::Line line{"", r.time, r.position};
        for (auto& x : line.y)
            if (std::abs(x) > 3 * motion.peak) x = missing;
        return line;
    };
    auto memory = shown(motion.memory), simple = shown(motion.velocity_only);
    memory.name = "with memory";
    simple.name = "velocity-only model";
    simple.dashed = true;
    chart.lines = {std::move(memory), std::move(simple)};
    return line_figure("forced", std::move(chart),
                       "With memory the link moves by up to " + with_unit(motion.peak, Quantity::position, units) +
                           ", " + with_unit(motion.peak_time, Quantity::time, units) + " after the start.",
                       "d(t) of (9) acts on the link; position in excess of steady sliding by the linear theory, exact "
                       "for a force held over each of " +
                           std::to_string(motion.force.value.size()) + " samples of " +
                           with_unit(motion.force.step, Quantity::time, units) +
                           ". Where a theory calls the joint unstable its line grows until it leaves the picture.");
}

}  // namespace stickslip
