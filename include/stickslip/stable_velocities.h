// How slow a joint can go with given gains.
#pragma once
#include "analysis/stability/resolution.h"
