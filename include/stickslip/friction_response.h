// The concept that all friction laws share.
#pragma once
#include "analysis/friction/response.h"
