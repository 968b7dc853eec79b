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

double median(std::vector<double> values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
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
