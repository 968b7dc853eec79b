// The critical position gain in closed form.
#pragma once
#include "analysis/stability/critical_gain.h"
