#include "sweep/study/corrected_gains.h"

#include "analysis/diagnosis/diagnose.h"
#include "analysis/joint/gains.h"
#include "analysis/loop/loop_use.h"
#include "analysis/simulation/simulate.h"
#include "sweep/study/stable_windows.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <numbers>

namespace stickslip {
namespace {

/// What the search takes where the joint file states no noise and no sample time. The gains of least noise are the same
/// for any size of it.
constexpr double assumed_noise = 1e-9, assumed_period = 1e-3;  // m or rad, s

constexpr double beside = 3;  ///< how far a chart reaches beyond the outermost gain that it is about, as a factor

void take(Interval& range, double value)
{
    if (!(value > 0) || !std::isfinite(value)) return;
    range = {std::fmin(range.low, value), std::fmax(range.high, value)};
}

void take_windows(Interval& range, const Joint& joint, double velocity, double per_drive)
{
    for (const auto& i : stable_windows(joint, velocity).k_p)
        take(range, i.low * per_drive), take(range, i.high * per_drive);
}

/// Half the greatest stable k_p, where the joint's own is more; not set where no such end is known.
double lower_stiffness(const CorrectedGains& found, const Interval& ends)
{
    constexpr double of_the_end = 0.5;  // 6 dB
    const double low = of_the_end * ends.high;
    return low < found.k_p ? low : not_set;
}

/// Least noise of the link in this joint, as stiff as the joint's own k_p makes it, or where no gains are, as stiff as
/// the window `ends` leaves room for: without a floor friction that only damps would ask for no stiffness at all. What
/// the file leaves open is assumed.
void look_for_gains(CorrectedGains& found, const Joint& joint, const Interval& ends, const ParallelFor& parallel)
{
    auto& r = found.required = requirements_of(joint);
    found.noise_is_stated = r.noise.position > 0, found.rate_is_stated = r.noise.period > 0;
    if (!found.noise_is_stated) r.noise.position = assumed_noise;
    if (!found.rate_is_stated) r.noise.period = assumed_period;
    r.front_points = 2;  // the page shows no front
    try {
        for (const double floor : {found.k_p, lower_stiffness(found, ends), not_set}) {
            if (floor > ends.high) continue;  // known to be too stiff, and a search that finds nothing is a long one
            r.k_p_low = floor > 0 ? floor : not_set;
            found.right = design_gains(joint, r, parallel);
            if (found.right->feasible || !found.right->decided || !(floor > 0)) break;
        }
    } catch (const gap::Interrupted&) {
        found.none = NoGains::interrupted;
    } catch (const std::exception& e) {
        found.none = NoGains::refused;
        found.refusal = e.what();
    }
}

/// Long enough for two periods of what acts by position or time, where that is no more than `most`.
double duration_for(const Joint& joint, double velocity)
{
    constexpr double most = 60;  // s
    double longest = missing;
    const auto take_period = [&](bool acts, double rate) {
        const double period = 2 * std::numbers::pi / std::abs(rate);
        if (acts && period < most / 2) longest = std::fmax(longest, period);
    };
    const auto take_friction = [&](const auto& f) {
        take_period(f.ripple.acts(), f.ripple.periods * velocity);
        if (f.drift.change != 0 && f.drift.time_constant < most / 2)
            longest = std::fmax(longest, f.drift.time_constant);
    };
    const auto& load = joint.load;
    take_period(load.cogging.acts(), load.cogging.periods * velocity);
    take_period(load.disturbance.amplitude != 0, load.disturbance.frequency);
    take_friction(joint.friction), take_friction(joint.frictions.motor), take_friction(joint.frictions.link);
    return 2 * longest;
}

/// From steady sliding and the disturbance that `simulate` takes by default.
Trajectory motion_of(const Joint& joint, double duration)
{
    SimulateOptions options;
    auto motion = simulate(joint, options);
    if (motion.time.empty() || !(motion.time.back() < duration)) return motion;
    options.duration = duration;
    return simulate(joint, options);
}

void draw_charts(CorrectedGains& found, const Joint& before, const Joint& after, Interval k_p)
{
    Interval k_v{missing, missing};
    take(k_p, found.k_p), take(k_v, found.k_v);
    if (found.right) take(k_p, found.right->best.k_p), take(k_v, found.right->best.k_v);
    if (!(k_p.low > 0) || !(k_v.low > 0)) return;
    k_p = {k_p.low / beside, k_p.high * beside}, k_v = {k_v.low / beside, k_v.high * beside};
    found.before = gain_chart_over(before, k_p, k_v);
    found.after = gain_chart_over(after, k_p, k_v);
    if (!found.after || !found.right) return;
    Joint right = after;
    right.control.k_p = found.right->best.k_p, right.control.k_v = found.right->best.k_v;
    found.at_right = design_point(right, found.after->slice);
}

}  // namespace

SettledMotion settled(const Trajectory& motion)
{
    SettledMotion settled;
    settled.reason = motion.reason;
    if (motion.time.empty()) return settled;
    const double end = motion.time.back(), from = 2 * end / 3;
    double rest = 0;
    for (std::size_t i = 0; i < motion.time.size(); ++i) {
        if (motion.time[i] < from) continue;
        settled.low = std::fmin(settled.low, motion.velocity[i]);
        settled.high = std::fmax(settled.high, motion.velocity[i]);
        if (motion.stuck[i] && i + 1 < motion.time.size()) rest += motion.time[i + 1] - motion.time[i];
    }
    settled.rest_share = rest / (end - from);
    return settled;
}

CorrectedGains corrected_gains(const Joint& before, const Joint& after, double velocity, const ParallelFor& parallel)
{
    CorrectedGains found;
    if (!(std::abs(velocity) > 0) || !std::isfinite(velocity)) return found;
    found.velocity = velocity;
    const Joint documented = acting_at(before, velocity), corrected = acting_at(after, velocity);
    const auto own = gains_of(before.control);
    found.k_p = documented.control.k_p, found.k_v = documented.control.k_v;
    found.per_drive = own.k_p > 0 ? found.k_p / own.k_p : 1;
    const double duration = std::fmax(duration_for(documented, velocity), duration_for(corrected, velocity));
    found.motion_before = motion_of(documented, duration), found.motion_after = motion_of(corrected, duration);
    found.settled_before = settled(found.motion_before), found.settled_after = settled(found.motion_after);
    if (before.control.kind != ControlKind::position) {
        found.none = NoGains::force_control;
        return found;
    }
    Interval k_p{missing, missing};
    try {
        take_windows(k_p, after, velocity, found.per_drive);
        if (loop_kind(corrected) == LoopKind::continuous && corrected.control.delay > 0)
            found.none = NoGains::dead_time;
        else
            look_for_gains(found, corrected, k_p, parallel);
        take_windows(k_p, before, velocity, found.per_drive);
        draw_charts(found, documented, corrected, k_p);
    } catch (const std::exception&) {  // no such theory for this joint: the windows above say why
    }
    return found;
}

}  // namespace stickslip
