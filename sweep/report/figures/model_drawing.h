// The lumped models of the paper as drawings: bodies, springs, dampers, friction and the loop, with their numbers.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/results/report.h"

#include <string>

namespace stickslip {

/// Figs. 4, 5, 6, 7a or 7b, whichever the joint is. Numbers that are not set are left out.
LineDrawing model_drawing(const Joint& joint);

/// The same with a caption, as a figure of a page.
Figure model_drawing_figure(const Joint& joint, std::string id);

/// The joint at hand in a section of its own, "model".
Section model_section(const Joint& joint);

/// "Fig. 7a", "Fig. 5", …: the figure of the paper that the joint is.
std::string model_figure(const Joint& joint);

}  // namespace stickslip
