// A report from the closed form of one mass with one-state friction (Dupont 1991, (34)-(35), kept m and k_v): what the
// pictures are tried on.
#pragma once
#include "analysis/results/report.h"

namespace stickslip::example {

/// k_cr for m = 1 kg, A = 1 N, B = 1.5 N, L = 10 µm; NaN where every k_p > 0 is stable.
double critical_gain(double k_v, double velocity);

StabilityMap map(std::size_t columns, std::size_t rows);
CriticalGainSurface surface();
LineChart lines();
Report report();

}  // namespace stickslip::example
