// Record: a measured record as plain arrays.
#pragma once
#include "analysis/diagnosis/records/record.h"
