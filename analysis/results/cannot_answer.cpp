#include "analysis/results/cannot_answer.h"

#include <iterator>

namespace stickslip {

std::string_view CannotAnswer::name_of(Why why)
{
    static constexpr std::string_view names[] = {"no-record",
                                                 "force-loop",
                                                 "contact-spring",
                                                 "many-bodies",
                                                 "no-parameter",
                                                 "no-time",
                                                 "no-position",
                                                 "column-length",
                                                 "not-finite",
                                                 "inertia-not-positive",
                                                 "time-repeats",
                                                 "time-runs-back",
                                                 "table-of-many-bodies",
                                                 "table-of-two-springs",
                                                 "no-number",
                                                 "no-velocity",
                                                 "no-stiffness",
                                                 "no-period",
                                                 "no-position-gain",
                                                 "few-rows",
                                                 "no-noise",
                                                 "short-motion"};
    static_assert(std::size(names) == static_cast<std::size_t>(Why::short_motion) + 1);
    return names[static_cast<std::size_t>(why)];
}

}  // namespace stickslip
