#include "analysis/boundary/kinds/outside.h"

#include <algorithm>

namespace stickslip {
namespace {

constexpr double rough = 1e-3;  ///< precision of an outcome that only has to be pointed at

double widening(BoundaryKind kind)
{
    return kind == BoundaryKind::fold ? 30 : kind == BoundaryKind::outcome || kind == BoundaryKind::hunting ? 10 : 1000;
}

}  // namespace

OutsideOfRay nearest_outside(const Joint& joint, const LocatedRay& ray, const BoundaryRequest& requested)
{
    const double low = ray.axis.values.front(), high = ray.axis.values.back(), factor = widening(ray.kind);
    BoundaryRequest request = requested;
    request.kind = ray.kind;
    request.scan = 0;
    if (ray.kind == BoundaryKind::outcome) request.precision = rough;
    OutsideOfRay outside;
    outside.low = low, outside.high = high;
    double distance = infinity;
    const auto look = [&](double from, double to, double end) {
        Axis axis = ray.axis;
        axis.log = true;
        axis.values = {from, to};
        const auto beyond = locate_boundaries(joint, axis, request);
        outside.nodes += beyond.nodes, outside.undecided += beyond.undecided;
        outside.without_verdict.insert(outside.without_verdict.end(), beyond.without_verdict.begin(),
                                       beyond.without_verdict.end());
        for (const auto& p : beyond.points) {
            const double away = std::abs(std::log(p.value / end));
            if (away < distance) distance = away, outside.nearest = p;
        }
    };
    // beyond these ends a number leaves the range of normal ones
    if (low > 0 && std::isnormal(low / factor)) outside.low = low / factor, look(outside.low, low, low);
    if (high > 0 && std::isfinite(high * factor)) outside.high = high * factor, look(high, outside.high, high);
    return outside;
}

}  // namespace stickslip
