#include "analysis/simulation/sampled/loop_mode.h"

#include <Eigen/Eigenvalues>

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
        mode.why = "the dead time is too many ticks long for the multipliers of the simulated loop";
        return mode;
    }
    const auto scale = state_scale(loop, n);
    Eigen::MatrixXd M(n, n);
    for (std::size_t j = 0; j < n; ++j) {
        Vector up = mode.steady, down = mode.steady;
        up[j] += difference * scale[j], down[j] -= difference * scale[j];
        const double change = (up[j] - down[j]) / scale[j];
        const Vector a = after_tick(loop, up), b = after_tick(loop, down);
        for (std::size_t i = 0; i < n; ++i)
            M(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = (a[i] - b[i]) / scale[i] / change;
    }
    loop.set_state(mode.steady);
    if (!M.allFinite()) {
        mode.why = "the loop leaves steady sliding within one tick";
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
