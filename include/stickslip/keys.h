// Every key of a joint with its default, range, unit and meaning.
#pragma once
#include "analysis/joint/keys.h"
