#include "sweep/study/time_series.h"

namespace stickslip {

std::vector<double> TimeSeries::sampled(double step, int count) const
{
    // the integral of the straight lines up to a time behind the first row
    std::size_t i = 0;
    double whole = 0;  // up to row i
    const auto integral = [&](double t) {
        while (i + 1 < time.size() && time[i + 1] - time[0] <= t) {
            whole += 0.5 * (value[i] + value[i + 1]) * (time[i + 1] - time[i]);
            ++i;
        }
        const double rest = t - (time[i] - time[0]);
        const bool last = i + 1 == time.size();
        const double slope = last ? 0 : (value[i + 1] - value[i]) / (time[i + 1] - time[i]);
        return whole + rest * (value[i] + 0.5 * slope * rest);
    };
    std::vector<double> means;
    double before = 0;
    for (int k = 1; k <= count; ++k) {
        const double now = integral(step * k);
        means.push_back((now - before) / step);
        before = now;
    }
    return means;
}

}  // namespace stickslip
