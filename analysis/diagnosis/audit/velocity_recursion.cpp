#include "analysis/diagnosis/audit/velocity_recursion.h"

#include "analysis/diagnosis/plant/controller.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace stickslip::gap {
namespace {

/// Calls `take(k, d)` at every tick k before which no row was lost that d[k − earlier] and v[k − 1 − earlier] need; d
/// are the unfiltered velocities, tick by tick.
template <class Take>
void at_known_ticks(const Case& c, std::size_t earlier, Take&& take)
{
    const Ticks& t = c.ticks;
    Control unfiltered = c.joint.control;
    unfiltered.velocity_estimate.tau = 0;
    Controller controller(unfiltered);
    std::vector<double> d(t.size());
    const double averaged = std::max(1.0, unfiltered.velocity_estimate.average) + static_cast<double>(earlier);
    double in_a_row = 0;
    for (std::size_t k = 0; k < t.size(); ++k) {
        controller.read(t.position[k], k == 0 ? t.step[0] : t.step[k - 1], 0);
        d[k] = controller.velocity();
        in_a_row = t.logged[k] ? in_a_row + 1 : 0;
        if (k <= earlier || (t.lost && in_a_row <= averaged)) continue;
        take(k, d);
    }
}

}  // namespace

OnePole one_pole_of(const std::vector<const Case*>& cases)
{
    double ab = 0, aa = 0, bb = 0;
    for (const Case* c : cases) {
        const auto& v = c->ticks.velocity;
        at_known_ticks(*c, 0, [&](std::size_t k, const std::vector<double>& d) {
            const double a = d[k] - v[k - 1], b = v[k] - v[k - 1];
            if (std::isfinite(a) && std::isfinite(b)) ab += a * b, aa += a * a, bb += b * b;
        });
    }
    if (aa == 0 || bb == 0) return {};
    return {ab / aa, std::sqrt(std::max(0.0, 1 - ab * ab / aa / bb))};
}

TwoPoles two_poles_of(const std::vector<const Case*>& cases)
{
    Eigen::Matrix4d G = Eigen::Matrix4d::Zero();
    Eigen::Vector4d g = Eigen::Vector4d::Zero();
    double square = 0;
    for (const Case* c : cases) {
        const auto& v = c->ticks.velocity;
        at_known_ticks(*c, 2, [&](std::size_t k, const std::vector<double>& d) {
            const Eigen::Vector4d row(d[k] - v[k - 1], v[k - 1] - v[k - 2], d[k - 1] - d[k], d[k - 2] - d[k]);
            const double step = v[k] - v[k - 1];
            if (!row.allFinite() || !std::isfinite(step)) return;
            G += row * row.transpose(), g += step * row, square += step * step;
        });
    }
    const Eigen::Vector4d unit = G.diagonal().cwiseSqrt();
    if (!(unit.minCoeff() > 0) || square == 0) return {};
    const Eigen::Matrix4d scaled = unit.cwiseInverse().asDiagonal() * G * unit.cwiseInverse().asDiagonal();
    const Eigen::Vector4d x = scaled.ldlt().solve(g.cwiseQuotient(unit)).cwiseQuotient(unit);
    if (!x.allFinite()) return {};
    const double left = std::max(0.0, square - 2 * g.dot(x) + x.dot(G * x));
    return {x[0], std::sqrt(left / square), (1 - x[1] + x[2] + 2 * x[3]) / x[0] - 1};
}

}  // namespace stickslip::gap
