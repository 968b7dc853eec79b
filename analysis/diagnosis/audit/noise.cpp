#include "analysis/diagnosis/audit/noise.h"

#include "analysis/numerics/statistics.h"

#include <algorithm>
#include <cmath>

namespace stickslip::gap {
namespace {

/// Model noise that no two integrators agree on, as a part of the span of a signal.
constexpr double numerical_part = 2e-7;
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
    constexpr double normal = 1.4826, far = 5;
    double spread = normal * percentile(third, 0.5);
    if (spread == 0) return rms_below(infinity) / std::sqrt(20.0);
    for (int i = 0; i < 5; ++i) spread = rms_below(far * spread);
    return spread / std::sqrt(20.0);
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
    return reading * std::hypot(control.k_p, control.k_v * rate);
}

void share_noise(std::vector<Case>& cases, const Sensor& documented, std::vector<Note>& notes)
{
    constexpr double seldom = 0.5;  // of a step: what moves less than that is seen only in passing
    const double step = documented.encoder_quantum;
    double noise = 0, sigma = 0;
    for (const auto& c : cases) {
        noise = std::max(noise, c.joint.sensor.position_noise), sigma = std::max(sigma, c.sigma);
        if (c.joint.sensor.encoder_quantum != step) return;
    }
    if (documented.position_noise > 0 || sigma >= seldom * step) return;
    for (auto& c : cases) {
        if (c.sigma < sigma) notes.push_back({Note::Code::noise_of_noisiest, c.ticks.name});
        c.joint.sensor.position_noise = noise, c.sigma = sigma;
    }
}

}  // namespace stickslip::gap
