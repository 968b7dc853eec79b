#include "analysis/boundary/trace/continuation.h"

#include "analysis/boundary/trace/foretell.h"

#include <Eigen/Dense>
#include <vector>

namespace stickslip {

Eigen::VectorXd tangent_of(const Eigen::MatrixXd& jacobian, const Eigen::VectorXd& weight, const Eigen::VectorXd& along)
{
    const auto n = jacobian.cols();
    const Eigen::MatrixXd weighted = jacobian * weight.cwiseInverse().asDiagonal();
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(weighted, Eigen::ComputeFullV);
    Eigen::VectorXd tangent = svd.matrixV().col(n - 1).cwiseQuotient(weight);
    if (tangent.dot(weight.cwiseAbs2().cwiseProduct(along)) < 0) tangent = -tangent;
    return tangent;
}

std::optional<CurveState> solve_on(const CurveSystem& system, const Eigen::VectorXd& guess,
                                   const Eigen::VectorXd& constraint, const Eigen::VectorXd& weight,
                                   const Eigen::VectorXd& along, const Eigen::MatrixXd* near)
{
    constexpr int rounds = 4, steps = 5;
    constexpr double stalled = 0.3;  // a step that shrinks the residual less needs a new Jacobian
    CurveState state;
    state.z = guess;
    auto F = system.residual(state.z);
    if (!F) return {};
    const auto n = guess.size();
    for (int round = 0; round < rounds; ++round) {
        auto J = near && round == 0 ? std::optional(*near) : system.jacobian(state.z);
        if (!J || !J->allFinite()) return {};
        for (int k = 0; k < steps; ++k) {
            const double size = F->cwiseAbs().maxCoeff();
            if (size <= system.tolerance) {
                state.jacobian = *J;
                state.tangent = tangent_of(*J, weight, along);
                return state;
            }
            Eigen::VectorXd right(n);
            right << -*F, -constraint.dot(state.z - guess);
            Eigen::MatrixXd square(n, n);
            square << *J, constraint.transpose();
            const Eigen::VectorXd step = square.fullPivLu().solve(right);
            if (!step.allFinite() || step.cwiseProduct(weight).norm() > 1) return {};
            const Eigen::VectorXd moved = state.z + step;
            const auto G = system.residual(moved);
            if (!G) return {};
            state.z = moved;
            const Eigen::VectorXd direction = weight.cwiseAbs2().cwiseProduct(step);
            if (const double length = direction.dot(step); length > 0)
                *J += (*G - *F - *J * step) * direction.transpose() / length;
            const bool slow = !(G->cwiseAbs().maxCoeff() < stalled * size);
            F = G;
            if (slow) break;
        }
    }
    if (F->cwiseAbs().maxCoeff() > system.tolerance) return {};
    const auto J = system.jacobian(state.z);
    if (!J) return {};
    state.jacobian = *J;
    state.tangent = tangent_of(*J, weight, along);
    return state;
}

namespace {

/// The points behind a walk, by the length walked.
class Trail {
  public:
    void add(const Eigen::VectorXd& z, const Eigen::VectorXd& weight)
    {
        constexpr std::size_t kept = 6;
        const double before = lengths_.empty() ? 0 : lengths_.back();
        lengths_.push_back(points_.empty() ? 0 : before + (z - points_.back()).cwiseProduct(weight).norm());
        points_.push_back(z);
        if (points_.size() > kept) points_.erase(points_.begin()), lengths_.erase(lengths_.begin());
    }

    bool known() const { return points_.size() > 2; }

    /// Where the curve is after another h, each unknown foretold by itself.
    Eigen::VectorXd ahead(double h) const
    {
        Eigen::VectorXd z(points_.back().size());
        for (Eigen::Index i = 0; i < z.size(); ++i) {
            std::vector<double> values;
            for (const auto& p : points_) values.push_back(p[i]);
            z[i] = foretell(lengths_, values, lengths_.back() + h).value;
        }
        return z;
    }

  private:
    std::vector<Eigen::VectorXd> points_;
    std::vector<double> lengths_;
};

}  // namespace

bool walk_curve(const CurveSystem& system, const CurveState& start, const CurveWalk& options,
                const std::function<bool(const CurveState&, const CurveState&)>& visit)
{
    constexpr double strayed = 0.3;  // of a step, by which what is foretold may leave the tangent
    CurveState here = start;
    Trail trail;
    trail.add(here.z, options.weight(here.z));
    double h = options.first_step;
    int since_renewal = 0;
    for (int i = 0; i < options.limit && h >= options.shortest_step;) {
        const Eigen::VectorXd weight = options.weight(here.z);
        const Eigen::VectorXd tangent = here.tangent / here.tangent.cwiseProduct(weight).norm();
        const Eigen::VectorXd constraint = weight.cwiseAbs2().cwiseProduct(tangent);
        Eigen::VectorXd guess = here.z + h * tangent;
        if (trail.known())
            if (const Eigen::VectorXd ahead = trail.ahead(h); (ahead - guess).cwiseProduct(weight).norm() < strayed * h)
                guess = ahead;
        const bool renews = since_renewal + 1 >= options.renewal;
        const auto next = solve_on(system, guess, constraint, weight, tangent, renews ? nullptr : &here.jacobian);
        const double alike =
            next ? next->tangent.cwiseProduct(weight).normalized().dot(tangent.cwiseProduct(weight)) : -1;
        const double moved = next ? (next->z - here.z).cwiseProduct(weight).norm() : 0;
        if (!next || moved > 2 * h || (alike < std::cos(options.turn) && h > 4 * options.shortest_step)) {
            h *= 0.4;
            since_renewal = options.renewal;
            continue;
        }
        if (!visit(here, *next)) return true;
        here = *next;
        trail.add(here.z, weight);
        since_renewal = renews ? 0 : since_renewal + 1;
        ++i;
        if (alike > std::cos(0.4 * options.turn)) h = std::min(1.6 * h, options.longest_step);
    }
    return false;
}

}  // namespace stickslip
