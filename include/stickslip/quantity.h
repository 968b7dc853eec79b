// What kind of thing a number is, and the unit it is written in: Quantity, Motion, unit_of().
#pragma once
#include "analysis/results/quantity.h"
