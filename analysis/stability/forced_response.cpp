#include "analysis/stability/forced_response.h"

#include <Eigen/Dense>
#include <cmath>
#include <random>
#include <stdexcept>
#include <unsupported/Eigen/MatrixFunctions>

#include "analysis/stability/delayed_response.h"
#include "analysis/stability/joint_spectrum.h"

namespace stickslip {

SampledForce sampled_force(ForceKind kind, double size, double duration, double step, double omega, std::uint64_t seed)
{
    if (!(step > 0) || !(duration >= step)) throw std::invalid_argument("a sampled force needs 0 < step ≤ duration");
    SampledForce force;
    force.step = step;
    force.value.assign(static_cast<std::size_t>(std::llround(duration / step)), 0.0);
    std::mt19937_64 random(seed);
    const auto uniform = [&] { return (static_cast<double>(random() >> 11) + 0.5) * 0x1p-53; };
    for (std::size_t i = 0; i < force.value.size(); ++i) {
        // Box and Muller by hand: the standard's normal distribution differs between libraries
        if (kind == ForceKind::noise)
            force.value[i] = size * std::sqrt(-2 * std::log(uniform())) * std::cos(2 * M_PI * uniform());
        if (kind == ForceKind::step) force.value[i] = size;
        if (kind == ForceKind::sine) force.value[i] = size * std::sin(omega * step * (static_cast<double>(i) + 0.5));
    }
    if (kind == ForceKind::impulse) force.impulse = size;
    return force;
}

ForcedResponse forced_response(const LinearJoint& j, const SampledForce& force)
{
    if (!j.rational()) return delayed_response(j, force);
    const Eigen::MatrixXd A = state_matrix(j);
    const Eigen::Index n = A.rows(), link = j.link(), speed = j.bodies + link;
    // exp of [A b; 0 0] holds e^{Ah} and ∫ e^{As} b ds side by side
    Eigen::MatrixXd held = Eigen::MatrixXd::Zero(n + 1, n + 1);
    held.topLeftCorner(n, n) = A;
    const Eigen::VectorXd pushed = rates_per_force(j, j.link());
    held.col(n).head(n) = pushed;
    const Eigen::MatrixXd step = (held * force.step).exp();
    Eigen::VectorXd y = Eigen::VectorXd::Zero(n + 1);
    y.head(n) = force.impulse * pushed;
    ForcedResponse response;
    const auto keep = [&](double t) {
        response.time.push_back(t);
        response.position.push_back(y[link]);
        response.velocity.push_back(y[speed]);
    };
    keep(0);
    for (std::size_t i = 0; i < force.value.size(); ++i) {
        y[n] = force.value[i];
        y = step * y;
        keep(force.step * static_cast<double>(i + 1));
    }
    return response;
}

}  // namespace stickslip
