// nonlinear_verdict(): what the joint does after a disturbance.
#pragma once
#include "analysis/simulation/attractor/nonlinear.h"
