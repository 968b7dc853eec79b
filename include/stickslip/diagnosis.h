// gap::diagnose(): where the gap between a joint and its records lies, and what causes it.
#pragma once
#include "analysis/diagnosis/diagnose.h"
