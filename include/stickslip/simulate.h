// One motion of one joint.
#pragma once
#include "analysis/simulation/simulate.h"
