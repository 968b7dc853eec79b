// How a motion comes to rest, sticks and breaks away.
#include "analysis/simulation/solvers/motion.h"

#include "analysis/numerics/root.h"
#include "analysis/simulation/flows/break_away.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

/// A solver whose tolerance of V outweighs the first acceleration of a mass that breaks away puts it back to rest: each
/// such bounce lets the spring wind up by so much more before the next try.
constexpr double excess_growth = 4, largest_excess = 1e-6;

constexpr int most_doublings = 60;      ///< of the time until a contact that grows older is overcome
constexpr double release_time = 1e-14;  ///< of that time, to which it is found

constexpr int most_idle_switches = 100;  ///< of bodies that stop and go without time moving on

/// Speed from which a solver resolves a singular friction, in units of V_0 times its tolerance, and at most of V_0:
/// less than near_rest.
constexpr double resolved = 1e4, largest_launch = 1e-3;
static_assert(largest_launch < near_rest);

}  // namespace

void SlidingMotion::begin_slide(Branch branch)
{
    rest_.stuck = false;
    as_.sticking->branch = branch;
    y_[1] = 0;
    const double speed = as_.sticking->V0 * std::min(resolved * rtol_, largest_launch);
    const double V = branch == Branch::forward ? speed : -speed;
    const auto launch = as_.sticking->steep() ? std::nullopt : break_away(*as_.sticking, y_, V);
    if (launch) {
        t_ += launch->time;
        rest_.time += launch->time;
        y_[0] = launch->x;
        y_[1] = V;
    }
    restart();
}

void SlidingMotion::arrive_at_rest()
{
    ++rest_.rests;
    y_[1] = 0;
    if (++rest_.bounces > 1) rest_.release_excess = std::min(largest_excess, rest_.release_excess * excess_growth);
    const double needed = as_.sticking->holding_force(y_[0]);
    const auto side = needed > 0 ? Branch::forward : Branch::reverse;
    if (std::abs(needed) < as_.sticking->release_force(y_, side, rest_.release_excess)) {
        rest_.stuck = true;
        ++rest_.sticks;
    } else {
        begin_slide(side);
    }
}

/// y after so long a rest: x falls at V_0, and contacts may grow older.
FlowVector SlidingMotion::after_rest(double time) const
{
    FlowVector y = y_;
    y[0] -= as_.sticking->V0 * time;
    if (!as_.sticking->steep()) return y;
    const States theta = rested(as_.sticking->friction, as_.sticking->states_of(y_), time);
    for (int i = 0; i < as_.sticking->states; ++i) y[2 + i] = theta[i];
    return y;
}

/// How long the mass sticks: the force needed to hold it changes at k_p V_0 until it overcomes the static friction of
/// one side. A contact that grows older holds longer, as its strength rises with the logarithm of time.
double SlidingMotion::rest_duration() const
{
    const double rise = as_.sticking->k_p * as_.sticking->V0;
    if (rise == 0) return infinity;
    const auto side = rise > 0 ? Branch::forward : Branch::reverse;
    const double sign = rise > 0 ? 1 : -1;
    const auto surplus = [&](const FlowVector& y) {
        return sign * as_.sticking->holding_force(y[0]) - as_.sticking->release_force(y, side, rest_.release_excess);
    };
    const auto surplus_after = [&](double time) { return surplus(after_rest(time)); };
    const double at_once = -surplus(y_) / std::abs(rise);  // of a strength that stays
    if (!as_.sticking->steep()) return at_once;
    const double first = surplus_after(at_once);
    double longest = at_once, left = first;
    for (int k = 0; left < 0 && k < most_doublings; ++k) left = surplus_after(longest *= 2);
    if (left < 0) return infinity;
    return bracketed_root(surplus_after, at_once, first, longest, left, release_time).high;
}

bool SlidingMotion::stick(double t_end)
{
    const double wait = rest_duration();
    if (!(std::isfinite(wait)) && !std::isfinite(t_end)) return false;
    const double until = std::min(t_end, t_ + wait);
    y_ = after_rest(until - t_);
    rest_.time += until - t_;
    t_ = until;
    if (until < t_end) {
        rest_.released_at = y_[0];
        begin_slide(as_.sticking->k_p > 0 ? Branch::forward : Branch::reverse);
    }
    return true;
}

/// False where bodies stop and go for ever at one instant.
bool SlidingMotion::pass_switch(int which)
{
    as_.switching->pass(which, y_);
    if (as_.switching->anything_rests()) ++rest_.sticks;
    restart();
    return ++effort_.idle_switches < most_idle_switches;
}

}  // namespace stickslip
