// Numbers of a joint by dotted path; check(), which says what is wrong with a joint.
#pragma once
#include "analysis/joint/parameters.h"
