// Shortcuts of a motion that is followed: its cycle by shooting, and scaled amplitudes where it creeps.
#include "analysis/simulation/attractor/follower.h"

#include "analysis/simulation/attractor/orbit.h"
#include "analysis/simulation/attractor/repeats.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

/// Contraction of a turn, 1 − |μ|, that the variational equations of shooting resolve.
constexpr double clear_contraction = 1e-5;

constexpr double fine_rtol = 1e-12;  ///< to which a turn is followed that changes little

}  // namespace

/// Shooting continues the branch on which a body slides through its V = 0, where the body may stick: there a cycle is
/// accepted only if the motion itself goes around it without a stop.
bool Follower::makes_turn(const Cycle& cycle) const
{
    if (!may_rest()) return true;
    SlidingMotion motion(flow_, options_.solver, options_.rtol);
    motion.start(cycle.start);
    const Turn turn = motion.turn(2 * cycle.period);
    return turn.end == Turn::End::crossing && smooth(turn) && std::abs(turn.period() / cycle.period - 1) < alike;
}

bool Follower::Aim::taken_at(int turn)
{
    if (turn < next) return false;
    next = turn + wait;
    wait = std::min(2 * wait, longest_wait);
    return true;
}

bool Follower::shoot(const FlowVector& guess)
{
    if (!one_turn_.taken_at(result_.turns)) return false;
    CycleOptions options;
    options.rtol = fine_ ? 1e-11 : std::min(1e-9, options_.rtol);
    const auto cycle = find_cycle(flow_, guess, options);
    if (!cycle || !cycle->attracts() || std::abs(cycle->multipliers[0]) > 1 - clear_contraction) return false;
    const double size = distance(cycle->start, steady_);
    if (distance(cycle->start, guess) > 0.5 * size) return false;  // another orbit than the one at hand
    if (!makes_turn(*cycle)) return false;
    result_.take(*cycle);
    return true;
}

void Follower::start_anew(const FlowVector& y)
{
    motion_->start(y, motion_->time());
    points_.clear();
    turns_.clear();
    last_growth_ = missing;
    quiet_turns_ = 0;
}

/// Where a turn changes little, what a multistep method adds or takes by its errors decides; a one-step method at the
/// limit of doubles goes on from here.
void Follower::refine()
{
    fine_ = true;
    const double now = motion_->time();
    motion_ = std::make_unique<SlidingMotion>(flow_, Solver::rodas5p, fine_rtol);
    motion_->start(points_.back(), now);
    start_anew(FlowVector(points_.back()));
    creep_ = {};
}

/// Scales the amplitude of a creeping motion towards where its growth changes sign; true when that found the cycle.
bool Follower::jump(double growth)
{
    const FlowVector y = points_.back();
    const double size = amplitude(), ahead = amplitude_ahead(size, growth, last_growth_);
    const auto scaled = [&](double to) { return FlowVector(steady_ + to / size * (y - steady_)); };
    creep_.note(size, growth);
    if (creep_.located(size, growth)) {
        from_turn(turns_.back());
        result_.path = DecisionPath::shooting;
        return true;
    }
    if (is_set(ahead) && shoot(scaled(ahead))) return true;
    if (creep_.bracketed() && shoot(scaled(creep_.middle()))) return true;
    start_anew(scaled(creep_.next(size, growth, ahead)));
    return false;
}

/// Beside a period doubling turns come back long before it is clear after how many: the orbit that attracts decides.
bool Follower::shoot_repeat(int watched_turns)
{
    if (!several_turns_.taken_at(result_.turns)) return false;
    const double rtol = std::min(1e-9, options_.rtol);
    const auto orbit = attracting_orbit(flow_, points_.back(), watched_turns, rtol, alike * amplitude(), options_.work);
    if (!orbit) return false;
    result_.take(orbit->cycle);
    result_.repeats = full_turns(turns_, std::min(orbit->turns, static_cast<int>(turns_.size())));
    return true;
}

}  // namespace stickslip
