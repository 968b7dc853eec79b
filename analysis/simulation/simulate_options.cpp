#include "analysis/base/require_valid.h"
#include "analysis/simulation/simulate.h"

#include <cmath>

namespace stickslip {

std::string SimulateOptions::problem() const
{
    const auto unset_or_positive = [](double seconds) {
        return std::isnan(seconds) || (seconds > 0 && std::isfinite(seconds));
    };
    constexpr const char* time = "a time above 0, or NaN where it is not set";
    return first_problem(
        tolerance_problem(rtol), problem_unless(unset_or_positive(duration), "duration", duration, time),
        problem_unless(unset_or_positive(cycle_period), "cycle_period", cycle_period, time),
        problem_unless(force.value.empty() || force.step > 0, "force.step", force.step, "a time above 0"),
        problem_unless(normal_load.value.empty() || normal_load.step > 0, "normal_load.step", normal_load.step,
                       "a time above 0"));
}

}  // namespace stickslip
