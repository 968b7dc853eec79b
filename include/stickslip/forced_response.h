// Impulse, step, sine and noise on the linear joint.
#pragma once
#include "analysis/stability/forced_response.h"
