// How a motion comes to rest, sticks and breaks away.
#include "analysis/simulation/solvers/motion.h"

#include "analysis/simulation/flows/break_away.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

/// A solver whose tolerance of V outweighs the first acceleration of a mass that breaks away puts it back to rest: each
/// such bounce lets the spring wind up by so much more before the next try.
constexpr double excess_growth = 4, largest_excess = 1e-6;

constexpr int most_idle_switches = 100;  ///< of bodies that stop and go without time moving on

/// Speed from which a solver resolves a singular friction, in units of V_0 times its tolerance, and at most of V_0:
/// less than near_rest.
constexpr double resolved = 1e4, largest_launch = 1e-3;
static_assert(largest_launch < near_rest);

}  // namespace

void SlidingMotion::begin_slide(Branch branch)
{
    stuck_ = false;
    mutable_flow_->branch = branch;
    y_[1] = 0;
    const double speed = mutable_flow_->V0 * std::min(resolved * rtol_, largest_launch);
    const double V = branch == Branch::forward ? speed : -speed;
    if (const auto launch = break_away(*mutable_flow_, y_, V)) {
        t_ += launch->time;
        rest_time_ += launch->time;
        y_[0] = launch->x;
        y_[1] = V;
    }
    restart();
}

void SlidingMotion::arrive_at_rest()
{
    ++rests_;
    y_[1] = 0;
    if (++bounces_ > 1) release_excess_ = std::min(largest_excess, release_excess_ * excess_growth);
    const double needed = mutable_flow_->holding_force(y_[0]);
    if (std::abs(needed) < mutable_flow_->release_force(y_[0], release_excess_)) {
        stuck_ = true;
        ++sticks_;
    } else {
        begin_slide(needed > 0 ? Branch::forward : Branch::reverse);
    }
}

/// Sticking: x falls at V_0, so the force needed changes at k_p V_0 until it overcomes the static friction of one side.
bool SlidingMotion::stick(double t_end)
{
    const double needed = mutable_flow_->holding_force(y_[0]),
                 limit = mutable_flow_->release_force(y_[0], release_excess_);
    const double rise = mutable_flow_->k_p * mutable_flow_->V0;
    const double wait = rise > 0 ? (limit - needed) / rise : rise < 0 ? (-limit - needed) / rise : infinity;
    if (!(std::isfinite(wait)) && !std::isfinite(t_end)) return false;
    const double until = std::min(t_end, t_ + wait);
    y_[0] -= mutable_flow_->V0 * (until - t_);
    rest_time_ += until - t_;
    t_ = until;
    if (until < t_end) {
        release_position_ = y_[0];
        begin_slide(rise > 0 ? Branch::forward : Branch::reverse);
    }
    return true;
}

/// False where bodies stop and go for ever at one instant.
bool SlidingMotion::pass_switch(int which)
{
    switching_->pass(which, y_);
    if (switching_->anything_rests()) ++sticks_;
    restart();
    return ++idle_switches_ < most_idle_switches;
}

}  // namespace stickslip
