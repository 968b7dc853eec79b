// STICKSLIP_VERSION and its parts, for comparisons by the preprocessor.
#pragma once
#include "analysis/base/version.h"
