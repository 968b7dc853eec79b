#include "analysis/simulation/attractor/orbit.h"

#include <cmath>

namespace stickslip {
namespace {

constexpr double same_orbit = 1e-6;  ///< gap of an orbit that closes sooner than required, per size
/// Multiplier, as a modulus, of an orbit beside which none of twice its turns attracts any more: in the logistic map
/// that one loses its hold where the multiplier of the first has come to 1 − √6.
constexpr double most_repelling = 3;

double distance(const Flow& flow, const FlowVector& a, const FlowVector& b)
{
    return (a - b).cwiseQuotient(flow.scale()).cwiseAbs().maxCoeff();
}

/// Newton for many turns may find an orbit of fewer, gone around several times.
Orbit shortest(const Flow& flow, Orbit orbit, CycleOptions options)
{
    const double size = distance(flow, orbit.cycle.start, flow.steady());
    for (int part = 1; part < orbit.turns; ++part) {
        if (orbit.turns % part != 0) continue;
        options.turns = part;
        const auto once = revolve(flow, orbit.cycle.start, options);
        if (!once || distance(flow, once->end, orbit.cycle.start) > same_orbit * size) continue;
        orbit.turns = part;
        orbit.cycle.period = once->path.period;
        orbit.cycle.rest_time = once->path.rest_time;
        orbit.cycle.multipliers = floquet_multipliers(flow, *once);
        break;
    }
    return orbit;
}

}  // namespace

std::optional<Orbit> attracting_orbit(const Flow& flow, const FlowVector& guess, int watched_turns, double rtol,
                                      double reach, Work* work)
{
    CycleOptions options;
    options.rtol = rtol;
    options.turns = watched_turns;
    options.work = work;
    const auto near = revolve(flow, guess, options);
    if (!near || std::abs(floquet_multipliers(flow, *near)[0]) > most_repelling) return {};
    for (int turns = 1; turns <= 2 * watched_turns; ++turns) {
        if (watched_turns % turns != 0 && turns != 2 * watched_turns) continue;
        options.turns = turns;
        const auto cycle = find_cycle(flow, guess, options);
        if (cycle && cycle->attracts() && distance(flow, cycle->start, guess) < reach)
            return shortest(flow, {*cycle, turns}, options);
    }
    return {};
}

}  // namespace stickslip
