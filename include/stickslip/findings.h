// Diagnosis: what a diagnosis found.
#pragma once
#include "analysis/results/diagnosis.h"
