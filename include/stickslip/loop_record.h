// record_along(): a record of a joint along a reference, as its controller would log it.
#pragma once
#include "analysis/simulation/sampled/loop_record.h"
