#include "sweep/words/neighbour_text.h"

#include "analysis/results/text.h"

namespace stickslip {

std::string near_mode_text(const NearMode& mode, Units units)
{
    const auto frequency = [&](double omega) { return with_unit(omega, Quantity::angular_frequency, units); };
    return "Neighbour " + std::to_string(mode.neighbour + 1) + " vibrates at " + frequency(mode.omega) + ", within " +
           percent(near_mode) + " of the frequency at which friction turns this joint unstable (" +
           frequency(mode.friction) +
           "): its gains change the critical gain, and neither a rigid nor a free neighbour " + "bounds it.";
}

Alert near_mode_alert(const NearMode& mode, Units units)
{
    return {Headline::Tone::warning, near_mode_text(mode, units)};
}

}  // namespace stickslip
