#include "sweep/study/import/arm_load.h"

#include "analysis/diagnosis/audit/reading_noise.h"
#include "analysis/numerics/seeded_noise.h"
#include "sweep/study/import/placed.h"

#include <Eigen/QR>

#include <stdexcept>
#include <utility>

namespace stickslip {
namespace {

using Vector = Eigen::Vector3d;

/// How a body moves: its angular velocity and acceleration, and the acceleration of the point of it that is at `at`.
/// Gravity is an acceleration of the ground upwards.
struct Moving {
    Vector turn = Vector::Zero(), turning = Vector::Zero();
    Vector at = Vector::Zero(), acceleration = Vector::Zero();

    Vector acceleration_of(const Vector& point) const
    {
        const Vector arm = point - at;
        return acceleration + turning.cross(arm) + turn.cross(turn.cross(arm));
    }
};

Moving behind(const Moving& before, const RobotJoint& joint, const Vector& axis, const Vector& anchor, double speed,
              double acceleration)
{
    Moving after = before;
    if (joint.kind == RobotJointKind::hinge) {
        after.at = anchor;
        after.acceleration = before.acceleration_of(anchor);
        after.turning += acceleration * axis + before.turn.cross(speed * axis);
        after.turn += speed * axis;
    } else if (joint.kind == RobotJointKind::slide) {
        after.acceleration += acceleration * axis + 2 * before.turn.cross(speed * axis);
    }
    return after;
}

/// Inertial force and moment of a body about its centre of mass.
struct Inertial {
    Vector centre, force, moment;
};

std::vector<Inertial> inertial_forces(const Robot& robot, const Placed& at, const std::vector<double>& dq,
                                      const std::vector<double>& ddq)
{
    std::vector<Moving> moving(robot.bodies.size());
    std::vector<Inertial> forces(robot.bodies.size());
    Moving ground;
    ground.acceleration = -robot.gravity;
    for (std::size_t b = 0; b < robot.bodies.size(); ++b) {
        const auto& body = robot.bodies[b];
        Moving now = body.parent < 0 ? ground : moving[static_cast<std::size_t>(body.parent)];
        for (const int i : body.joints) {
            const auto j = static_cast<std::size_t>(i);
            now = behind(now, robot.joints[j], at.axis[j], at.anchor[j], dq[j], ddq[j]);
        }
        moving[b] = now;
        const Eigen::Matrix3d turned = at.body[b].linear();
        const Eigen::Matrix3d inertia = turned * body.inertia * turned.transpose();
        const Vector centre = at.body[b] * body.centre;
        const Vector held = body.held_weight * body.mass * robot.gravity;
        forces[b] = {centre, body.mass * now.acceleration_of(centre) + held,
                     inertia * now.turning + now.turn.cross(inertia * now.turn)};
    }
    return forces;
}

}  // namespace

std::vector<double> inverse_dynamics(const Robot& robot, const std::vector<double>& q, const std::vector<double>& dq,
                                     const std::vector<double>& ddq)
{
    const Placed at = place(robot, q);
    const auto forces = inertial_forces(robot, at, dq, ddq);
    std::vector<double> efforts(robot.joints.size());
    for (std::size_t j = 0; j < efforts.size(); ++j) {
        Vector force = Vector::Zero(), moment = Vector::Zero();  // about the joint's anchor
        for (std::size_t b = 0; b < forces.size(); ++b) {
            if (!moves(robot, static_cast<int>(j), static_cast<int>(b))) continue;
            force += forces[b].force;
            moment += forces[b].moment + (forces[b].centre - at.anchor[j]).cross(forces[b].force);
        }
        efforts[j] = at.axis[j].dot(robot.joints[j].kind == RobotJointKind::slide ? force : moment);
    }
    return efforts;
}

JointMotion smoothed(const std::vector<double>& time, const std::vector<double>& position, double window)
{
    constexpr std::size_t least_rows = 5;  // a cubic has four numbers
    JointMotion motion;
    std::size_t from = 0, to = 0;
    for (std::size_t row = 0; row < time.size(); ++row) {
        // at both ends the window stays whole and the row is not in its middle: half of one would leave much more noise
        const double begin = std::max(time.front(), std::min(time[row] - window / 2, time.back() - window));
        const double rounding = 1e-9 * window;
        while (time[from] < begin - rounding) ++from;
        while (to < time.size() && time[to] <= begin + window + rounding) ++to;
        const auto n = to - from;
        if (n < least_rows)
            throw std::invalid_argument("has " + std::to_string(n) + " rows within the window round t = " +
                                        std::to_string(time[row]) + " s, expected at least 5: take a longer window");
        Eigen::MatrixX4d powers(n, 4);
        Eigen::VectorXd values(n);
        for (std::size_t i = 0; i < n; ++i) {
            const double s = (time[from + i] - time[row]) / window;  // of order 1, so that powers stay comparable
            const auto r = static_cast<Eigen::Index>(i);
            powers.row(r) << 1, s, s * s, s * s * s;
            values[r] = position[from + i] - position[row];
        }
        const Eigen::Vector4d c = powers.householderQr().solve(values);
        motion.position.push_back(position[row] + c[0]);
        motion.velocity.push_back(c[1] / window);
        motion.acceleration.push_back(2 * c[2] / (window * window));
    }
    return motion;
}

namespace {

/// What a cubic through a window makes of accelerations: their mean with the weights (1 − (2s/w)²)², which are the
/// twofold integral of the weights that it gives the positions.
std::vector<double> smeared(const std::vector<double>& time, const std::vector<double>& x, double window)
{
    std::vector<double> mean;
    std::size_t from = 0;
    for (std::size_t row = 0; row < time.size(); ++row) {
        while (time[from] < time[row] - window / 2) ++from;
        double sum = 0, weights = 0;
        for (std::size_t i = from; i < time.size() && time[i] <= time[row] + window / 2; ++i) {
            const double s = 2 * (time[i] - time[row]) / window, weight = (1 - s * s) * (1 - s * s);
            sum += weight * x[i], weights += weight;
        }
        mean.push_back(sum / weights);
    }
    return mean;
}

}  // namespace

JointMotion measured_again(const std::vector<double>& time, const std::vector<double>& position,
                           const JointMotion& motion, double window, std::uint64_t seed)
{
    const double sigma = gap::noise_of(position);
    SeededNoise noise(seed);
    std::vector<double> noisy = motion.position;
    for (double& q : noisy) q += sigma * noise();
    const auto with = smoothed(time, noisy, window), without = smoothed(time, motion.position, window);
    JointMotion again = motion;
    again.acceleration = smeared(time, motion.acceleration, window);
    for (std::size_t k = 0; k < time.size(); ++k) {
        again.position[k] += with.position[k] - without.position[k];
        again.velocity[k] += with.velocity[k] - without.velocity[k];
        again.acceleration[k] += with.acceleration[k] - without.acceleration[k];
    }
    return again;
}

std::vector<JointLoad> arm_loads(const Robot& robot, const std::vector<int>& moved,
                                 const std::vector<JointMotion>& joint_motions, const std::vector<double>& pose)
{
    std::vector<JointLoad> loads(moved.size());
    const std::size_t rows = joint_motions.empty() ? 0 : joint_motions.front().position.size();
    std::vector<double> q = pose, dq(pose.size()), ddq(pose.size());
    for (std::size_t row = 0; row < rows; ++row) {
        for (std::size_t k = 0; k < moved.size(); ++k) {
            const auto j = static_cast<std::size_t>(moved[k]);
            q[j] = joint_motions[k].position[row], dq[j] = joint_motions[k].velocity[row],
            ddq[j] = joint_motions[k].acceleration[row];
        }
        for (std::size_t k = 0; k < moved.size(); ++k) {
            const auto j = static_cast<std::size_t>(moved[k]);
            // its own acceleration is what the load and the drive make of it: without it the effort is that of the rest
            const double own = std::exchange(ddq[j], 0.0);
            loads[k].load.push_back(-inverse_dynamics(robot, q, dq, ddq)[j]);
            loads[k].inertia.push_back(axis_dynamics(robot, moved[k], q).inertia);
            ddq[j] = own;
        }
    }
    return loads;
}

}  // namespace stickslip
