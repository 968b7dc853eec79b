// What a motion can show before it is made: the least size of every effect that it reveals, and what it cannot tell
// apart.
#pragma once
#include "analysis/base/parallel_for.h"
#include "analysis/joint/joint.h"

#include <string>
#include <utility>
#include <vector>

namespace stickslip::gap {

/// The least size of one effect that a motion reveals.
struct EffectPower {
    std::string name, parameter;  ///< the effect, and the number of it that measures its size
    double least_size = not_set;  ///< in `unit`; not set: no size within its bounds shows. Of a limit: the largest one
    std::string unit;             ///< of least_size
};

/// What a motion can show.
struct Power {
    std::vector<EffectPower> effects;                              ///< all that the joint can have
    std::vector<std::pair<std::string, std::string>> inseparable;  ///< names of two effects each
};

/// A reference position over time, on the joint's own period.
struct PlannedMotion {
    std::vector<double> time, position;  ///< s; m | rad
};

/// An effect shows where it changes what a slow observer of the record is surprised by, at any of its bandwidths and in
/// any record, by as much as screens causes in the diagnosis (visible_excess of the policy); gains and filter of the
/// controller, which a logged command shows to the digit, from where the audit names them. Two effects are inseparable
/// where, each five times above the noise, what one leaves of the other is below it. Throws std::invalid_argument
/// without a period, a noise or a gain.
Power power_of(const Joint& joint, const PlannedMotion& motion, const ParallelFor& parallel);

}  // namespace stickslip::gap
