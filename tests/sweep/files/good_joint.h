// A joint file without a mistake, for the tests that make one.
#pragma once
#include <string>

namespace stickslip {

inline const std::string good = R"([joint]
motion = "prismatic"
model = "single-mass"
inertia = 1.0
[control]
kind = "position"
k_p = "20 kN/m"
k_v = 0
V0 = "1 mm/s"
[friction]
law = "rate-and-state"
f0 = 60
A = 1.0
B = 1.5
L = "10 µm"
V_star = 1.0e-3
)";

}  // namespace stickslip
