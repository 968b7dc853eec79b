// Whether a joint hunts about a set point.
#pragma once
#include "analysis/simulation/set_point/set_point.h"
