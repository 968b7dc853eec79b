#include "analysis/simulation/set_point/sampled_hunting.h"

#include "analysis/simulation/set_point/start_search.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace stickslip {
namespace {

using End = SampledStop::End;

constexpr double decades_below = 3;
constexpr int watched = 20, most_watched = 20;  ///< stops that are compared, and how often
constexpr double even = 0.01;                   ///< by which they may differ, per the largest: ticks account for it
constexpr double shrinks = 0.8;  ///< to what share of itself this difference goes down while the cycle is approached

/// ln of the next stop's distance per that of this one; NaN where no slip follows.
double growth(const SampledStop& stop, double x)
{
    if (stop.end == End::settled) return short_of_it;
    if (stop.end == End::moves) return std::log(stop.x / std::abs(x));
    if (stop.end == End::runaway) return -short_of_it;
    if (stop.end != End::stop) return missing;
    return growth_of_distance(x < 0 ? stop.x : -stop.x, std::abs(x));
}

double mean(const std::vector<double>& v)
{
    return std::accumulate(v.begin(), v.end(), 0.0) / static_cast<double>(v.size());
}

/// From stop to stop: the cycle that they come to, `no` where they end, undecided where one was not followed.
SetPoint followed(const SampledStops& motion, double x)
{
    SetPoint s;
    s.method = SetPointMethod::simulated;
    s.hunting = Hunting::yes;
    s.reason = SetPointReason::falling_friction;
    std::vector<double> distance, slip, stick;
    double spread = infinity;
    for (int i = 0; i < watched * most_watched; ++i) {
        const auto stop = motion.slip_from(x);
        if (stop.end == End::moves) {
            s.reason = SetPointReason::driven_cycle;
            s.amplitude = stop.x;
            return s;
        }
        if (stop.end == End::runaway) return s.hunting = Hunting::no, s.reason = SetPointReason::loop_unstable, s;
        if (stop.end == End::failure)
            return s.hunting = Hunting::undecided, s.reason = SetPointReason::not_converged, s;
        if (stop.end != End::stop || !(stop.stick_time < infinity)) return s.hunting = Hunting::no, s;
        x = stop.x;
        if (i % watched == 0) distance.clear(), slip.clear(), stick.clear();
        distance.push_back(std::abs(x));
        slip.push_back(stop.slip_time);
        stick.push_back(stop.stick_time);
        if (i % watched != watched - 1) continue;
        const auto [least, most] = std::minmax_element(distance.begin(), distance.end());
        const double before = std::exchange(spread, (*most - *least) / *most);
        s.amplitude = *most;
        if (spread <= even || spread > shrinks * before) break;
    }
    s.asymmetric = spread > even;
    if (s.asymmetric) return s;
    s.amplitude = mean(distance);
    s.slip_time = mean(slip), s.stick_time = mean(stick);
    s.period = 2 * (s.slip_time + s.stick_time);
    return s;
}

/// The slip from x and what is known of those after it.
SlipEnd slip_end(const SampledStops& motion, double x)
{
    const auto stop = motion.slip_from(x);
    switch (stop.end) {
        case End::stop:
            return {stop.x, stop.stick_time < infinity ? std::optional<StartEnd>() : StartEnd::rests};
        case End::settled:
        case End::held:
            return {stop.x, StartEnd::rests};
        case End::moves:
            return {stop.x, StartEnd::hunts};
        case End::runaway:
            return {stop.x, StartEnd::diverges};
        case End::failure:
            break;
    }
    return {stop.x, StartEnd::undecided};
}

/// What starts on one side of the set point come to.
SetPoint hunting_from(const SampledStops& motion, double side, double natural, const StartSearch& search)
{
    const double least = std::max(motion.least_start(side), motion.least_start(-side));
    const Starts starts(least, natural * std::pow(10, -decades_below), natural, search.per_decade);
    auto none = no_cycle(starts, motion.unseen(), SetPointMethod::simulated);
    double outer = missing;  // the nearest start so far whose slips shrink
    bool any = false, grows = false, held_beyond = false;
    const auto slip_from = [&](double distance) {
        const double x = side * distance;
        const auto stop = motion.slip_from(x);
        ++none.starts;
        any = any || stop.end != End::held;
        held_beyond = held_beyond || (stop.end == End::held && std::isnan(outer));
        return TriedStart{growth(stop, x), stop.end == End::failure};
    };
    const auto judged = [&](double distance, double f) -> std::optional<SetPoint> {
        if (f <= 0) {
            if (std::isnan(outer)) none.searched_to = distance;
            outer = distance;
        }
        // from so far away: limits let it wind up, or its cycle lies still further
        if (f > 0 && std::isnan(outer)) grows = true;
        if (!(f > 0) || std::isnan(outer)) return {};
        auto s = followed(motion, side * outer);
        // a jump of the map lies between the two
        if (s.hunting == Hunting::no && !s.diverges()) s = followed(motion, side * distance);
        outer = distance;
        if (s.hunting == Hunting::no) return {};  // a cycle may lie further in
        return s;
    };
    const auto searched = search_starts(starts, slip_from, judged);
    const auto with_followed = [&](const SetPoint& s) {
        return with_ends(s, starts, side, search, [&](double x) { return slip_end(motion, x); });
    };
    auto s = searched.answer ? *searched.answer : no_cycle_found(none, searched);
    const bool diverges = search.unstable || (std::isnan(outer) && grows && !held_beyond);
    if (diverges && s.hunting != Hunting::undecided) s.reason = SetPointReason::loop_unstable, s.rest_error = missing;
    if (diverges || searched.answer) return with_followed(s);
    if (!any || (std::isnan(outer) && grows)) {
        none.reason = SetPointReason::held, none.rest_error = infinity;
        return none;
    }
    return s;
}

}  // namespace

SetPoint hunting_by_simulation(const SampledStops& motion, double natural, const StartSearch& search)
{
    const auto before = hunting_from(motion, -1, natural, search);
    if (!motion.one_sided() || before.hunting == Hunting::yes) return before;
    const auto behind = hunting_from(motion, 1, natural, search);
    if (behind.hunting == Hunting::yes || before.hunting == Hunting::no) return behind;
    return before;
}

SetPoint resting_by_simulation(const SampledStops& motion)
{
    constexpr double starts[] = {1.1, 3, 10, 30, 100};  // of the band
    const double band = std::max(motion.band(1), motion.band(-1));
    SetPoint s;
    s.method = SetPointMethod::simulated;
    s.hunting = Hunting::no;
    s.reason = SetPointReason::no_integral_action;
    s.rest_error = band;
    s.searched_from = starts[0] * band, s.searched_to = *std::rbegin(starts) * band;
    for (const double side : {-1.0, 1.0})
        for (const double share : starts) {
            const auto stop = motion.release_from(side * share * band);
            ++s.starts;
            if (stop.end == End::stop || stop.end == End::settled || stop.end == End::held) continue;
            s.rest_error = missing;
            s.hunting = Hunting::undecided, s.reason = SetPointReason::not_converged;
            if (stop.end == End::runaway) s.hunting = Hunting::no, s.reason = SetPointReason::loop_unstable;
            if (stop.end == End::moves) {
                s.hunting = Hunting::yes, s.reason = SetPointReason::driven_cycle;
                s.amplitude = stop.x;
                s.rests_nearby = true;
            }
            return s;
        }
    return s;
}

}  // namespace stickslip
