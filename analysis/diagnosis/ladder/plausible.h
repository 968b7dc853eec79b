// Whether the numbers of a fitted cause can be those of a joint.
#pragma once
#include "analysis/diagnosis/fit/fit.h"
#include "analysis/diagnosis/policy/rules.h"

namespace stickslip::gap {

/// Whether a number, in the unit of its scale, is at an end of its range (`beside_bound`).
bool at_bound(const EffectParameter& parameter, double scaled);

/// No number at a bound of its fit, none outside its physical range. `x` are numbers of these causes alone.
bool plausible(const Candidate& causes, const Eigen::VectorXd& x, const Scales& scales, const Joint& joint,
               std::span<const PhysicalRange> ranges);

/// A form of the effect whose fits cannot leave the physical range of waves: at least so many periods of the travel.
EffectForm with_physical_waves(const Effect& effect, EffectForm form, const Scales& scales,
                               std::span<const PhysicalRange> ranges);

}  // namespace stickslip::gap
