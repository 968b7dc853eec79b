#include "analysis/simulation/set_point/hunting_search.h"

#include "analysis/base/work_limits.h"
#include "analysis/numerics/root.h"
#include "analysis/simulation/set_point/start_search.h"

#include <utility>

namespace stickslip {
namespace {

constexpr int decades_below = 6;
constexpr double precision = 1e-10;
constexpr double jump = 1e-6;  ///< a fixed point left by more than this share is a jump of the map, not a cycle

/// ln of the next stop's distance per that of this one: 0 at a symmetric cycle. NaN where no slip follows.
double growth(const Stop& stop, double a)
{
    if (stop.end == Stop::End::settled) return short_of_it;
    if (stop.end == Stop::End::runaway) return -short_of_it;
    if (stop.end != Stop::End::stop) return missing;
    return growth_of_distance(stop.x, a);
}

/// The slip from x, on either side, and what is known of those after it.
SlipEnd slip_end(const StopToStop& motion, double x)
{
    const auto stop = motion.slip_from(std::abs(x));
    switch (stop.end) {
        case Stop::End::stop:
            return {stop.x, stop.stick_time < infinity ? std::optional<StartEnd>() : StartEnd::rests};
        case Stop::End::settled:
        case Stop::End::held:
            return {stop.x, StartEnd::rests};
        case Stop::End::runaway:
            return {stop.x, StartEnd::diverges};
        case Stop::End::failure:
            break;
    }
    return {stop.x, StartEnd::undecided};
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

SetPoint hunting_by_events(const StopToStop& motion, double natural, double dead_zone, const StartSearch& search)
{
    const double least = motion.least_start();
    if (least == infinity) {
        SetPoint none;
        none.method = SetPointMethod::event_driven;
        none.hunting = Hunting::no;
        none.reason = SetPointReason::held;
        none.rest_error = infinity;
        return none;
    }
    // stops lie beyond the least start by distances of the order of the slips, however wide a dead zone is
    const Starts starts(least, std::max(natural * std::pow(10, -decades_below), least * precision), natural,
                        search.per_decade);
    auto none = no_cycle(starts, dead_zone, SetPointMethod::event_driven);
    const auto at = [&](double v) { return growth(motion.slip_from(v), v); };
    double outer = missing, f_outer = missing;
    bool grows = false;
    const auto judged = [&](double a, double f) -> std::optional<SetPoint> {
        const double from = std::exchange(outer, a), f_from = std::exchange(f_outer, f);
        grows = grows || (f > 0 && std::isnan(from));
        if (!(f > 0 && f_from <= 0)) return {};
        const double found = bracketed_root(at, a, f, from, f_from, precision).value;
        SetPoint s = cycle_at(motion, found);
        s.method = SetPointMethod::event_driven;
        if (std::abs(at(found)) < jump && std::abs(s.multiplier) < 1) return s;
        if (const double swing = followed(motion, from); swing > 0 && swing < infinity) {
            s.asymmetric = true;
            s.amplitude = swing;
            s.slip_time = s.stick_time = s.period = s.multiplier = missing;
            return s;
        }
        return {};  // a cycle may lie further in
    };
    const auto slip_from = [&](double a) {
        const auto stop = motion.slip_from(a);
        return TriedStart{growth(stop, a), stop.end == Stop::End::failure};
    };
    none.starts = starts.last + 1;
    const auto searched = search_starts(starts, slip_from, judged);
    auto s = searched.answer ? *searched.answer : no_cycle_found(none, searched);
    if (search.unstable || (grows && s.hunting == Hunting::no))
        s.reason = SetPointReason::loop_unstable, s.rest_error = missing;
    else if (s.hunting != Hunting::yes)
        return s;
    return with_ends(s, starts, -1, search, [&](double x) { return slip_end(motion, x); });
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
