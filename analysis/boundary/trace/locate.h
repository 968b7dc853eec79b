// Stability boundaries of the linear theories, located rather than contoured: on a ray, and over a chart.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/results/boundary.h"
#include "analysis/results/point.h"

#include <optional>
#include <string_view>
#include <vector>

namespace stickslip {

/// Relative width of the bracket around a linear boundary.
inline constexpr double linear_precision = 1e-12;

/// Negative where the theory calls the joint stable, positive where unstable, 0 where neutral (no boundary lies between
/// neutral and unstable: nothing turns stable there), NaN where it cannot say; continuous across the boundary.
/// state_variable: max Re s of (27). velocity_only: the larger of −(k_v + f_ss') and −k_p, (21); several bodies,
/// contact or force gain: max Re s of the joint with its steady-state curves.
double instability(const Joint& joint, Curve::Kind theory);

/// Whether `instability` is negative, without its size, which costs joints of several bodies ten times as much; nothing
/// where the theory cannot say.
std::optional<bool> is_stable(const Joint& joint, Curve::Kind theory);

/// Every sign change of `instability` for the parameter at `path` between low and high. A scan of `scan` intervals
/// (evenly in the logarithm if `log`) brackets them: two boundaries within one interval can be missed.
std::vector<BoundaryPoint> locate_on_ray(const Joint& joint, std::string_view path, double low, double high, bool log,
                                         Curve::Kind theory, int scan = 200);

/// The boundary over a chart: every crossing of the lines of a mesh at least `mesh` fine on both axes is located to
/// linear_precision, and neighbours are joined. Pieces are separated by NaN. Islands smaller than a mesh cell can be
/// missed. The edge of an area in which sliding is neutral is no boundary.
Curve locate_over_chart(const Joint& joint, const Axis& x, const Axis& y, Curve::Kind theory, int mesh = 96);

/// The nearest state-variable boundary around the joint's own value of one parameter, searched over the axis widened
/// tenfold.
Margin margin_along(const Joint& joint, const Axis& axis);

}  // namespace stickslip
