// What a motion can show before it is measured.
#pragma once
#include "analysis/diagnosis/plan/power.h"
