// What counts as standing still.
#pragma once

namespace stickslip {

inline constexpr double near_rest = 0.01;                          ///< share of V_0: motion below is (near) sticking
inline constexpr double near_rest_logarithm = -4.605170185988091;  ///< ln(1/100)

}  // namespace stickslip
