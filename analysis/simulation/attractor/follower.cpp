// In one file: one method: a motion until it is judged, with the numbers that its tests share.
#include "analysis/simulation/attractor/follower.h"
#include "analysis/numerics/lasting.h"
#include "analysis/simulation/attractor/orbit.h"
#include "analysis/simulation/attractor/repeats.h"
#include "analysis/simulation/flows/mode.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <vector>

namespace stickslip {
namespace {

constexpr double settled_distance = 1e-6;    ///< of steady sliding, in units of the flow's scale
constexpr double alike = 0.05;               ///< gap of two turns, per amplitude, from which shooting is tried
constexpr double closed = 1e-7;              ///< gap of a closed orbit, per amplitude
constexpr double longest_turn = 1e4;         ///< of which a turn is given up, in times of the slowest linear rate
constexpr double shortest_turn = 1e-6;       ///< in times of the fastest linear rate: less is rounding on the section
constexpr double watched = 1e-8;             ///< the same for a motion that is only watched, at the noise of its steps
constexpr double by_the_linear_rate = 0.02;  ///< relative difference to the spectral abscissa
constexpr int linear_turns = 20;             ///< in succession at that rate: the rest of the decay is known
constexpr int most_idle_turns = 10;          ///< in succession: what happens lies below what doubles resolve
/// Growth of the amplitude per turn (its logarithm) below which a turn is followed more finely, what such a turn is
/// followed to, and the growth that its errors may be taken for.
constexpr double fine_growth = 1e-3, fine_rtol = 1e-12, no_growth = 1e-10;

constexpr double runaway = 1e12;  ///< speed in units of V_0: no slip reaches it

/// Contraction of a turn, 1 − |μ|, that the variational equations of shooting resolve.
constexpr double clear_contraction = 1e-5;
constexpr int longest_wait = 32;        ///< turns until what creeps past a fold is shot at again
constexpr int most_settling = 8;        ///< turns that a scaled motion gets to forget how it was scaled
constexpr double settled_growth = 0.3;  ///< change of growth, relative, of one that has
constexpr double near_return = 1e-3;    ///< gap after several turns, per amplitude, from which an orbit is looked for
constexpr int patient_turns = 600;      ///< before repeats seen by watching alone count
constexpr int most_steps =
    3'000'000;  ///< of a motion without a limit of work; 3000 turns of an irregular one took 2.1 million
constexpr int wild_turns = 600;     ///< before a motion that neither closes nor settles is called irregular
constexpr int settling_turns = 60;  ///< before a motion that neither closes nor settles is tested for repeats

}  // namespace

Follower::Follower(const Flow& flow, bool steady_attracts, const FollowOptions& options)
    : flow_(flow),
      options_(options),
      steady_attracts_(steady_attracts),
      scale_(flow.scale()),
      steady_(flow.steady()),
      motion_(std::make_unique<SlidingMotion>(flow, options.solver, options.rtol))
{
    const auto rates = linear_rates(flow);
    const double wind_up = flow.wind_up_time();
    turn_limit_ = longest_turn / rates.slowest + (std::isfinite(wind_up) ? wind_up : 0);
    abscissa_ = rates.abscissa;
    least_turn_ = shortest_turn / rates.fastest;
    one_turn_.longest_wait = longest_wait;
    several_turns_.longest_wait = options.turn_limit;  // each costs as much as hundreds of turns
}

Attractor Follower::ended(Attractor::Kind kind, Reason reason)
{
    result_.kind = kind;
    result_.reason = reason;
    result_.used_fallback = motion_->used_fallback();
    return result_;
}

Attractor Follower::from_turn(const Turn& turn)
{
    result_.take(turn);
    return ended(Attractor::Kind::cycle);
}

bool Follower::may_rest() const
{
    const auto* sliding = dynamic_cast<const SlidingFlow*>(&flow_);
    return sliding ? sliding->can_rest() : dynamic_cast<const SwitchingFlow*>(&flow_) != nullptr;
}

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

/// Beside a period doubling turns come back long before they have told after how many: the orbit that attracts decides.
bool Follower::shoot_repeat(int watched_turns)
{
    if (!several_turns_.taken_at(result_.turns)) return false;
    const double rtol = std::min(1e-9, options_.rtol);
    const auto orbit = attracting_orbit(flow_, points_.back(), watched_turns, rtol, alike * amplitude());
    if (!orbit) return false;
    result_.take(orbit->cycle);
    result_.repeats = full_turns(turns_, std::min(orbit->turns, static_cast<int>(turns_.size())));
    return true;
}

bool Follower::repeats()
{
    const auto gap = [this](int i, int j) { return distance(points_[i], points_[j]); };
    const int count = static_cast<int>(points_.size());
    const int m = turns_to_repeat(count, gap, 100 * closed * amplitude());
    if (options_.accelerate && !may_rest() && m != 1) {
        const int near = nearest_return(count, gap, near_return * amplitude());
        if (near > 1 && shoot_repeat(near)) return true;
        if (result_.turns < patient_turns) return false;
    }
    // what creeps seems closed: its growth decides
    if (m == 0 || (m == 1 && fine_ && smooth(turns_.back()))) return false;
    take_repeat(m);
    return true;
}

void Follower::take_repeat(int m)
{
    from_turn(merged(turns_, m));
    result_.repeats = full_turns(turns_, m);
}

/// Of a motion that there is no work left to watch; what creeps is not scaled any more.
bool Follower::comes_back()
{
    if (points_.size() < 2) return false;
    const auto gap = [this](int i, int j) { return distance(points_[i], points_[j]); };
    const int m = turns_to_repeat_nearly(static_cast<int>(points_.size()), gap, amplitude());
    if (m > 0) take_repeat(m);
    return m > 0;
}

// In one piece: one motion until it is judged: the order of its tests is the method.
Attractor Follower::run(const FlowVector& y)
{
    using Kind = Attractor::Kind;
    motion_->start(y);
    const auto settled = [this](const FlowVector& now) {
        return steady_attracts_ && distance(now, steady_) < settled_distance;
    };
    for (; result_.turns < options_.turn_limit; ++result_.turns) {
        const Turn turn = motion_->turn(motion_->time() + turn_limit_, settled);
        if (result_.turns == 0) result_.first_peak = turn.position_max;
        switch (turn.end) {
            case Turn::End::settled:
                return ended(Kind::steady);
            case Turn::End::held:
                return ended(Kind::held);
            case Turn::End::failure:
                result_.diverged = turn.velocity_max > runaway * flow_.commanded_velocity();
                return ended(Kind::failure, result_.diverged ? Reason::diverges : Reason::solver_failed);
            case Turn::End::time:
                return ended(Kind::undecided, Reason::not_converged);
            case Turn::End::crossing:
                break;
        }
        idle_turns_ = turn.period() > least_turn_ ? 0 : idle_turns_ + 1;
        steps_ += turn.steps;
        spend(turn);
        if (idle_turns_ > most_idle_turns) return ended(Kind::undecided, Reason::not_converged);
        if (options_.work ? options_.work->spent() : steps_ > most_steps) break;
        if (idle_turns_ > 0) continue;  // the motion never left the section
        points_.push_back(turn.state);
        turns_.push_back(turn);
        ++quiet_turns_;
        if (points_.size() > 2 * longest_repeat + 2) points_.pop_front(), turns_.pop_front();
        if (points_.size() < 2) continue;
        const FlowVector& now = points_.back();
        const FlowVector& before = points_[points_.size() - 2];
        const double size = amplitude(), gap = distance(now, before);
        const double growth = std::log(size / distance(before, steady_));
        // a motion that rests forgets everything but the spring: two equal turns are a closed orbit
        const bool equal = gap <= std::max(closed, 10 * options_.rtol) * std::max(size, 1.0);
        const Turn& last = turns_[turns_.size() - 2];
        const bool rests = turn.sticks > 0 && last.sticks > 0, slows = turn.rest_time > 0 && last.rest_time > 0;
        if ((rests || (slows && !smooth(turn))) && equal) return from_turn(turn);
        if (options_.accelerate && smooth(turn)) {
            const bool due = gap < alike * size || quiet_turns_ % 12 == 11;
            if (due && shoot(now)) return ended(Kind::cycle);
            // near rest, speeds span more decades than shooting through them resolves
            if (slows && equal) return from_turn(turn);
            const bool creeping = std::abs(growth) < 0.3 && std::abs(growth - last_growth_) < 0.05;
            if (creeping && flow_.size() <= 3 && quiet_turns_ >= 3) {
                if (steady_attracts_ && growth < 0 && size < 1e-3) return ended(Kind::steady);
                if (!fine_ && std::abs(growth) < fine_growth) {
                    refine();
                    continue;
                }
                const bool forgotten = std::abs(growth - last_growth_) < settled_growth * std::abs(growth);
                if (forgotten || quiet_turns_ > most_settling) {
                    if (jump(growth)) return ended(Kind::cycle);
                    if (std::abs(growth) < no_growth) return ended(Kind::undecided, Reason::not_converged);
                }
                if (points_.empty()) continue;
            }
        } else if (!options_.accelerate && points_.size() > 3) {
            const double last_gap = distance(before, points_[points_.size() - 3]);
            const double ratio = std::min(gap / last_gap, 0.999);
            if (gap < watched * size || gap / (1 - ratio) < closed * size) return from_turn(turn);
        }
        last_growth_ = growth;
        if (result_.turns >= settling_turns && repeats())
            return ended(result_.repeats > 1 ? Kind::period_n : Kind::cycle);
        const bool linear = abscissa_ < 0 && std::abs(growth / (abscissa_ * turn.period()) - 1) < by_the_linear_rate;
        linear_turns_ = linear ? linear_turns_ + 1 : 0;
        if (steady_attracts_ && linear_turns_ >= linear_turns) return ended(Kind::steady);
    }
    const bool cut_short = result_.turns < options_.turn_limit;
    if (cut_short && comes_back()) return ended(result_.repeats > 1 ? Kind::period_n : Kind::cycle);
    if (!wild(cut_short)) {
        result_.cut_short = cut_short;
        return ended(Kind::undecided, Reason::not_converged);
    }
    from_turn(merged(turns_, static_cast<int>(turns_.size())));
    return ended(Kind::irregular);
}

/// Bounded, and neither creeping nor in a flow too small for chaos.
bool Follower::wild(bool cut_short) const
{
    if (flow_.size() <= 3 || points_.size() < 3) return false;
    std::vector<double> sizes;
    for (const auto& point : points_) sizes.push_back(distance(point, steady_));
    return result_.turns < wild_turns ? cut_short && lasts(sizes) : grows_and_shrinks(sizes);
}

void Follower::spend(const Turn& turn)
{
    if (options_.work) options_.work->spend(turn.steps * Work::of_step(flow_.size()));
}

Attractor follow(const Flow& flow, const FlowVector& y, bool steady_attracts, const FollowOptions& options)
{
    return Follower(flow, steady_attracts, options).run(y);
}

}  // namespace stickslip
