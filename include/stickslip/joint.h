// Joint: the description of a joint as plain data.
#pragma once
#include "analysis/joint/joint.h"
