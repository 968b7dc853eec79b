#include "sweep/files/toml/refused_memory.h"

#include "sweep/files/text/toml_input.h"

#include <fmt/format.h>

namespace stickslip::files {

Problem refused_memory(const Control& control, double sensor_delay)
{
    if (is_set(control.period) && control.velocity_estimate.average > most_dead_ticks)
        return {"control.velocity_estimate.average",
                fmt::format("is {}, expected at most {} readings", number_text(control.velocity_estimate.average),
                            most_dead_ticks)};
    const double most = most_dead_ticks * control.period;
    const bool own = control.delay > most;
    if (!is_set(control.period) || !(own || (sensor_delay > 0 && control.delay + sensor_delay > most))) return {};
    const double given = own ? control.delay : control.delay + sensor_delay;
    return {own ? "control.delay" : "sensor.delay",
            fmt::format("is {} s{}, which is {:.6g} periods, expected at most {} periods ({} s)",
                        number_text(own ? given : sensor_delay),
                        own ? "" : " and control.delay " + number_text(control.delay) + " s", given / control.period,
                        most_dead_ticks, number_text(most))};
}

}  // namespace stickslip::files
