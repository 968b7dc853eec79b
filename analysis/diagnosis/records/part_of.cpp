#include "analysis/diagnosis/records/part_of.h"

namespace stickslip::gap {

Ticks part_of(const Ticks& whole, std::size_t from, std::size_t to)
{
    Ticks t;
    t.name = whole.name;
    t.source = whole.source, t.ticks_per_row = whole.ticks_per_row;
    t.regular = whole.regular, t.lost = whole.lost, t.rebuilt = whole.rebuilt;
    t.reference_rebuilt = whole.reference_rebuilt, t.straight_command = whole.straight_command;
    t.noisy_rows = whole.noisy_rows, t.noise_kept = whole.noise_kept, t.began = whole.began;
    t.has_velocity = whole.has_velocity, t.own_velocity = whole.own_velocity, t.has_effort = whole.has_effort,
    t.has_reference = whole.has_reference;
    if (from == 0) {
        t.at_rest = whole.at_rest, t.initial_velocity = whole.initial_velocity;
        t.initial_velocity_error = whole.initial_velocity_error;
        t.initial_acceleration = whole.initial_acceleration;
        t.initial_integral = whole.initial_integral;
    }
    const auto begin = static_cast<std::ptrdiff_t>(from);
    const auto end = static_cast<std::ptrdiff_t>(std::min(to, whole.size()));
    const auto take = [&](auto& column, const auto& all) {
        if (!all.empty()) column.assign(all.begin() + begin, all.begin() + end);
    };
    take(t.time, whole.time), take(t.step, whole.step);
    take(t.reference, whole.reference), take(t.reference_rate, whole.reference_rate);
    take(t.position, whole.position), take(t.velocity, whole.velocity);
    take(t.command, whole.command), take(t.effort, whole.effort), take(t.supply, whole.supply);
    take(t.feed_forward, whole.feed_forward), take(t.load, whole.load), take(t.inertia, whole.inertia);
    take(t.load_error, whole.load_error);
    take(t.enabled, whole.enabled), take(t.logged, whole.logged), take(t.judged, whole.judged);
    // a jump between the last row and the next one is not in it
    for (const std::size_t jump : whole.jumps)
        if (jump >= from && jump + static_cast<std::size_t>(whole.ticks_per_row) < to) t.jumps.push_back(jump - from);
    return t;
}

Ticks first_ticks(const Ticks& ticks, std::size_t count)
{
    return part_of(ticks, 0, count);
}

}  // namespace stickslip::gap
