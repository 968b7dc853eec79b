// The disturbance by which outcomes beside steady sliding are looked for.
#pragma once

namespace stickslip {

/// Share of V_0 from which commanding V_0 is a large disturbance, the largest that operation brings about: the friction
/// then differs by nine e-folds of V, or the joint is at rest with its spring wound up.
inline constexpr double near_rest_start = 1e-4;

}  // namespace stickslip
