// Where a stability boundary lies: located points with their brackets, followed curves with what their search does not
// exclude, and margins of a design.
#pragma once
#include "analysis/results/point.h"
#include "analysis/results/stability_map.h"

#include <optional>
#include <string>
#include <vector>

namespace stickslip {

/// What lies on the two sides of a boundary.
enum class BoundaryKind {
    velocity_only,   ///< linear theory, friction replaced by its steady-state curve
    state_variable,  ///< linear theory with memory
    v_min,           ///< the same along the commanded velocity: from here on every faster one slides
    fold,            ///< limit cycles exist at all, stable or not
    outcome,         ///< the stated disturbance ends in steady sliding
    hunting          ///< a set point is hunted about
};
/// All of them, in the order of the enum.
inline constexpr BoundaryKind boundary_kinds[] = {BoundaryKind::velocity_only, BoundaryKind::state_variable,
                                                  BoundaryKind::v_min,         BoundaryKind::fold,
                                                  BoundaryKind::outcome,       BoundaryKind::hunting};

/// "velocity-only", "linear", "v-min", "fold", "outcome", "hunting".
std::string_view name_of(BoundaryKind kind);

/// Of a kind that the linear theory decides.
constexpr bool is_linear(BoundaryKind kind)
{
    return kind != BoundaryKind::fold && kind != BoundaryKind::outcome && kind != BoundaryKind::hunting;
}

/// How a point was located.
enum class LocationMethod {
    interpolation,  ///< bracketed root of a continuous measure
    bisection,      ///< only the side is known
    shooting        ///< closed orbits whose Floquet multiplier is one
};
/// "interpolation", "bisection", "shooting".
std::string_view name_of(LocationMethod method);

/// One located point of a boundary along one parameter. The true crossing lies within [low, high].
struct BoundaryPoint {
    double value = 0, low = 0, high = 0;  ///< of the parameter, and its bracket, in SI
    int direction = 0;       ///< +1: turns unstable as the parameter rises; −1: turns stable; 0: not known
    bool converged = false;  ///< false: the bracket is wider than requested
    int evaluations = 0;     ///< verdicts that it took
    LocationMethod method = LocationMethod::interpolation;  ///< how the bracket was narrowed

    /// Width of the bracket per |value|; where the value is 0, the width itself.
    double precision() const { return value != 0 ? (high - low) / (value < 0 ? -value : value) : high - low; }
};

/// One located point of a curve; its bracket lies along that axis which the curve crosses more steeply.
struct CurvePoint {
    double x = 0, y = 0;  ///< of the two parameters, in SI
    bool along_y = true;  ///< the bracket lies along y
    BoundaryPoint at;     ///< at.value is y if along_y, else x
};

/// Why a piece of a curve ends.
enum class CurveEnd {
    closed,     ///< it came back to its start
    border,     ///< it leaves the chart
    undecided,  ///< beyond lie points without a verdict
    vanished,   ///< limit cycles shrink to nothing: the fold meets the linear boundary
    lost        ///< could not be followed further
};
/// "closed", "border", "undecided", "vanished", "lost".
std::string_view name_of(CurveEnd end);

/// One connected piece of a boundary.
struct CurvePiece {
    std::vector<CurvePoint> points;                              ///< in order along the curve
    CurveEnd first = CurveEnd::border, last = CurveEnd::border;  ///< why it ends at either side
};

/// What watched over a chart while its curves were followed.
struct CurveGuard {
    int nodes = 0;        ///< points of the coarse grid
    int undecided = 0;    ///< of them without a verdict
    int changes = 0;      ///< edges of the grid whose ends lie on different sides
    int unexplained = 0;  ///< of them crossed by no followed piece
    int climbed = 0;      ///< nodes from which the nearest extremum was searched for islands between nodes
    int islands = 0;      ///< found that way
    double cell = 0;      ///< side of a cell as a share of an axis: closed pieces smaller than that can be missed
    int evaluations = 0;  ///< verdicts that it took
};

/// Neighbouring points of a scan, from the first to the last of them [SI].
struct ScanStretch {
    double low = 0;   ///< its first node [SI]
    double high = 0;  ///< its last one [SI]
};

/// What lies beyond the ends of a range that holds no boundary.
struct OutsideOfRay {
    double low = 0, high = 0;                  ///< the range that was looked at, that of the ray within it [SI]
    int nodes = 0;                             ///< points of the scans beyond the ends
    int undecided = 0;                         ///< of them without a verdict
    std::vector<ScanStretch> without_verdict;  ///< from the first to the last of neighbours without one, rising [SI]
    std::optional<BoundaryPoint> nearest;      ///< by the ratio to the end that it lies beyond; none was found
};

/// Every boundary of one kind along an axis.
struct LocatedRay {
    BoundaryKind kind = BoundaryKind::state_variable;  ///< of all its points
    Axis axis;                                         ///< values: only the ends
    std::vector<BoundaryPoint> points;                 ///< rising; empty: there is no boundary
    int nodes = 0;                                     ///< of the scan
    int undecided = 0;                                 ///< of them without a verdict
    std::vector<ScanStretch> without_verdict;  ///< from the first to the last of neighbours without one, rising [SI]
    Reason reason = Reason::none;              ///< why the first of these, or a value within a bracket, has none
    int climbed = 0;                           ///< extrema between nodes that were searched for a pair of boundaries
    int evaluations = 0;                       ///< verdicts that all of it took
    double stable_share = 0;   ///< of the scanned nodes: without a boundary, 1 if all are stable, 0 if none
    double neutral_share = 0;  ///< of the scanned nodes: a root on the imaginary axis
    /// Folds found by simulation alone: as a share of the range, the widest strip of cycles beside a linear boundary
    /// that the scan does not exclude; 0 where the branch of cycles is followed from there.
    double narrowest_strip = 0;
    std::optional<OutsideOfRay> outside;  ///< where there is none: what lies beyond, if that was looked for
};

/// A boundary followed over a chart.
struct FollowedBoundary {
    BoundaryKind kind = BoundaryKind::state_variable;  ///< of all its pieces
    Axis x, y;                                         ///< values: only the ends
    std::vector<CurvePiece> pieces;                    ///< connected ones; empty: no boundary was met
    CurveGuard guard;                                  ///< what says that no piece was missed
    bool by_sides = false;                             ///< folds found by simulation
    int evaluations = 0;                               ///< all, guard included

    int points() const;        ///< of all pieces together
    double precision() const;  ///< relative width of the widest bracket of its points
};

/// The same as a chart draws it.
Curve curve_of(const FollowedBoundary& boundary);

/// How far one parameter of a design may move alone before the state-variable boundary is met.
struct Margin {
    Axis axis;                 ///< values empty
    double value = 0;          ///< the design's
    bool found = false;        ///< whether the searched range holds a boundary at all
    double boundary = 0;       ///< nearest one
    double low = 0, high = 0;  ///< the searched range
};

/// How one parameter moves on the way to the nearest boundary.
struct NearestMove {
    std::string path, less;   ///< less: the parameter is path − less
    double from = 0, to = 0;  ///< the value of the joint, and at the boundary, in SI
};

/// The nearest boundary when several parameters may move at once.
struct NearestBoundary {
    bool decided = false;  ///< the joint itself has a verdict
    bool stable = false;   ///< which
    bool found = false;    ///< a boundary within reach
    /// √Σ (ln(to/from)/scale)²; where nothing was found as far as was searched: nothing lies nearer on the rays.
    /// Missing without a verdict.
    double distance = missing;
    std::vector<NearestMove> moves;  ///< of all coordinates at once, onto the boundary
    std::vector<double> direction;   ///< unit vector in the same coordinates
    int evaluations = 0;             ///< verdicts that it took
};

}  // namespace stickslip
