// Friction on one body: a law, the terms that a real joint may add, every law, and the concept that all of them share.
#pragma once
#include "analysis/friction/friction.h"
#include "analysis/friction/law.h"
#include "analysis/friction/response.h"
