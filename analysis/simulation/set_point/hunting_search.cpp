#include "analysis/simulation/set_point/hunting_search.h"

#include "analysis/base/work_limits.h"
#include "analysis/numerics/root.h"

namespace stickslip {
namespace {

constexpr int decades_below = 6, decades_above = 2;
constexpr double precision = 1e-10;
constexpr double jump = 1e-6;  ///< a fixed point left by more than this share is a jump of the map, not a cycle

constexpr double short_of_it = -50;  ///< of a slip that does not cross the set point: less than any that does

/// ln of the next stop's distance per that of this one: 0 at a symmetric cycle. NaN where no slip follows.
double growth(const Stop& stop, double a)
{
    if (stop.end == Stop::End::settled) return short_of_it;
    if (stop.end != Stop::End::stop) return missing;
    return stop.x > 0 ? std::max(std::log(stop.x / a), short_of_it) : short_of_it;
}

/// Goes from stop to stop for some time; the largest distance of the last stops where they go on, 0 where they end.
double followed(const StopToStop& motion, double a)
{
    constexpr int transient = 300, watched = 60;
    double largest = 0;
    for (int i = 0; i < transient + watched; ++i) {
        const auto stop = motion.slip_from(a);
        if (stop.end != Stop::End::stop) return stop.end == Stop::End::runaway ? infinity : 0;
        a = std::abs(stop.x);
        if (!(stop.stick_time < infinity)) return 0;
        if (i >= transient) largest = std::max(largest, a);
    }
    return largest;
}

SetPoint cycle_at(const StopToStop& motion, double a)
{
    SetPoint s;
    const auto stop = motion.slip_from(a);
    const double step = 1e-4 * a;
    s.hunting = Hunting::yes;
    s.reason = SetPointReason::falling_friction;
    s.amplitude = a;
    s.slip_time = stop.slip_time;
    s.stick_time = stop.stick_time;
    s.period = 2 * (stop.slip_time + stop.stick_time);
    s.multiplier = (motion.slip_from(a + step).x - motion.slip_from(a - step).x) / (2 * step);
    return s;
}

}  // namespace

SetPoint hunting_by_events(const StopToStop& motion, double natural, double dead_zone, int per_decade)
{
    SetPoint none;
    none.method = SetPointMethod::event_driven;
    none.hunting = Hunting::no;
    const double least = motion.least_start();
    if (least == infinity) {
        none.reason = SetPointReason::held;
        none.rest_error = infinity;
        return none;
    }
    // stops lie beyond the least start by distances of the order of the slips, however wide a dead zone is
    const double low = std::max(natural * std::pow(10, -decades_below), least * precision);
    const double high = std::max(natural, least) * std::pow(10, decades_above);
    const int n = static_cast<int>(std::ceil(per_decade * std::log10(high / low)));
    none.reason = least > dead_zone ? SetPointReason::held
                  : dead_zone > 0   ? SetPointReason::dead_zone
                                    : SetPointReason::slips_shrink;
    none.rest_error = std::max(least, 0.0);
    none.searched_from = least + low, none.searched_to = least + high;
    none.starts = n + 1;
    double largest = -infinity;
    bool all_followed = true;
    const auto grown = [&](double a) {
        const auto stop = motion.slip_from(a);
        all_followed = all_followed && stop.end != Stop::End::failure;
        return growth(stop, a);
    };
    double outer = least + high, f_outer = grown(outer);
    if (f_outer > 0) return none.reason = SetPointReason::loop_unstable, none;
    for (int i = n - 1; i >= 0; --i) {
        const double a = least + low * std::pow(high / low, static_cast<double>(i) / n);
        const double f = grown(a);
        largest = std::max({largest, f, f_outer});
        if (f > 0 && f_outer <= 0) {
            const auto at = [&](double v) { return growth(motion.slip_from(v), v); };
            const double found = bracketed_root(at, a, f, outer, f_outer, precision).value;
            SetPoint s = cycle_at(motion, found);
            s.method = SetPointMethod::event_driven;
            s.rests_nearby = none.rest_error > 0;
            if (std::abs(at(found)) < jump && std::abs(s.multiplier) < 1) return s;
            if (const double swing = followed(motion, outer); swing > 0 && swing < infinity) {
                s.asymmetric = true;
                s.amplitude = swing;
                s.slip_time = s.stick_time = s.period = s.multiplier = missing;
                return s;
            }
            return none;
        }
        outer = a, f_outer = f;
    }
    // a slip of unknown end may be one of a cycle
    if (!all_followed) none.hunting = Hunting::undecided, none.reason = SetPointReason::not_converged;
    none.largest_ratio = std::exp(largest);
    return none;
}

SetPoint hunting_without_integral(const StopToStop& motion, double band)
{
    constexpr double far_away = 100, same = 1e-9;
    SetPoint s;
    s.method = SetPointMethod::event_driven;
    s.searched_from = band, s.searched_to = far_away * band;
    s.starts = 1;
    double a = far_away * band;
    for (int i = 0; i < work::slips_to_stop; ++i) {
        const auto stop = motion.release_from(a);
        if (stop.end == Stop::End::failure) break;
        const bool on = stop.end == Stop::End::stop && std::abs(stop.x) > band;
        if (stop.end == Stop::End::runaway || (on && std::abs(stop.x) > s.searched_to)) {
            s.hunting = Hunting::no;
            return s.reason = SetPointReason::loop_unstable, s;
        }
        if (!on) {
            s.hunting = Hunting::no;
            s.reason = SetPointReason::not_driven;
            return s.rest_error = band, s;
        }
        const double next = std::abs(stop.x), change = std::abs(next - a);
        a = next;
        if (change > same * a) continue;
        s.hunting = Hunting::yes;
        s.reason = SetPointReason::driven_by_velocity;
        s.amplitude = a;
        s.slip_time = stop.slip_time;
        s.stick_time = 0;
        s.period = 2 * stop.slip_time;
        const double step = 1e-4 * a;
        s.multiplier = (motion.release_from(a + step).x - motion.release_from(a).x) / step;
        s.rests_nearby = true;
        return s;
    }
    s.reason = SetPointReason::not_converged;
    return s;
}

}  // namespace stickslip
