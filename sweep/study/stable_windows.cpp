#include "sweep/study/stable_windows.h"

#include "analysis/joint/gains.h"
#include "analysis/joint/loop_side.h"
#include "analysis/stability/verdict.h"
#include "sweep/study/samples.h"

#include <algorithm>
#include <cmath>
#include <exception>

namespace stickslip {
namespace {

/// `given`: a cascade has k_p only as part of its sum of gains. `there`: the same, commanded and in joint coordinates.
StableWindows windows_of(const Joint& given, const Joint& there)
{
    StableWindows w;
    try {
        const auto verdict = linear_verdict(there);
        const double unit = given.control.k_p > 0 ? there.control.k_p / given.control.k_p : 1;
        w.V0 = there.control.V0;
        w.k_v_min = verdict.velocity_only.k_v_min / unit;
        w.stable = verdict.state_variable.stable;
        w.spectral_abscissa = verdict.state_variable.spectral_abscissa;
        w.k_cr = verdict.state_variable.k_cr / unit;
        for (const auto& i : verdict.state_variable.stable_intervals) w.k_p.push_back({i.low / unit, i.high / unit});
    } catch (const std::exception& e) {
        w.refused = e.what();
    }
    return w;
}

void add_ends(const StableWindows& w, double own_gain, WindowEnds& ends)
{
    const auto own = std::find_if(w.k_p.begin(), w.k_p.end(),
                                  [&](const Interval& i) { return i.low < own_gain && own_gain < i.high; });
    const auto shown = own != w.k_p.end() ? own : w.k_p.begin();
    const bool none = !w.known() || w.k_p.empty();
    ends.low.push_back(none || !(shown->low > 0) ? missing : shown->low);
    ends.high.push_back(none || !std::isfinite(shown->high) ? missing : shown->high);
}

}  // namespace

Joint acting_at(const Joint& joint, double velocity)
{
    Joint there = with_loop_at_joint(with_gains(joint));
    there.control.V0 = velocity;
    there.control.force_rate = not_set;
    return there;
}

StableWindows stable_windows(const Joint& joint, double velocity)
{
    return windows_of(with_gains(joint), acting_at(joint, velocity));
}

double reported_velocity(const Joint& joint, double usual_speed)
{
    constexpr double slow_part = 0.1;  // where stick-slip is to be feared
    return is_set(joint.control.V0) ? joint.control.V0 : slow_part * usual_speed;
}

StableWindows own_windows(const Joint& joint, double usual_speed)
{
    const Joint given = with_gains(joint);
    Joint there = with_loop_at_joint(given);
    if (!is_set(there.control.force_rate)) there.control.V0 = reported_velocity(joint, usual_speed);
    return windows_of(given, there);
}

MovedBoundary moved_boundary(const Joint& before, const Joint& after, double velocity)
{
    MovedBoundary moved;
    if (!(std::abs(velocity) > 0) || !std::isfinite(velocity)) return moved;
    moved.velocity = velocity;
    moved.own_gain = gains_of(before.control).k_p;
    moved.at = {stable_windows(before, velocity), stable_windows(after, velocity)};
    moved.speeds = log_steps(0.01 * std::abs(velocity), 2 * std::abs(velocity), 41);
    for (const double speed : moved.speeds) {
        const double V = std::copysign(speed, velocity);
        add_ends(stable_windows(before, V), moved.own_gain, moved.before);
        add_ends(stable_windows(after, V), gains_of(after.control).k_p, moved.after);
    }
    return moved;
}

}  // namespace stickslip
