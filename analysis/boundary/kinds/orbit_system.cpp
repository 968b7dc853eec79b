#include "analysis/boundary/kinds/orbit_system.h"

#include "analysis/joint/parameters.h"

#include <Eigen/Dense>
#include <algorithm>
#include <stdexcept>

namespace stickslip {
namespace {

constexpr double shift = 1e-5;    ///< of an unknown, per its size, for differences
constexpr double closure = 2e-9;  ///< of an orbit, per its size

double orbit_size(const Eigen::VectorXd& z, int section)
{
    return std::max(0.05, z.head(section).norm());
}

FlowVector without_speed(const FlowVector& y)
{
    FlowVector w(y.size() - 1);
    w[0] = y[0];
    w.tail(y.size() - 2) = y.tail(y.size() - 2);
    return w;
}

}  // namespace

OrbitSystem::OrbitSystem(const Joint& joint, const std::vector<Axis>& axes, double rtol) : joint_(joint), rtol_(rtol)
{
    for (const auto& axis : axes) {
        paths_.push_back(axis.path);
        units_.emplace_back(axis);
        if (!find_parameter(joint_, axis.path)) throw std::invalid_argument("no number at " + axis.path);
    }
    section_ = 1 + sliding_flow(joint).flow.states;
}

Joint OrbitSystem::joint_at(const Eigen::VectorXd& q) const
{
    Joint joint = joint_;
    for (std::size_t i = 0; i < paths_.size(); ++i)
        number_at(joint, paths_[i]) = units_[i].value(q[static_cast<Eigen::Index>(i)]);
    return joint;
}

Eigen::VectorXd OrbitSystem::section_of(const Flow& flow, const FlowVector& y) const
{
    return without_speed((y - flow.steady()).cwiseQuotient(flow.scale()));
}

std::optional<OrbitTurn> OrbitSystem::turn(const Eigen::VectorXd& z, double rtol) const
{
    if (rtol > 0) return followed_turn(z, rtol);
    if (last_z_.size() != z.size() || last_z_ != z) last_turn_ = followed_turn(z, rtol_), last_z_ = z;
    return last_turn_;
}

std::optional<OrbitTurn> OrbitSystem::followed_turn(const Eigen::VectorXd& z, double rtol) const
{
    const auto [flow, reason] = sliding_flow(joint_at(z.tail(parameters())));
    if (reason != Reason::none || 1 + flow.states != section_) return {};
    const int n = flow.size();
    const FlowVector scale = flow.scale(), steady = flow.steady();
    FlowVector start = steady;
    start[0] += scale[0] * z[0];
    for (int i = 2; i < n; ++i) start[i] += scale[i] * z[i - 1];
    CycleOptions options;
    // small orbits ask for more, and cost less
    options.rtol = rtol * std::clamp(z.head(section_).norm() / 3, 0.01, 1.0);
    ++turns_;
    const auto revolution = revolve(flow, start, options);
    if (!revolution) return {};
    FlowVector rate;
    flow.rate(revolution->end, rate);
    const FlowVector normal = flow.speed_gradient(revolution->end);
    const FlowMatrix onto = FlowMatrix::Identity(n, n) - rate * normal.transpose() / normal.dot(rate);
    const FlowMatrix moved = scale.cwiseInverse().asDiagonal() * (onto * revolution->displacement) * scale.asDiagonal();
    OrbitTurn t;
    t.path = revolution->path;
    t.gap = without_speed((revolution->end - start).cwiseQuotient(scale));
    t.map.resize(n - 1, n - 1);
    const auto place = [](int i) { return i == 0 ? 0 : i + 1; };
    for (int i = 0; i < n - 1; ++i)
        for (int j = 0; j < n - 1; ++j) t.map(i, j) = moved(place(i), place(j));
    t.fold = (t.map - Eigen::MatrixXd::Identity(n - 1, n - 1)).determinant();
    return t;
}

std::optional<Eigen::VectorXd> OrbitSystem::equations(const Eigen::VectorXd& z, bool with_fold) const
{
    const auto t = turn(z);
    if (!t) return {};
    Eigen::VectorXd F(section_ + with_fold);
    F.head(section_) = t->gap / orbit_size(z, section_);
    // what is left of the determinant shifts the fold by its square only
    if (with_fold) F[section_] = 1e-3 * t->fold;
    return F;
}

std::optional<Eigen::MatrixXd> OrbitSystem::derivatives(const Eigen::VectorXd& z, bool with_fold) const
{
    const auto here = turn(z);
    if (!here) return {};
    const int unknowns = section_ + parameters();
    Eigen::MatrixXd J = Eigen::MatrixXd::Zero(section_ + with_fold, unknowns);
    J.topLeftCorner(section_, section_) = here->map - Eigen::MatrixXd::Identity(section_, section_);
    for (int j = with_fold ? 0 : section_; j < unknowns; ++j) {
        const double h = j < section_ ? shift * std::max(1e-3, z.head(section_).norm()) : 0.1 * shift;
        Eigen::VectorXd beside = z;
        beside[j] += h;
        const auto there = turn(beside);
        if (!there) return {};
        if (j >= section_) J.col(j).head(section_) = (there->gap - here->gap) / h;
        if (with_fold) J(section_, j) = 1e-3 * (there->fold - here->fold) / h;
    }
    J.topRows(section_) /= orbit_size(z, section_);
    return J;
}

CurveSystem OrbitSystem::orbits() const
{
    return {[this](const Eigen::VectorXd& z) { return equations(z, false); },
            [this](const Eigen::VectorXd& z) { return derivatives(z, false); }, closure};
}

CurveSystem OrbitSystem::folds() const
{
    return {[this](const Eigen::VectorXd& z) { return equations(z, true); },
            [this](const Eigen::VectorXd& z) { return derivatives(z, true); }, closure};
}

}  // namespace stickslip
