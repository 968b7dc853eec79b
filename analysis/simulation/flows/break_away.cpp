#include "analysis/simulation/flows/break_away.h"

#include <cmath>
#include <limits>

namespace stickslip {
namespace {

/// Where the exponent of the drop is read, per requested speed: at the first of them where the drop is more than what
/// rounding makes of two equal forces.
constexpr double first_speeds[] = {1e-6, 1e-4, 1e-2};
constexpr double clear_drop = 1e5 * std::numeric_limits<double>::epsilon();  ///< per static force
constexpr double steepest_regular = 0.95;  ///< exponents from which on a solver manages: the slope is hardly infinite
constexpr int steps = 64;

}  // namespace

std::optional<BreakAway> break_away(const SlidingFlow& flow, const FlowVector& y, double V)
{
    const double sign = V > 0 ? 1 : -1, speed = std::abs(V);
    States theta{};
    for (int i = 0; i < flow.states; ++i) theta[i] = y[2 + i];
    const auto drop = [&](double v) {
        return flow.static_force() - sign * respond(flow.friction, sign * v, theta).force;
    };
    double small = 0;
    for (const double share : first_speeds)
        if (small == 0 && drop(share * speed) > clear_drop * flow.static_force()) small = share * speed;
    const double exponent = std::log(drop(2 * small) / drop(small)) / std::log(2.0);
    if (!(small > 0 && exponent > 0 && exponent < steepest_regular)) return std::nullopt;

    // w = |V|^{1−exponent}: |V| = w^q, d|V|/dw = q w^{q−1}, and the surplus of force is ~ w^{q−1}, too
    const double q = 1 / (1 - exponent), h = std::pow(speed, 1 - exponent) / steps;
    const auto time_per_w = [&](double w, double x) {
        const double v = std::pow(w, q), surplus = sign * flow.holding_force(x) - flow.static_force() - flow.k_v * v;
        return flow.inertia * q * std::pow(w, q - 1) / (drop(v) + surplus);
    };
    BreakAway end{0, y[0]};
    for (int i = 0; i < steps; ++i) {  // the midpoints never meet the 0/0 at rest
        const double w = (i + 0.5) * h, relative = sign * std::pow(w, q) - flow.V0;
        const double half_way = end.x + 0.5 * h * relative * time_per_w(w, end.x);
        const double step = h * time_per_w(w, half_way);
        end.time += step;
        end.x += relative * step;
    }
    return end;
}

}  // namespace stickslip
