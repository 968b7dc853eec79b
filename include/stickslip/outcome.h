// nonlinear_verdict(): what a joint does after a disturbance, with the numbers of its cycle. nonlinear_points(): many
// joints at once.
#pragma once
#include "analysis/results/nonlinear_verdict.h"
#include "analysis/simulation/attractor/nonlinear.h"
#include "analysis/simulation/points.h"
