// The nearest boundary in all directions, and the worst case within an uncertainty.
#pragma once
#include "analysis/boundary/kinds/nearest.h"
