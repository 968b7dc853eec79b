// What disturbs steady sliding.
#pragma once
#include "analysis/results/disturbance.h"
