// Records with fewer rows, as slower or damaged logs of the same motion.
#pragma once
#include "analysis/diagnosis/records/record.h"

#include <cstddef>

namespace stickslip::test {

/// The rows whose number `keep` accepts, in the columns that a simulated machine logs.
template <class Keep>
Record rows_where(const Record& whole, const Keep& keep)
{
    Record r;
    r.name = whole.name;
    for (const auto column : {&Record::time, &Record::reference_position, &Record::reference_velocity,
                              &Record::position, &Record::velocity, &Record::effort_command, &Record::effort_measured})
        for (std::size_t k = 0; k < (whole.*column).size(); ++k)
            if (keep(k)) (r.*column).push_back((whole.*column)[k]);
    return r;
}

/// A log at every n-th tick, the first one included.
inline Record every_nth_row(const Record& whole, std::size_t n)
{
    return rows_where(whole, [n](std::size_t k) { return k % n == 0; });
}

}  // namespace stickslip::test
