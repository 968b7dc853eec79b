#include "analysis/base/require_valid.h"
#include "analysis/boundary/kinds/boundary.h"

#include <cmath>

namespace stickslip {

std::string BoundaryRequest::problem() const
{
    return first_problem(problem_unless(std::isnan(precision) || (precision > 0 && precision < 1), "precision",
                                        precision, "between 0 and 1, or NaN for the usual one"),
                         problem_unless(scan >= 0, "scan", scan, "a number of intervals, or 0 for the usual one"),
                         following.problem());
}

}  // namespace stickslip
