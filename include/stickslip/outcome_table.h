// Which friction law explains a table of measured outcomes.
#pragma once
#include "analysis/diagnosis/outcomes/explain.h"
