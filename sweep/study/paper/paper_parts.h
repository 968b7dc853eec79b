// The parts of the answer to the paper's figures. Internal to sweep/study/paper.
#pragma once
#include "sweep/study/paper/paper_figures.h"

namespace stickslip {

PaperFriction paper_friction();
PaperStability paper_stability();

}  // namespace stickslip
