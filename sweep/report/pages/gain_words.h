// Gains, velocities and frequencies in the words of the sections that compare both theories. Internal to
// sweep/report/pages.
#pragma once
#include "analysis/results/text.h"
#include "sweep/words/interval_text.h"

#include <cmath>
#include <numbers>

namespace stickslip {

/// Values of one joint with their units.
struct GainWords {
    Units units;
    std::string damping(double v) const { return with_unit(v, Quantity::velocity_gain, units, 4); }
    std::string stiffness(double v) const { return with_unit(v, Quantity::position_gain, units, 4); }
    std::string velocity(double v) const { return with_unit(v, Quantity::velocity, units, 4); }
    /// Both ways: engineers read data sheets in Hz.
    std::string frequency(double omega) const
    {
        const auto text = with_unit(omega, Quantity::angular_frequency, units, 4);
        return std::isnan(omega) ? text : text + " (" + plain_number(omega / (2 * std::numbers::pi), 3) + "\u00a0Hz)";
    }
    std::string gains(const std::vector<Interval>& set, Quantity q) const { return intervals_text(set, q, units); }
    /// Where the theories differ: a sliver between edges that read the same is no difference to a reader.
    std::vector<Interval> differing(const std::vector<Interval>& k_p) const
    {
        return that_read_apart(k_p, Quantity::position_gain, units);
    }
};

}  // namespace stickslip
