// The lumped models of the paper as drawings: bodies, springs, dampers, friction and the loop, with their numbers.
#pragma once
#include "analysis/joint/joint.h"

#include <string>

namespace stickslip {

/// Figs. 4, 5, 6, 7a or 7b as a stand-alone SVG, whichever the joint is. Numbers that are not set are left out.
std::string model_drawing(const Joint& joint);

/// "Fig. 7a", "Fig. 5", …: the figure of the paper that the joint is.
std::string model_figure(const Joint& joint);

}  // namespace stickslip
