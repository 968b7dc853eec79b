// Charts of what a joint does at a set point, over two of its numbers.
#pragma once
#include "analysis/results/boundary.h"
#include "analysis/results/report.h"
#include "sweep/study/hunting_field.h"

#include <string>
#include <vector>

namespace stickslip {

/// Where it hunts, rests or diverges, and how far apart its stops are where it hunts, under the located boundaries.
std::vector<Figure> hunting_figures(const HuntingField& field, const std::vector<FollowedBoundary>& curves,
                                    Units units);

/// "The joint comes to rest nowhere on this chart: it hunts on 67.8 %, diverges on 32.2 %."
std::string hunting_shares_text(const HuntingField& field);

}  // namespace stickslip
