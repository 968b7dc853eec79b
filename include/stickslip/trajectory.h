// A motion in time.
#pragma once
#include "analysis/results/trajectory.h"
