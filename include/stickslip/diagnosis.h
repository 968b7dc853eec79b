// gap::diagnose(): where the gap between a joint and its records lies and what causes it, what it finds, why it is
// refused.
#pragma once
#include "analysis/diagnosis/diagnose.h"
#include "analysis/results/cannot_answer.h"
#include "analysis/results/diagnosis.h"
