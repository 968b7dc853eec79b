// Following the solutions of N equations in N + 1 unknowns by tangents and Newton's method: it goes around turns,
// because the length along the curve, unlike any of its unknowns, does not turn back.
#pragma once
#include <Eigen/Core>
#include <functional>
#include <optional>

namespace stickslip {

/// F(z) = 0, F from R^{N+1} to R^N. Both may fail (nothing): the equations have no meaning there.
struct CurveSystem {
    std::function<std::optional<Eigen::VectorXd>(const Eigen::VectorXd& z)> residual;
    std::function<std::optional<Eigen::MatrixXd>(const Eigen::VectorXd& z)> jacobian;  ///< N × (N+1)
    double tolerance = 1e-9;                                                           ///< largest component of F
};

/// A point of the curve with the direction in which it goes on, of length one in the weights of the walk.
struct CurveState {
    Eigen::VectorXd z, tangent;
    Eigen::MatrixXd jacobian;
};

/// The unit vector of the kernel of the Jacobian, in coordinates z_i · weight_i; its sign is that of `along`·tangent.
Eigen::VectorXd tangent_of(const Eigen::MatrixXd& jacobian, const Eigen::VectorXd& weight,
                           const Eigen::VectorXd& along);

/// Newton from `guess` on F(z) = 0 and constraint·(z − guess) = 0, with one Jacobian for all steps unless they stall:
/// `near`, if given, of a point nearby, else that at the guess. Each step corrects it (Broyden's update).
std::optional<CurveState> solve_on(const CurveSystem& system, const Eigen::VectorXd& guess,
                                   const Eigen::VectorXd& constraint, const Eigen::VectorXd& weight,
                                   const Eigen::VectorXd& along, const Eigen::MatrixXd* near = nullptr);

struct CurveWalk {
    double first_step = 0.01, longest_step = 1.0 / 24, shortest_step = 1e-5;  ///< in the weights
    double turn = 0.3;                                                        ///< rad between neighbouring tangents
    int limit = 600;
    int renewal = 1;  ///< points between Jacobians that are computed afresh
    /// What a change of order one of each unknown is, inverted; evaluated anew at each point.
    std::function<Eigen::VectorXd(const Eigen::VectorXd& z)> weight;
};

/// Walks from `start` in the direction of its tangent and shows each new point to `visit`, until that says no (true is
/// returned) or the curve is lost (false).
bool walk_curve(const CurveSystem& system, const CurveState& start, const CurveWalk& options,
                const std::function<bool(const CurveState& before, const CurveState& here)>& visit);

}  // namespace stickslip
