// What a joint does after a disturbance, with the numbers of its cycle.
#pragma once
#include "analysis/results/nonlinear_verdict.h"
