#include "sweep/files/records/signal_measures.h"

#include "analysis/diagnosis/records/ticks.h"

#include <algorithm>
#include <cmath>

namespace stickslip::files {

double spread(const std::vector<double>& values)
{
    double sum = 0, squares = 0, n = 0;
    for (double v : values) {
        if (std::isnan(v)) continue;
        sum += v;
        squares += v * v;
        ++n;
    }
    return n > 1 ? std::sqrt(std::max(0.0, squares / n - sum / n * (sum / n))) : 0;
}

double wrong_factor(double ratio, Motion motion)
{
    const double unit = motion == Motion::revolute ? degrees : 1000;
    for (const double factor : {unit, 1 / unit})
        if (ratio > factor / near_factor && ratio < factor * near_factor) return factor;
    return 0;
}

std::vector<double> differentiated(const std::vector<double>& time, const std::vector<double>& values)
{
    std::vector<double> rate(values.size(), not_set);
    for (std::size_t k = 1; k + 1 < values.size(); ++k)
        rate[k] = (values[k + 1] - values[k - 1]) / (time[k + 1] - time[k - 1]);
    return rate;
}

double size_of_rate(const std::vector<double>& time, const std::vector<double>& values,
                    const std::vector<double>& rates)
{
    constexpr std::size_t windows = 100, few = 20;
    constexpr double together = 0.9;  // correlation
    if (rates.size() != values.size() || values.size() < few) return 0;
    const std::size_t width = std::max<std::size_t>(1, values.size() / windows);
    double of_rates = 0, of_values = 0, of_both = 0;
    for (std::size_t k = 0; k + width < values.size(); k += width) {
        double mean = 0;
        for (std::size_t i = k; i < k + width; ++i)
            mean += 0.5 * (rates[i] + rates[i + 1]) / static_cast<double>(width);
        const double moved = (values[k + width] - values[k]) / (time[k + width] - time[k]);
        if (!std::isfinite(mean) || !std::isfinite(moved)) continue;
        of_rates += mean * mean, of_values += moved * moved, of_both += mean * moved;
    }
    const bool alike = of_values > 0 && of_both > together * std::sqrt(of_rates * of_values);
    return alike ? std::sqrt(of_rates / of_values) : 0;
}

double correlation(const std::vector<double>& a, const std::vector<double>& b)
{
    double n = 0, sum_a = 0, sum_b = 0, squares_a = 0, squares_b = 0, products = 0;
    for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k) {
        if (!std::isfinite(a[k]) || !std::isfinite(b[k])) continue;
        n += 1, sum_a += a[k], sum_b += b[k];
        squares_a += a[k] * a[k], squares_b += b[k] * b[k], products += a[k] * b[k];
    }
    const double square = (n * squares_a - sum_a * sum_a) * (n * squares_b - sum_b * sum_b);
    return square > 0 ? (n * products - sum_a * sum_b) / std::sqrt(square) : 0;
}

}  // namespace stickslip::files
