// Joints of fewer masses, each with what it neglects.
#pragma once
#include "analysis/joint/reduction.h"
