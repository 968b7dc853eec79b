// simulate(): one motion of one joint in time.
#pragma once
#include "analysis/results/trajectory.h"
#include "analysis/simulation/simulate.h"
