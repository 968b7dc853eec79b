#include "analysis/diagnosis/audit/reading_noise.h"

#include "analysis/diagnosis/policy/records.h"
#include "analysis/joint/gains.h"
#include "analysis/numerics/statistics.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>

namespace stickslip::gap {
namespace {

/// Model noise that no two integrators agree on, as a part of the span of a signal.
constexpr double numerical_part = 2e-7;  // numerical: of the span
}  // namespace

double noise_of(const std::vector<double>& y)
{
    if (y.size() < 8) return 0;
    std::vector<double> third;
    for (std::size_t k = 3; k < y.size(); ++k)
        if (const double d = std::abs(y[k] - 3 * y[k - 1] + 3 * y[k - 2] - y[k - 3]); std::isfinite(d))
            third.push_back(d);
    if (third.empty()) return 0;
    const auto rms_below = [&](double limit) {
        double sum = 0, n = 0;
        for (double d : third)
            if (d < limit) sum += d * d, n += 1;
        return n > 0 ? std::sqrt(sum / n) : 0;
    };
    // impacts and steps are rare and large, and are no noise; where most differences vanish all that is left is steps
    constexpr double normal = 1.4826, far = 5;  // numerical: of a median; spreads, of a trimmed one
    double spread = normal * percentile(third, 0.5);
    if (spread == 0) return rms_below(infinity) / std::sqrt(20.0);
    for (int i = 0; i < 5; ++i) spread = rms_below(far * spread);
    return spread / std::sqrt(20.0);
}

namespace {

constexpr std::array<double, 5> strides{1, 2, 3, 4, 6};  ///< numerical: rows between readings that are compared

/// Sum of the squares of the third difference's coefficients, weighed by the correlation of noise that keeps this part
/// of itself over a stride: var(Δ³y) = σ² (20 − 30 a + 12 a² − 2 a³).
double share_in_third(double kept)
{
    return 20 - kept * (30 - kept * (12 - 2 * kept));
}

/// σ² of noise that keeps a part of itself from row to row, and the RMS of what it leaves, relative, of the noise seen
/// at each stride. Smooth motion adds its jerk, which grows with the sixth power of the stride.
struct Memory {
    double variance = 0, left = infinity, kept = 0;
};
Memory with_memory(const std::array<double, strides.size()>& seen, double kept)
{
    Eigen::Matrix<double, strides.size(), 2> part;
    for (std::size_t i = 0; i < strides.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        part(row, 0) = share_in_third(std::pow(kept, strides[i])) / 20 / (seen[i] * seen[i]);
        part(row, 1) = std::pow(strides[i], 6) / (seen[i] * seen[i]);
    }
    const Eigen::VectorXd one = Eigen::VectorXd::Ones(part.rows());
    Eigen::Vector2d found = part.colPivHouseholderQr().solve(one);
    if (found[1] < 0) found = {part.col(0).sum() / part.col(0).squaredNorm(), 0};
    if (!(found[0] > 0)) return {};
    return {found[0], std::sqrt((part * found - one).squaredNorm() / static_cast<double>(strides.size())), kept};
}

}  // namespace

ReadingNoise noise_with_memory(const std::vector<double>& y)
{
    constexpr std::size_t fewest = 600;  // numerical: a hundred readings at the widest stride
    const ReadingNoise white{noise_of(y)};
    std::array<double, strides.size()> seen{};
    for (std::size_t i = 0; i < strides.size(); ++i) {
        std::vector<double> some;
        const auto stride = static_cast<std::size_t>(strides[i]);
        for (std::size_t k = 0; k < y.size(); k += stride) some.push_back(y[k]);
        seen[i] = noise_of(some);
        if (!(seen[i] > 0)) return white;
    }
    if (y.size() < fewest) return white;
    const Memory none = with_memory(seen, 0);
    Memory best = none;
    constexpr int steps = 20;  // numerical: of the part that noise keeps
    for (int i = 1; i < steps; ++i)
        if (const auto m = with_memory(seen, static_cast<double>(i) / steps); m.left < best.left) best = m;
    // motion that is no jerk alone fits neither: with its memory the noise has to fit as white noise does
    const bool coloured = none.left > policy::noise_not_white &&
                          best.left < std::min(policy::noise_not_white, policy::noise_with_memory_leaves * none.left);
    return coloured && best.variance > white.sigma * white.sigma ? ReadingNoise{std::sqrt(best.variance), best.kept}
                                                                 : white;
}

double span_of(const std::vector<double>& values)
{
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    return values.empty() ? 0 : *high - *low;
}

double reading_sigma(const Sensor& sensor, double span)
{
    const double numerical = numerical_part * span;
    return std::sqrt(sensor.position_noise * sensor.position_noise +
                     sensor.encoder_quantum * sensor.encoder_quantum / 12 + numerical * numerical);
}

double noise_of_command(const Control& control, double reading)
{
    const double rate = std::sqrt(2.0) / (control.period + control.velocity_estimate.tau);
    const Gains gains = gains_of(control);  // a cascade has no k_p of its own
    return reading * std::hypot(gains.k_p, gains.k_v * rate);
}

void share_noise(std::vector<Case>& cases, const Sensor& documented, std::vector<Note>& notes)
{
    const double step = documented.encoder_quantum;
    double noise = 0, sigma = 0;
    for (const auto& c : cases) {
        noise = std::max(noise, c.joint.sensor.position_noise), sigma = std::max(sigma, c.sigma);
        if (c.joint.sensor.encoder_quantum != step) return;
    }
    if (documented.position_noise > 0 || sigma >= policy::seldom_a_step * step) return;
    for (auto& c : cases) {
        if (c.sigma < sigma) notes.push_back({Note::Code::noise_of_noisiest, c.ticks.name});
        c.joint.sensor.position_noise = noise, c.sigma = sigma;
    }
}

}  // namespace stickslip::gap
