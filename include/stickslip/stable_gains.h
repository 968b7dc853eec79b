// Which position gains are stable.
#pragma once
#include "analysis/stability/stable_gains.h"
