// Located points with their brackets, followed curves.
#pragma once
#include "analysis/results/boundary.h"
