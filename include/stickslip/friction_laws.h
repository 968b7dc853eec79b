// Every friction law, and FrictionLaw, which holds one of them.
#pragma once
#include "analysis/friction/law.h"
