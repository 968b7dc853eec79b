// The best gains under requirements.
#pragma once
#include "analysis/design/design.h"
