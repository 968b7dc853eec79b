// Friction on one body: a law and the terms that a real joint may add.
#pragma once
#include "analysis/friction/friction.h"
