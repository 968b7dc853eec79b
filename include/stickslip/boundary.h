// locate_boundaries() along an axis, follow_boundaries() over two.
#pragma once
#include "analysis/boundary/kinds/boundary.h"
