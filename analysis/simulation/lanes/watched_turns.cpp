// What the turns that a lane has watched tell: a decay, a motion that closes in, one that never comes back.
#include "analysis/simulation/lanes/watched_turns.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stickslip::lanes {
namespace {

constexpr std::size_t kept_turns = 2 * longest_repeat + 2;
constexpr double reversal = 1e-6;            ///< share of V_0, as of a turn that the reference measures
constexpr double weak_swing = 0.6;           ///< of w, up to which a motion counts as weakly nonlinear
constexpr double by_the_linear_rate = 0.02;  ///< relative difference of growths
constexpr int linear_turns = 20;             ///< in succession at that rate: the rest of the decay is known

/// Gaps of successive turns that point the same way and shrink by one ratio tell where they end. A leap is no longer
/// than `near_cycle`, the ratio has to be known better than what it leaves of the distance.
constexpr double least_ratio = 0.3, parallel = 0.05, known_ratio = 0.05;
constexpr int turns_between_leaps = 4;
constexpr double hardly_changed = 1e-2;  ///< gap of two turns that creep, per amplitude
constexpr int wild_turns = 600;          ///< before a motion that neither closes nor settles is called irregular

}  // namespace

/// The newest turns are what the motion goes through for ever; otherwise all that is known of what never comes back.
Action WatchedProgram::goes_around(int turns, bool whole)
{
    const Turn all = merged(watched_->turns, turns);
    answer_.w_min = all.velocity_min, answer_.w_max = all.velocity_max;
    answer_.x_min = all.position_min, answer_.x_max = all.position_max;
    answer_.period = all.period();
    answer_.rest_time = all.rest_time;
    answer_.reached = phase_ != Phase::search;
    answer_.cycle = !whole                                   ? Outcome::irregular
                    : full_turns(watched_->turns, turns) > 1 ? Outcome::period_n
                    : speed_of(all.velocity_min) < -reversal ? Outcome::reversal
                    : all.rest_time > 0                      ? Outcome::stick_slip
                                                             : Outcome::limit_cycle;
    return finish(phase_ == Phase::cycle ? Ending::cycle : Ending::bistable);
}

/// The motion was watched for as long as any may be (`cut_short`: as much work was done). What the reference would say
/// of it, but for what creeps, of which it may find the end by other means.
Action WatchedProgram::out_of_patience(bool cut_short)
{
    if (phase_ != Phase::cycle) return give_up();
    const auto gap = [this](int i, int j) { return watched_->gap(i, j); };
    std::vector<double> sizes;
    for (const auto& turn : watched_->turns) sizes.push_back(norm(turn.state));
    if (!grows_and_shrinks(sizes)) return give_up();
    if (const int m = turns_to_repeat_nearly(watched_->count(), gap, sizes.back()); m > 0)
        return cut_short ? goes_around(m) : give_up();
    if (job_->groups.unknowns() <= 3) {
        answer_.x_max = watched_->first_peak;
        return finish(Ending::undecided);
    }
    return answer_.turns < wild_turns ? give_up() : goes_around(watched_->count(), false);
}

void WatchedProgram::note_turn(double period)
{
    auto& turns = watched_->turns;
    const FlowVector &start = watched_->start, &end = watched_->end;
    Turn turn;
    turn.t0 = turns.empty() ? 0 : turns.back().t1;
    turn.t1 = turn.t0 + period;
    turn.state = end;
    turn.velocity_min = answer_.w_min, turn.velocity_max = answer_.w_max;
    turn.position_min = answer_.x_min;
    turn.position_max = std::max(start[0], end[0]) * job_->scale[0];
    turn.rest_time = answer_.rest_time;
    turns.push_back(turn);
    if (turns.size() > kept_turns) turns.pop_front();
    ++answer_.turns, ++since_leap_;
    const int count = watched_->count();
    const bool alike = count > 1 && watched_->gap(count - 1, count - 2) < hardly_changed * norm(end);
    creeps_ = alike ? creeps_ + 1 : 0;
}

/// Whether the newest turn tells the rest of a decay: by its growth and that of turns before it.
bool WatchedProgram::decays_linearly()
{
    const Turn& turn = watched_->turns.back();
    const double size = norm(turn.state), before = norm(watched_->start), growth = std::log(size / before);
    if (size < settled_size) return true;
    const bool linear = std::abs(growth / (job_->rate * turn.period()) - 1) < by_the_linear_rate;
    linear_turns_ = linear ? linear_turns_ + 1 : 0;
    if (linear_turns_ >= linear_turns) return true;
    if (job_->groups.two_masses()) return false;  // two modes decay side by side, and no turn shows one alone
    const double per_turn = 2 * std::numbers::pi * job_->rate / job_->frequency;
    const double swing = std::max(answer_.w_max, -answer_.w_min);
    return swing < weak_swing && smaller_.none({before, 0}, {size, 0}, per_turn);
}

/// Takes a motion that closes in slowly to where it will end; false where that is not clear.
bool WatchedProgram::leap()
{
    const int last = watched_->count() - 1;
    if (since_leap_ < turns_between_leaps || last < 3) return false;
    const auto moved = [&](int i) { return FlowVector(watched_->point(i) - watched_->point(i - 1)); };
    const FlowVector newest = moved(last), before = moved(last - 1), first = moved(last - 2);
    const double ratio = newest.dot(before) / before.squaredNorm(), was = before.dot(first) / first.squaredNorm();
    const bool closes = std::abs(ratio) > least_ratio && ratio < uncertain_multiplier && ratio > -1 &&
                        std::abs(ratio - was) < known_ratio * std::min(std::abs(ratio), 1 - ratio);
    if (!closes || (newest - ratio * before).norm() > parallel * (1 - std::abs(ratio)) * newest.norm()) return false;
    const FlowVector step = ratio / (1 - ratio) * newest;
    if (step.norm() > near_cycle * watched_->end.norm()) return false;
    watched_->start = watched_->end + step;
    watched_->turns.clear();
    smaller_.forget();
    since_leap_ = linear_turns_ = 0;
    return true;
}

}  // namespace stickslip::lanes
