// How parameters describe themselves: Field, Range, not_set, is_set().
#pragma once
#include "analysis/base/field.h"
