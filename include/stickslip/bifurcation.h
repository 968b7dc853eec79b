// Where limit cycles come from and where they end.
#pragma once
#include "analysis/simulation/attractor/bifurcation.h"
