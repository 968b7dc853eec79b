#include "analysis/boundary/kinds/fold_chart.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>

namespace stickslip {
namespace {

constexpr double fine_rtol = 1e-11;       ///< with which the error of a fold is estimated
constexpr double bracket_per_error = 4;   ///< the bracket is that many estimated errors wide on each side
constexpr double repeatability = 1e-8;    ///< relative: what two ways of arriving at one fold differ by at most
constexpr int jacobian_renewal = 6;       ///< points along a curve of folds
constexpr double vanishing_orbit = 0.02;  ///< per scale, below which a fold has met the linear boundary

}  // namespace

std::optional<CurveState> FoldChart::solve(const Eigen::VectorXd& guess, int held) const
{
    const Eigen::VectorXd constraint = Eigen::VectorXd::Unit(guess.size(), section() + held);
    const Eigen::VectorXd along = Eigen::VectorXd::Unit(guess.size(), section() + 1 - held);
    return solve_on(system_, guess, constraint, orbit_weight(guess, 2), along);
}

CurvePoint FoldChart::located(const CurveState& s, bool along_y, double precision) const
{
    const int n = section(), p = n + (along_y ? 1 : 0), before = turns();
    const auto coarse = orbits_.turn(s.z), fine = orbits_.turn(s.z, fine_rtol);
    const UnitAxis& unit = orbits_.unit(along_y ? 1 : 0);
    CurvePoint point;
    point.along_y = along_y;
    point.x = orbits_.unit(0).value(s.z[n]);
    point.y = orbits_.unit(1).value(s.z[n + 1]);
    const double value = along_y ? point.y : point.x;
    point.at.value = point.at.low = point.at.high = value;
    point.at.method = LocationMethod::shooting;
    if (!coarse || !fine) return point;
    // the left null vector of map − 1 turns what is left of the gap into a distance along the parameter
    const Eigen::MatrixXd singular = coarse->map - Eigen::MatrixXd::Identity(n, n);
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(singular, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const Eigen::VectorXd left = svd.matrixU().col(n - 1), right = svd.matrixV().col(n - 1);
    const double drive = left.dot(s.jacobian.col(p).head(n)) * std::max(0.05, s.z.head(n).norm());
    const double error =
        (std::abs(left.dot(coarse->gap)) + std::abs(left.dot(fine->gap - coarse->gap))) / std::abs(drive);
    const double q = s.z[p], width = bracket_per_error * error;
    const double a = unit.value(q - width), b = unit.value(q + width), apart = repeatability * std::abs(value);
    point.at.low = std::min(a, b) - apart, point.at.high = std::max(a, b) + apart;
    point.at.converged = point.at.precision() <= precision;
    // gap ≈ drive · δq + ½ curvature · s² along the null vector: cycles exist where both have different signs
    double others = 1;
    const Eigen::VectorXcd multipliers = coarse->map.eigenvalues();
    Eigen::Index nearest = 0;
    for (Eigen::Index i = 1; i < n; ++i)
        if (std::abs(multipliers[i] - 1.0) < std::abs(multipliers[nearest] - 1.0)) nearest = i;
    std::complex<double> product = 1;
    for (Eigen::Index i = 0; i < n; ++i)
        if (i != nearest) product *= multipliers[i] - 1.0;
    others = product.real();
    const double curvature = s.jacobian.row(n).head(n).dot(right) * left.dot(right) / others;
    point.at.direction = curvature * drive < 0 ? 1 : -1;
    point.at.evaluations = turns() - before;
    return point;
}

FoldChart::Way FoldChart::walk(const CurveState& start, const FollowingOptions& options, double precision) const
{
    const int n = section();
    Way way;
    // at once, while the turn that closes the orbit is still at hand
    const auto keep = [&](const CurveState& s) {
        const bool along_y = std::abs(s.tangent[n]) >= std::abs(s.tangent[n + 1]);
        way.states.push_back(s);
        way.points.push_back(located(s, along_y, precision));
    };
    keep(start);
    CurveWalk walking;
    walking.longest_step = options.longest_step > 0 ? options.longest_step : default_step(true);
    walking.first_step = 0.25 * walking.longest_step;
    walking.limit = options.point_limit;
    walking.renewal = jacobian_renewal;
    walking.weight = [](const Eigen::VectorXd& z) { return orbit_weight(z, 2); };
    const bool reached_end = walk_curve(system_, start, walking, [&](const CurveState& before, const CurveState& here) {
        const UnitPoint a = place(before), b = place(here);
        if (!b.inside()) {
            const std::array<double, 4> beyond{-b.u, b.u - 1, -b.v, b.v - 1};
            const auto worst = std::max_element(beyond.begin(), beyond.end()) - beyond.begin();
            const int held = worst < 2 ? 0 : 1;
            const double border = worst % 2 == 0 ? 0 : 1, from = held == 0 ? a.u : a.v, to = held == 0 ? b.u : b.v;
            Eigen::VectorXd guess = before.z + (border - from) / (to - from) * (here.z - before.z);
            guess[n + held] = border;
            if (std::abs(border - from) > 1e-9)
                if (const auto last = solve(guess, held)) keep(*last);
            way.end = CurveEnd::border;
            return false;
        }
        if (here.z.head(n).norm() < vanishing_orbit) {
            way.end = CurveEnd::vanished;
            return false;
        }
        const UnitPoint first = place(start), step = b - a;
        const double length2 = step.dot(step), along = length2 > 0 ? (first - a).dot(step) / length2 : -1;
        const bool back = way.states.size() > 4 && along > 0 && along <= 1 &&
                          std::abs((first - a).cross(step)) < 0.3 * length2 &&
                          (here.z - start.z).head(n).norm() < 0.3 * start.z.head(n).norm();
        if (back) {
            way.end = CurveEnd::closed;
            return false;
        }
        keep(here);
        return true;
    });
    // a walk that gets stuck among ever smaller cycles has met the linear boundary
    if (!reached_end && way.states.back().z.head(n).norm() < 5 * vanishing_orbit) way.end = CurveEnd::vanished;
    return way;
}

CurvePiece FoldChart::follow(const CurveState& start, const FollowingOptions& options, double precision,
                             std::vector<UnitPoint>& path) const
{
    CurvePiece piece;
    const auto forwards = walk(start, options, precision);
    Way backwards;
    if (forwards.end != CurveEnd::closed) {
        CurveState turned = start;
        turned.tangent = -turned.tangent;
        backwards = walk(turned, options, precision);
    }
    piece.last = forwards.end;
    piece.first = forwards.end == CurveEnd::closed ? CurveEnd::closed : backwards.end;
    const auto add = [&](const Way& way, std::size_t i) {
        piece.points.push_back(way.points[i]);
        path.push_back(place(way.states[i]));
    };
    for (std::size_t i = backwards.states.size(); i-- > 1;) add(backwards, i);
    for (std::size_t i = 0; i < forwards.states.size(); ++i) add(forwards, i);
    return piece;
}

}  // namespace stickslip
