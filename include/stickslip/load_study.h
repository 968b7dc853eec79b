// Verdicts over a range of normal loads.
#pragma once
#include "analysis/stability/load_study.h"
