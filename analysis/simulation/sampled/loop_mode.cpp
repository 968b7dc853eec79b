#include "analysis/simulation/sampled/loop_mode.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

constexpr std::size_t most_states = 400;  ///< whose multipliers are worth their eigenvalues
constexpr double difference = 1e-4;       ///< of a state's scale, on both sides
constexpr double probe = 1e-4;            ///< of the scale: small beside what bends the motion
constexpr long most_window = 20'000;      ///< ticks

/// What counts as a change of order one of each entry of SampledLoop::state().
std::vector<double> state_scale(const SampledLoop& loop, std::size_t size)
{
    const auto& joint = loop.motion.joint;
    std::vector<double> scale(joint.scale().begin(), joint.scale().begin() + joint.size());
    const double reading = scale[joint.measured()] * joint.reading_ratio();
    const double speed = std::abs(loop.reference_velocity());
    const std::size_t taps = loop.taps();
    scale.insert(scale.end(), taps, reading);
    scale.push_back(speed);
    const double effort = reading * loop.stiffness();
    if (loop.continuous()) scale.push_back(speed), scale.push_back(effort);
    if (loop.integrates()) scale.push_back(effort / std::abs(loop.integral_gain()));
    if (loop.integrates() && loop.continuous()) scale.push_back(reading);
    scale.resize(size, effort);
    return scale;
}

using Vector = std::vector<double>;

/// Friction states that answer nothing while the joint slides on: an element that slips at its yield force. Below it
/// the element is back in the time of a yield, above it is nothing, so that a displacement of it is no small motion
/// about steady sliding.
std::vector<bool> at_yield(const SampledLoop& loop)
{
    const auto& joint = loop.motion.joint;
    const auto size = static_cast<std::size_t>(joint.size());
    std::vector<double> J(size * size);
    joint.jacobian(loop.motion.y.data(), J.data());
    std::vector<bool> held(size, false);
    for (int body = 0; body < joint.bodies(); ++body)
        for (int k = 0; k < joint.states(body); ++k) {
            const auto row = J.begin() + static_cast<std::ptrdiff_t>(size) * (joint.first_state(body) + k);
            held[static_cast<std::size_t>(joint.first_state(body)) + static_cast<std::size_t>(k)] =
                std::all_of(row, row + static_cast<std::ptrdiff_t>(size), [](double x) { return x == 0; });
        }
    return held;
}

Vector after_tick(SampledLoop& loop, const Vector& state)
{
    loop.set_state(state);
    loop.tick();
    return loop.state();
}

}  // namespace

std::complex<double> LoopMode::rate() const
{
    const auto s = std::log(multiplier) / period;
    return {s.real(), std::abs(s.imag())};
}

long LoopMode::window() const
{
    const auto s = rate();
    const double time = std::min(2 * std::numbers::pi / std::abs(s.imag()), std::log(3.0) / std::abs(s.real()));
    return std::clamp(std::lround(std::min(time / period, 1e15)), 1L, most_window);
}

LoopMode loop_mode(SampledLoop& loop)
{
    LoopMode mode;
    mode.period = loop.period();
    mode.steady = loop.state();
    const auto n = mode.steady.size();
    if (n > most_states) {
        mode.why = Detail::dead_time_too_long;
        return mode;
    }
    const auto scale = state_scale(loop, n);
    auto held = at_yield(loop);
    held.resize(n, false);
    Eigen::MatrixXd M = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(n));
    for (std::size_t j = 0; j < n; ++j) {
        if (held[j]) continue;
        Vector up = mode.steady, down = mode.steady;
        up[j] += difference * scale[j], down[j] -= difference * scale[j];
        const double change = (up[j] - down[j]) / scale[j];
        const Vector a = after_tick(loop, up), b = after_tick(loop, down);
        for (std::size_t i = 0; i < n; ++i)
            if (!held[i])
                M(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = (a[i] - b[i]) / scale[i] / change;
    }
    loop.set_state(mode.steady);
    if (!M.allFinite()) {
        mode.why = Detail::leaves_within_tick;
        return mode;
    }
    const Eigen::EigenSolver<Eigen::MatrixXd> right(M), left(M.transpose());
    Eigen::Index best = 0, same = 0;
    for (Eigen::Index i = 1; i < right.eigenvalues().size(); ++i)
        if (std::abs(right.eigenvalues()[i]) > std::abs(right.eigenvalues()[best])) best = i;
    const auto z = right.eigenvalues()[best];
    for (Eigen::Index i = 1; i < left.eigenvalues().size(); ++i)
        if (std::abs(left.eigenvalues()[i] - z) < std::abs(left.eigenvalues()[same] - z)) same = i;
    mode.multiplier = z;
    for (std::size_t i = 0; i < n; ++i) {
        const auto k = static_cast<Eigen::Index>(i);
        mode.right.push_back(right.eigenvectors()(k, best) * scale[i]);
        mode.left.push_back(left.eigenvectors()(k, same) / scale[i]);
    }
    return mode;
}

double measure_loop_growth(SampledLoop& loop, const LoopMode& mode)
{
    if (!mode.known()) return missing;
    const std::size_t n = mode.steady.size();
    const long window = mode.window();
    const auto size = [&](const Vector& up, const Vector& down) {
        std::complex<double> sum = 0;
        for (std::size_t i = 0; i < n; ++i) sum += mode.left[i] * (up[i] - down[i]);
        return std::abs(sum);
    };
    const auto rate_of = [&](double share) {
        Vector up = mode.steady, down = mode.steady;
        for (std::size_t i = 0; i < n; ++i)
            up[i] += share * mode.right[i].real(), down[i] -= share * mode.right[i].real();
        const double before = size(up, down);
        for (Vector* side : {&up, &down}) {
            loop.set_state(*side);
            for (long k = 0; k < window; ++k) loop.tick();
            *side = loop.state();
        }
        return std::log(size(up, down) / before) / (static_cast<double>(window) * mode.period);
    };
    // even powers of the disturbance cancel between the sides, the third between the sizes
    const double half = rate_of(0.5 * probe), whole = rate_of(probe);
    loop.set_state(mode.steady);
    return (4 * half - whole) / 3;
}

}  // namespace stickslip
