// Long records: the stretches of them that are fitted. All other rows are held out.
#pragma once
#include "analysis/diagnosis/fit/fit.h"

#include <vector>

namespace stickslip::gap {

/// The ticks [from, to) of a record.
struct StretchOf {
    std::size_t record = 0, from = 0, to = 0;
};

/// Nothing where the records have no more than policy::most_whole ticks together; else about policy::fitted ticks of
/// them in stretches, at least one of every record, in the order of records and time.
std::vector<StretchOf> stretches_of(const std::vector<Case>& records);

/// This part of a record as a record of its own: it keeps its times, and begins as the motion and the controller's
/// integral say.
Case part_of(const Case& record, std::size_t from, std::size_t to);

}  // namespace stickslip::gap
