// The least stable joint within an uncertainty, and the boundary of those that are stable for all of it.
#include "analysis/boundary/kinds/directions.h"
#include "analysis/boundary/kinds/nearest.h"

#include "analysis/boundary/trace/locate.h"
#include "analysis/joint/parameters.h"
#include "analysis/numerics/optimise.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace stickslip {
namespace {

constexpr double robust_precision = 1e-7;  ///< the worst case itself is known no better
constexpr int local_evaluations = 80;      ///< per coordinate, of SBPLX within an uncertainty
constexpr int corner_limit = 6;            ///< coordinates of which all corners are looked at

}  // namespace

WorstCase worst_case(const Joint& joint, const Uncertainty& uncertainty, Curve::Kind theory, bool global)
{
    const std::size_t n = uncertainty.coordinates.size();
    const bool ball = uncertainty.shape == UncertaintyShape::ellipsoid;
    WorstCase worst;
    MovableJoint movable(joint, uncertainty.coordinates);
    const auto deviations = [&](Vector z) {
        const double length = norm(z);
        if (ball && length > 1) z = scaled_by(z, 1 / length);
        for (std::size_t i = 0; i < n; ++i) z[i] *= uncertainty.share[i];
        return z;
    };
    const auto stability = [&](const Vector& z) {
        Vector q = deviations(z);
        for (std::size_t i = 0; i < n; ++i) q[i] = std::log1p(q[i]) / uncertainty.coordinates[i].scale;
        ++worst.evaluations;
        const double growth = instability(movable.at(q), theory);
        if (std::isnan(growth)) ++worst.undecided;
        return -growth;
    };
    Vector best(n, 0);
    double least = stability(best);
    const auto consider = [&](const Vector& z) {
        const double s = stability(z);
        if (s < least) least = s, best = z;
    };
    if (n <= corner_limit)
        for (unsigned corner = 0; corner < 1u << n; ++corner) {
            Vector z(n);
            for (std::size_t i = 0; i < n; ++i) z[i] = corner >> i & 1u ? 1 : -1;
            consider(ball ? scaled_by(z, 1 / norm(z)) : z);
        }
    for (std::size_t i = 0; i < n; ++i)
        for (const double sign : {-1.0, 1.0}) {
            Vector z(n, 0);
            z[i] = sign;
            consider(z);
        }
    const Bounds cube{Vector(n, -1), Vector(n, 1)};
    if (global) consider(global_minimum(stability, cube, global_evaluations * static_cast<int>(n)));
    if (n > 0) consider(local_minimum(stability, cube, best, 0.25, local_evaluations * static_cast<int>(n)));
    worst.instability = -least;
    worst.deviations = deviations(best);
    return worst;
}

FollowedBoundary follow_robust_boundary(const Joint& joint, const Axis& x, const Axis& y,
                                        const Uncertainty& uncertainty, const BoundaryRequest& request)
{
    Joint probe = joint;
    for (const auto& path : {x.path, y.path})
        if (!find_parameter(probe, path)) throw std::invalid_argument("no number at " + path);
    Sides sides;
    sides.precision = is_set(request.precision) ? request.precision : robust_precision;
    sides.at = [&](double u, double v) {
        Joint here = joint;
        number_at(here, x.path) = u;
        number_at(here, y.path) = v;
        return worst_case(here, uncertainty, Curve::Kind::state_variable, false).instability;
    };
    if (request.parallel)
        sides.many = [&](const std::vector<double>& u, const std::vector<double>& v, std::vector<double>& values) {
            request.parallel(u.size(), [&](std::size_t i) { values[i] = sides.at(u[i], v[i]); });
        };
    auto followed = follow_boundary(sides, x, y, request.following);
    followed.kind = BoundaryKind::state_variable;
    return followed;
}

}  // namespace stickslip
