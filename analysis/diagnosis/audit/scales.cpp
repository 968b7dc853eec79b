// What one of everything means for these cases.
#include "analysis/diagnosis/audit/prepare.h"
#include "analysis/diagnosis/audit/reading_noise.h"
#include "analysis/numerics/statistics.h"

#include <algorithm>
#include <cmath>

namespace stickslip::gap {

Scales scales_of(const std::vector<Case>& cases)
{
    Scales s;
    double effort = 0, velocity = 0, position = 0, tick = 0, duration = 0, command = 0;
    bool peaked = false;
    for (const auto& c : cases) {
        const Plant plant = flatten(c.joint);
        const auto known = known_command(plant, c.ticks);
        Innovation innovation;
        predict(plant, c.ticks, known, levels[1], innovation);
        std::vector<double> speeds;
        for (double v : innovation.velocity) speeds.push_back(std::isfinite(v) ? std::abs(v) : 0);
        velocity = std::max(velocity, percentile(speeds, 0.95));
        effort = std::max(effort, c.ticks.has_effort ? rms(c.ticks.effort) : rms(innovation.predicted_effort));
        for (double e : c.ticks.has_effort ? c.ticks.effort : innovation.predicted_effort)
            if (std::isfinite(e)) s.peak_effort = std::max(peaked ? s.peak_effort : 0, std::abs(e)), peaked = true;
        position = std::max(position, span_of(c.ticks.position));
        tick = std::max(tick, is_set(c.joint.control.period) ? c.joint.control.period : c.row_step);
        duration = std::max(duration, c.ticks.duration());
        for (double u : known) command = std::max(command, std::abs(u));
        s.inertia = plant.driven_inertia();
        Joint copy = c.joint;
        const Friction& main = main_friction(copy);
        s.load = {plant.ratio, plant.link_per_seen()};
        s.friction = &main == &copy.frictions.link ? s.load : Reflected{1, plant.motor_per_seen()};
        s.coulomb = coulomb_force(main) / s.friction.effort;
        if (is_set(c.joint.actuator.supply_voltage)) s.supply = c.joint.actuator.supply_voltage;
    }
    constexpr double least = 1e-12;  // numerical: of a scale, against a division by nothing
    s.effort = std::max({effort, s.coulomb, least});
    s.velocity = std::max(velocity, least);
    s.position = std::max(position, least);
    s.tick = tick;
    s.duration = std::max(duration, tick);
    s.command = std::max(command, least);
    return s;
}

}  // namespace stickslip::gap
