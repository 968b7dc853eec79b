// locate_boundaries() along an axis, follow_boundaries() over two, and what they find: points with their brackets,
// curves.
#pragma once
#include "analysis/boundary/kinds/boundary.h"
#include "analysis/results/boundary.h"
