// nonlinear_points(): the outcomes of many joints at once.
#pragma once
#include "analysis/simulation/points.h"
