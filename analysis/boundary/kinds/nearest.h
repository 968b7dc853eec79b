// The nearest boundary in all directions at once, and the worst case within an uncertainty.
#pragma once
#include "analysis/boundary/kinds/boundary.h"
#include "analysis/boundary/trace/coordinates.h"

#include <string>

namespace stickslip {

/// How far and how thoroughly nearest_boundary searches.
struct NearestOptions {
    Curve::Kind theory = Curve::Kind::state_variable;  ///< whose verdict changes at the boundary
    double reach = not_set;  ///< distance searched; not set: a factor of ten in the least of the scales
    int rays = 48;           ///< steps, finer near the joint, along each direction before the first crossing is located
    bool global = true;      ///< first NLopt's DIRECT over all directions; otherwise only from the starts
    int local = 80;          ///< steps of the local search per coordinate; 0: the boundary's normals alone
    double precision = 1e-10;  ///< of the distances that are compared; the one that is answered has 1e-10
    std::vector<std::vector<double>> starts;  ///< directions to begin with, beside the axes
    bool along_starts_only = false;           ///< nothing but these is looked along

    /// What is wrong with them; empty if nothing.
    std::string problem() const;
};

/// The smallest distance √Σ q_i², q_i = ln(value ratio)/scale, at which the verdict of the joint changes. Every
/// direction is scanned from the joint outwards, so no nearer boundary lies on the way; global then local search over
/// directions (NLopt: DIRECT-L, then SBPLX), the crossing itself bracketed to 1e-10. Throws std::invalid_argument
/// for options with a problem().
NearestBoundary nearest_boundary(const Joint& joint, const std::vector<Coordinate>& coordinates,
                                 const NearestOptions& options);

/// The most thorough search that takes seconds at most: joints of several bodies, and more so those with delays, cost
/// more a verdict.
NearestOptions affordable_search(const Joint& joint);

/// The reach that an unset one stands for: ln 10 per the smallest scale.
double default_reach(const std::vector<Coordinate>& coordinates);

/// distance of nearest_boundary, negative for an unstable joint; `reach` where there is none within it.
double signed_margin(const NearestBoundary& nearest);

/// Share by which each of these may be off, all at once and in any direction, within a distance: 1 − exp(−d/√Σ
/// 1/scale²).
double tolerance_each(double distance, const std::vector<Coordinate>& coordinates);

/// How shares go together: each up to its own, or the sum of squares of (deviation/share) up to 1.
enum class UncertaintyShape { box, ellipsoid };

/// Shares by which coordinates may be off: value · (1 ± share). The ellipsoid touches the box in its axes.
struct Uncertainty {
    std::vector<Coordinate> coordinates;             ///< the parameters that may be off
    std::vector<double> share;                       ///< of each coordinate, as a part of its value
    UncertaintyShape shape = UncertaintyShape::box;  ///< how shares go together
};

/// The least stable joint within an uncertainty.
struct WorstCase {
    double instability = missing;    ///< of the theory, as in analysis/boundary/trace/locate.h
    std::vector<double> deviations;  ///< per coordinate, as a share of its value
    int evaluations = 0;             ///< joints that were judged
    int undecided = 0;               ///< of the joints that were tried, without a verdict
};

/// Corners (up to six coordinates) or axes first, then NLopt: DIRECT-L if `global`, and SBPLX from the worst found.
/// Throws std::invalid_argument for a coordinate that the joint lacks; one share a coordinate, within [0, 1), is the
/// caller's business.
WorstCase worst_case(const Joint& joint, const Uncertainty& uncertainty, Curve::Kind theory, bool global = true);

/// The edge of the robustly stable set over two axes: where the worst case within the uncertainty turns unstable. The
/// uncertain shares hold around the values at each point of the chart. Corners and a local search at each point.
/// Throws std::invalid_argument for a path that the joint lacks.
FollowedBoundary follow_robust_boundary(const Joint& joint, const Axis& x, const Axis& y,
                                        const Uncertainty& uncertainty, const BoundaryRequest& request);

}  // namespace stickslip
