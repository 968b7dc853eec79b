// The gains that act, of a sum or a cascade.
#pragma once
#include "analysis/joint/gains.h"
