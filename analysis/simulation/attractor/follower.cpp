// In one file: one motion, turn by turn, with every way in which it may end.
// A motion that is followed, turn by turn, until it is judged.
#include "analysis/simulation/attractor/follower.h"
#include "analysis/numerics/lasting.h"
#include "analysis/simulation/attractor/repeats.h"
#include "analysis/simulation/flows/mode.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <vector>

namespace stickslip {
namespace {

constexpr double settled_distance = 1e-6;    ///< of steady sliding, in units of the flow's scale
constexpr double closed = 1e-7;              ///< gap of a closed orbit, per amplitude
constexpr double about_steady = 1e-3;        ///< the same, where states that do not move there stay what they were
constexpr double longest_turn = 1e4;         ///< of which a turn is given up, in times of the slowest linear rate
constexpr double shortest_turn = 1e-6;       ///< in times of the fastest linear rate: less is rounding on the section
constexpr double watched = 1e-8;             ///< the same for a motion that is only watched, at the noise of its steps
constexpr double by_the_linear_rate = 0.02;  ///< relative difference to the spectral abscissa
constexpr int linear_turns = 20;             ///< in succession at that rate: the rest of the decay is known
constexpr int most_idle_turns = 10;          ///< in succession: what happens lies below what doubles resolve
/// Growth of the amplitude per turn (its logarithm) below which a turn is followed more finely, and the growth that the
/// errors of such a turn may be taken for.
constexpr double fine_growth = 1e-3, no_growth = 1e-10;

constexpr double runaway = 1e12;  ///< speed in units of V_0: no slip reaches it

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
    slowest_ = rates.slowest;
    FlowMatrix J;
    flow.jacobian(steady_, J);
    frozen_ = (J.rowwise().lpNorm<Eigen::Infinity>().array() == 0).any();
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
    return sliding ? sliding->sticks() : dynamic_cast<const SwitchingFlow*>(&flow_) != nullptr;
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

std::optional<Attractor> Follower::end_at(const Turn& turn)
{
    using Kind = Attractor::Kind;
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
    return {};
}

Follower::Comparison Follower::compared() const
{
    const FlowVector& now = points_.back();
    const FlowVector& before = points_[points_.size() - 2];
    const Turn &turn = turns_.back(), &last = turns_[turns_.size() - 2];
    Comparison c;
    c.size = amplitude();
    c.gap = distance(now, before);
    c.growth = std::log(c.size / distance(before, steady_));
    c.equal = c.gap <= std::max(closed, 10 * options_.rtol) * std::max(c.size, 1.0);
    c.rest = turn.sticks > 0 && last.sticks > 0;
    c.slow = turn.rest_time > 0 && last.rest_time > 0;
    return c;
}

/// A smooth motion by shortcuts. Where one starts it anew, no points are left.
std::optional<Attractor> Follower::hastened(const Comparison& c)
{
    using Kind = Attractor::Kind;
    const bool due = c.gap < alike * c.size || quiet_turns_ % 12 == 11;
    if (due && shoot(points_.back())) return ended(Kind::cycle);
    // near rest, speeds span more decades than shooting through them resolves
    if (c.slow && c.equal) return from_turn(turns_.back());
    const bool creeping = std::abs(c.growth) < 0.3 && std::abs(c.growth - last_growth_) < 0.05;
    if (!(creeping && flow_.size() <= 3 && quiet_turns_ >= 3)) return {};
    if (steady_attracts_ && c.growth < 0 && c.size < 1e-3) return ended(Kind::steady);
    if (!fine_ && std::abs(c.growth) < fine_growth) {
        refine();
        return {};
    }
    const bool forgotten = std::abs(c.growth - last_growth_) < settled_growth * std::abs(c.growth);
    if (forgotten || quiet_turns_ > most_settling) {
        if (jump(c.growth)) return ended(Kind::cycle);
        if (std::abs(c.growth) < no_growth) return ended(Kind::undecided, Reason::not_converged);
    }
    return {};
}

/// Of a motion that is only watched, from how fast its gaps close.
bool Follower::closes(const Comparison& c) const
{
    const std::size_t n = points_.size();
    if (n <= 3) return false;
    const double last_gap = distance(points_[n - 2], points_[n - 3]);
    const double ratio = std::min(c.gap / last_gap, 0.999);
    return c.gap < watched * c.size || c.gap / (1 - ratio) < closed * c.size;
}

/// In steady sliding. A slipping element keeps the force to which a solver's error brought it, and the springs what
/// balances that: such a joint slides steadily at another place, where nothing moves any more.
bool Follower::settled(const FlowVector& y) const
{
    if (!steady_attracts_) return false;
    const double left = distance(y, steady_);
    if (left < settled_distance || !frozen_ || !(left < about_steady)) return left < settled_distance;
    FlowVector rate;
    motion_->flow().rate(y, rate);
    return rate.cwiseQuotient(scale_).cwiseAbs().maxCoeff() < settled_distance * slowest_;
}

Attractor Follower::run(const FlowVector& y)
{
    using Kind = Attractor::Kind;
    motion_->start(y);
    const auto settled = [this](const FlowVector& now) { return this->settled(now); };
    for (; result_.turns < options_.turn_limit; ++result_.turns) {
        const Turn turn = motion_->turn(motion_->time() + turn_limit_, settled);
        if (result_.turns == 0) result_.first_peak = turn.position_max;
        if (const auto end = end_at(turn)) return *end;
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
        const Comparison c = compared();
        // a motion that rests forgets everything but the spring: two equal turns are a closed orbit
        if ((c.rest || (c.slow && !smooth(turn))) && c.equal) return from_turn(turn);
        if (options_.accelerate && smooth(turn)) {
            if (const auto end = hastened(c)) return *end;
            if (points_.empty()) continue;
        } else if (!options_.accelerate && closes(c)) {
            return from_turn(turn);
        }
        last_growth_ = c.growth;
        if (result_.turns >= settling_turns && repeats())
            return ended(result_.repeats > 1 ? Kind::period_n : Kind::cycle);
        const bool linear = abscissa_ < 0 && std::abs(c.growth / (abscissa_ * turn.period()) - 1) < by_the_linear_rate;
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
