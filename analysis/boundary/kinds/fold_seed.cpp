#include "analysis/boundary/kinds/fold_seed.h"

#include "analysis/simulation/attractor/attractor.h"
#include "analysis/simulation/attractor/bifurcation.h"
#include "analysis/simulation/attractor/large_disturbance.h"
#include "analysis/simulation/flows/mode.h"

#include <algorithm>

namespace stickslip {
namespace {

constexpr double small_orbit = 0.05;     ///< per scale, at which a branch is entered beside its Hopf point
constexpr double beyond = 0.3;           ///< share of the axis by which a branch may leave it
constexpr double share_of_orbit = 0.15;  ///< weight of a relative change of the orbit against one of the axis

/// Along a branch of orbits until the parameter turns back; nothing if it ends before.
std::optional<FoldSeed> to_the_turn(const OrbitSystem& system, const CurveState& start)
{
    const auto n = start.z.size();
    CurveWalk walk;
    walk.weight = [](const Eigen::VectorXd& z) { return orbit_weight(z, 1); };
    std::optional<FoldSeed> found;
    walk_curve(system.orbits(), start, walk, [&](const CurveState& before, const CurveState& here) {
        const double a = before.tangent[n - 1], b = here.tangent[n - 1];
        if (a * b < 0) {
            const Eigen::VectorXd turn = before.z + a / (a - b) * (here.z - before.z);
            found = FoldSeed{turn.head(n - 1), turn[n - 1]};
            return false;
        }
        const bool gone = here.z[n - 1] < -beyond || here.z[n - 1] > 1 + beyond;
        return !gone && here.z.head(n - 1).norm() > least_orbit;
    });
    return found;
}

}  // namespace

Eigen::VectorXd orbit_weight(const Eigen::VectorXd& z, int parameters)
{
    const auto section = z.size() - parameters;
    Eigen::VectorXd weight = Eigen::VectorXd::Ones(z.size());
    weight.head(section).setConstant(share_of_orbit / std::max(z.head(section).norm(), least_orbit));
    return weight;
}

bool is_subcritical(const Joint& joint)
{
    const auto [flow, reason] = sliding_flow(joint);
    if (reason != Reason::none || flow.states == 0) return false;
    const auto hopf = hopf_point(flow);
    return hopf.lyapunov > 1e-6 * hopf.omega;
}

std::optional<FoldSeed> fold_beyond_hopf(const OrbitSystem& system, double q)
{
    const auto [flow, reason] = sliding_flow(system.joint_at(Eigen::VectorXd::Constant(1, q)));
    if (reason != Reason::none || flow.states == 0) return {};
    const auto hopf = hopf_point(flow);
    if (!(hopf.omega > 0)) return {};
    const FlowVector y = flow.steady() + small_orbit * flow.scale()[0] * hopf.direction;
    const int n = system.section();
    Eigen::VectorXd guess(n + 1);
    guess << system.section_of(flow, y), q;
    // amplitude is given, the parameter answers
    const Eigen::VectorXd size = Eigen::VectorXd::Unit(n + 1, 0);
    Eigen::VectorXd growing = Eigen::VectorXd::Zero(n + 1);
    growing.head(n) = guess.head(n);
    const auto start = solve_on(system.orbits(), guess, size, orbit_weight(guess, 1), growing);
    return start ? to_the_turn(system, *start) : std::nullopt;
}

std::optional<FoldSeed> fold_beyond_cycle(const OrbitSystem& system, double q, int towards)
{
    const auto [flow, reason] = sliding_flow(system.joint_at(Eigen::VectorXd::Constant(1, q)));
    if (reason != Reason::none || flow.states == 0) return {};
    FollowOptions options;
    const auto large =
        follow(flow, disturbed(flow, slow_mode(flow), DisturbanceKind::start, near_rest_start), true, options);
    if (large.kind != Attractor::Kind::cycle || large.start.size() == 0 || !(large.velocity_min > 0)) return {};
    const int n = system.section();
    Eigen::VectorXd z(n + 1);
    z << system.section_of(flow, large.start), q;
    const Eigen::VectorXd parameter = Eigen::VectorXd::Unit(n + 1, n);
    const auto start = solve_on(system.orbits(), z, parameter, orbit_weight(z, 1), towards * parameter);
    return start ? to_the_turn(system, *start) : std::nullopt;
}

}  // namespace stickslip
