// Compliance, gain and phase margins, root locus.
#pragma once
#include "analysis/stability/loop_margins.h"
