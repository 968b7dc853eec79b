// All that the linear theory says of one joint beyond the verdict.
#pragma once
#include "analysis/stability/study.h"
