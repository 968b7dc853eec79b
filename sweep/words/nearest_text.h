// The nearest boundary in words.
#pragma once
#include "analysis/results/boundary.h"
#include "analysis/results/report.h"

namespace stickslip {

/// A boundary within this factor of the design is near: an alert.
inline constexpr double near_factor = 1.2;

/// "stick-slip appears if L falls by 18 % while B − A grows by 7 %", mark-up.
std::string nearest_text(const NearestBoundary& nearest, Units units);

/// The parameter that moves most, and the sentence.
Headline nearest_headline(const NearestBoundary& nearest, Units units);

/// "m, V_{0}, A, B − A and L": the numbers that a distance is over. B is in a distance over A and B − A, but not by
/// itself: a reader of "five parameters" has to know which.
std::string uncertain_numbers(const NearestBoundary& nearest, Units units);

/// What the letters of that sentence stand for: "L: slip distance. B − A: evolution effect minus direct effect.", below
/// the numbers of the first screen.
void name_symbols(Report& report, const NearestBoundary& nearest, Units units);

/// "±3.2 %" of a share.
std::string off_text(double share);

}  // namespace stickslip
