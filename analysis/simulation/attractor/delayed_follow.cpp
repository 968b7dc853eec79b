#include <algorithm>
#include <cmath>
#include <deque>
#include <numbers>
#include <vector>

#include "analysis/numerics/lasting.h"
#include "analysis/simulation/attractor/attractor.h"
#include "analysis/simulation/attractor/repeats.h"
#include "analysis/simulation/flows/delayed_flow.h"

namespace stickslip {
namespace {

constexpr double settled_size = 1e-5;  ///< of the flow's scale: steady sliding again
constexpr double closed = 1e-6;        ///< gap of a closed orbit, per size
constexpr double longest_turn = 1e3;   ///< of which a turn is given up, in turns of the slowest mode
constexpr int first_turns = 4;         ///< before a motion is tested for having closed
constexpr int settling_turns = 60;     ///< before one that has not is tested for longer repeats
constexpr double by_the_linear_rate = 0.02;
constexpr std::ptrdiff_t sticking_turns = 8;  ///< in succession of nearly one size that go on so
constexpr double nearly_one_size = 0.05;
constexpr int linear_turns = 20;  ///< in succession that decayed at that rate: the rest of the decay is known

double distance(const DelayedFlow& flow, const FlowVector& a, const FlowVector& b)
{
    const auto n = flow.chain().size();
    return (a - b).head(n).cwiseQuotient(flow.scale().head(n)).cwiseAbs().maxCoeff();
}

Attractor from_turns(const std::deque<Turn>& turns, int newest, Attractor result)
{
    result.take(merged(turns, newest));
    result.repeats = full_turns(turns, newest);
    return result;
}

/// Whether the newest turns all stick and are of nearly one size: a turn that sticks forgets the one before, so that
/// none fades from turn to turn.
bool goes_on_sticking(const std::deque<Turn>& turns, const std::vector<double>& sizes)
{
    if (std::ssize(sizes) < sticking_turns) return false;
    const auto [least, most] = std::minmax_element(sizes.end() - sticking_turns, sizes.end());
    return std::all_of(turns.end() - sticking_turns, turns.end(), [](const Turn& t) { return t.sticks > 0; }) &&
           *most - *least < nearly_one_size * *most;
}

/// A motion that has neither closed nor settled. One that was cut short for want of work says less, and less is read
/// from it.
Attractor unclosed(const DelayedFlow& flow, const std::deque<Turn>& turns, bool cut_short, Attractor result)
{
    using Kind = Attractor::Kind;
    const int count = static_cast<int>(turns.size());
    const auto gap = [&](int i, int j) { return distance(flow, turns[i].state, turns[j].state); };
    std::vector<double> sizes;
    for (const auto& turn : turns) sizes.push_back(distance(flow, turn.state, flow.steady()));
    if (const int m = cut_short ? turns_to_repeat_nearly(count, gap, sizes.back()) : 0; m > 0) {
        result = from_turns(turns, m, result);
        result.kind = result.repeats > 1 ? Kind::period_n : Kind::cycle;
    } else if (cut_short ? lasts(sizes) || goes_on_sticking(turns, sizes) : grows_and_shrinks(sizes)) {
        result.take(merged(turns, count));
        result.kind = Kind::irregular;
    } else {
        result.kind = Kind::undecided;
        result.reason = Reason::not_converged;
        result.cut_short = cut_short;
    }
    return result;
}

}  // namespace

Attractor follow(const DelayedFlow& flow, const FlowVector& from, bool steady_attracts, const FollowOptions& options)
{
    using Kind = Attractor::Kind;
    const auto mode = slow_mode(flow);
    const double slow_turn = 2 * std::numbers::pi / std::abs(mode.s);
    const FlowVector steady = flow.steady();
    SlidingMotion motion(flow, Solver::rodas5p, options.rtol);
    motion.start(from);
    Attractor result;
    result.path = DecisionPath::steps;
    const auto ended = [&](Kind kind, Reason reason = Reason::none) {
        result.kind = kind;
        result.reason = reason;
        return result;
    };
    // the past is a part of the motion: it has settled where a whole lag has, and a cycle
    double quiet_since = 0;
    const auto settled = [&](const FlowVector& y) {
        if (distance(flow, y, steady) > settled_size) quiet_since = flow.clock(y);
        return flow.clock(y) - quiet_since > flow.longest_lag() + slow_turn;
    };
    std::deque<Turn> turns;  // newest last
    const double longest = longest_turn * slow_turn + flow.wind_up_time();
    const auto gap = [&](int i, int j) { return distance(flow, turns[i].state, turns[j].state); };
    double last_size = missing;
    int turns_at_the_linear_rate = 0;
    for (; result.turns < options.turn_limit; ++result.turns) {
        const Turn turn = motion.turn(motion.time() + longest, settled);
        if (result.turns == 0) result.first_peak = turn.position_max;
        if (turn.end == Turn::End::settled) return ended(Kind::steady);
        if (turn.end == Turn::End::failure) return ended(Kind::failure, Reason::solver_failed);
        if (turn.end != Turn::End::crossing) return ended(Kind::undecided, Reason::not_converged);
        turns.push_back(turn);
        if (turns.size() > 2 * longest_repeat + 2) turns.pop_front();
        const double size = distance(flow, turn.state, steady);
        if (result.turns >= first_turns) {
            const int m = turns_to_repeat(static_cast<int>(turns.size()), gap, closed * size);
            if (m == 1 || (m > 1 && result.turns >= settling_turns)) {
                result = from_turns(turns, m, result);
                return ended(result.repeats > 1 ? Kind::period_n : Kind::cycle);
            }
        }
        const double linear = mode.s.real() * turn.period();
        const bool decays = steady_attracts && turn.sticks == 0 && linear < 0 &&
                            std::abs(std::log(size / last_size) / linear - 1) < by_the_linear_rate;
        turns_at_the_linear_rate = decays ? turns_at_the_linear_rate + 1 : 0;
        if (turns_at_the_linear_rate >= linear_turns) return ended(Kind::steady);
        last_size = size;
        if (options.work) options.work->spend(turn.steps * Work::of_delayed_step(flow.size()));
        if (options.work && options.work->spent()) break;
    }
    return unclosed(flow, turns, result.turns < options.turn_limit, result);
}

}  // namespace stickslip
