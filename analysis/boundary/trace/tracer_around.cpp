// Where a boundary passes: between two points of different sides, and all around a point.
#include "analysis/boundary/trace/tracer.h"

#include "analysis/numerics/root.h"
#include "analysis/results/point.h"

#include <algorithm>
#include <numbers>

namespace stickslip {
namespace {

constexpr int directions = 16;  ///< looked at around a point for the ways out of it
constexpr int angle_bisections = 4;

}  // namespace

Located Tracer::locate(UnitPoint a, double fa, UnitPoint b, double fb)
{
    const bool along_y = a.u == b.u;
    const UnitAxis& axis = along_y ? y_ : x_;
    const double ua = along_y ? a.v : a.u, ub = along_y ? b.v : b.u;
    const double other = along_y ? x_.value(a.u) : y_.value(a.v);
    const int before = evaluations_;
    const auto f = [&](double value) {
        ++evaluations_;
        const double side = along_y ? sides_.at(other, value) : sides_.at(value, other);
        return sides_.continuous || std::isnan(side) ? side : side < 0 ? -1.0 : 1.0;
    };
    // of two sides that differ in sign only, interpolation is bisection
    if (!sides_.continuous) fa = fa < 0 ? -1 : 1, fb = fb < 0 ? -1 : 1;
    const double va = axis.value(ua), vb = axis.value(ub);
    Bracketed root{};
    if (std::abs(vb - va) <= sides_.precision * std::min(std::abs(va), std::abs(vb)))
        root = {0.5 * (va + vb), std::min(va, vb), std::max(va, vb), 0, true};
    else
        root = bracketed_root(f, va, fa, vb, fb, sides_.precision, axis.least_width());
    Located found;
    const double u = axis.unit(root.value);
    found.p = along_y ? UnitPoint{a.u, u} : UnitPoint{u, a.v};
    found.point.along_y = along_y;
    found.point.x = along_y ? other : root.value;
    found.point.y = along_y ? root.value : other;
    found.point.at = {root.value,
                      root.low,
                      root.high,
                      (fb > fa) == (vb > va) ? 1 : -1,
                      root.converged,
                      evaluations_ - before,
                      sides_.continuous ? LocationMethod::interpolation : LocationMethod::bisection};
    const double bracket = std::abs(ub - ua);
    if (sides_.continuous && bracket > 0) found.slope = std::abs(fb - fa) / bracket;
    return found;
}

std::vector<Tracer::Exit> Tracer::exits(UnitPoint centre, double radius, const UnitPoint* back)
{
    const auto direction = [](double angle) { return UnitPoint{std::cos(angle), std::sin(angle)}; };
    const auto side = [&](double angle) {
        const auto p = centre + radius * direction(angle);
        return p.inside() ? at(p) : missing;
    };
    std::vector<double> angles, around;
    for (int k = 0; k < directions; ++k) angles.push_back(2 * std::numbers::pi * (k + 0.37) / directions);
    if (back) {
        // within a cusp the other branch lies close beside the way back
        const double middle = std::atan2(back->v, back->u) + (back->v < 0 ? 2 * std::numbers::pi : 0);
        for (double offset = 0.002; offset < 0.3; offset *= 1.7)
            for (const double angle : {middle - offset, middle + offset})
                angles.push_back(std::fmod(angle + 2 * std::numbers::pi, 2 * std::numbers::pi));
        std::sort(angles.begin(), angles.end());
    }
    for (const double angle : angles) around.push_back(side(angle));
    std::vector<Exit> found;
    for (std::size_t k = 0; k < angles.size(); ++k) {
        const bool wraps = k + 1 == angles.size();
        double a = angles[k], b = wraps ? angles[0] + 2 * std::numbers::pi : angles[k + 1];
        const double fa = around[k], fb = around[wraps ? 0 : k + 1];
        if (!differ(fa, fb)) continue;
        for (int i = 0; i < angle_bisections; ++i) {
            const double middle = 0.5 * (a + b);
            (differ(fa, side(middle)) ? b : a) = middle;
        }
        found.push_back({direction(0.5 * (a + b)), fb < 0 ? -1.0 : 1.0});
    }
    return found;
}

}  // namespace stickslip
