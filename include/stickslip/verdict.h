// linear_verdict(): velocity-only and state-variable verdict of one joint.
#pragma once
#include "analysis/stability/verdict.h"
