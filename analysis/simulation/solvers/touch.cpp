// Events that a solver cannot see because it looks at the ends of its steps: what meets zero and comes back within one.
#include "analysis/simulation/solvers/motion.h"

#include "analysis/numerics/hermite.h"
#include "analysis/numerics/root.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace stickslip {
namespace {

constexpr double may_touch = 1;        ///< an event value that is larger at both ends of a step does not vanish between
constexpr double slope_share = 1e-3;   ///< of a step, over which the slope of an event at its ends is measured
constexpr double touch_width = 1e-12;  ///< of a step, to which the instant of a touch is located

}  // namespace

std::optional<SlidingMotion::Touch> SlidingMotion::touched(double from, const FlowVector& before) const
{
    const double to = stepper_->time(), h = to - from;
    using Values = std::array<double, max_events>;
    const auto values = [&](const FlowVector& y) {
        Values v{};
        events_.values(y, v.data());
        return v;
    };
    const Values first = values(before), last = values(y_);
    std::optional<Touch> earliest;
    std::optional<Values> after_first, before_last;
    for (int i = rest; i < events_.count; ++i) {
        const auto k = static_cast<std::size_t>(i);
        if (!(first[k] * last[k] > 0 && std::min(std::abs(first[k]), std::abs(last[k])) < may_touch)) continue;
        if (!after_first) {
            after_first = values(stepper_->at(from + slope_share * h));
            before_last = values(stepper_->at(to - slope_share * h));
        }
        const double s0 = ((*after_first)[k] - first[k]) / (slope_share * h);
        const double s1 = (last[k] - (*before_last)[k]) / (slope_share * h);
        if (!(s0 * first[k] < 0)) continue;
        const auto xi = hermite_turning(first[k], last[k], s0, s1, h);
        const auto value_at = [&](double t) { return values(stepper_->at(t))[k]; };
        if (!xi || value_at(from + *xi * h) * first[k] > 0) continue;
        const double turning = from + *xi * h;
        const auto root =
            bracketed_root(value_at, from, first[k], turning, value_at(turning), 0, touch_width * (turning - from));
        if (!earliest || root.high < earliest->time) earliest = {i, root.high};
    }
    return earliest;
}

}  // namespace stickslip
