#include "sweep/study/samples.h"

#include <cmath>

namespace stickslip {

std::vector<double> log_steps(double low, double high, int count)
{
    std::vector<double> values;
    for (int i = 0; i < count; ++i) values.push_back(low * std::pow(high / low, i / (count - 1.0)));
    return values;
}

std::vector<double> spaced(double from, double to, std::size_t points, bool log)
{
    std::vector<double> values(points, from);
    if (points < 2) return values;
    const double last = static_cast<double>(points - 1);
    const double low = log ? std::log(from) : from, high = log ? std::log(to) : to;
    for (std::size_t i = 1; i + 1 < points; ++i) {
        const double t = static_cast<double>(i) / last;
        const double value = low * (1 - t) + high * t;
        values[i] = log ? std::exp(value) : value;
    }
    values.back() = to;
    return values;
}

void smooth(Samples& line, const std::function<double(double)>& y, double most, int rounds)
{
    const auto kind = [](double v) { return std::isnan(v) ? 0 : v > 0 ? 2 : 1; };
    const auto apart = [&](double a, double b) {
        return kind(a) != kind(b) || (kind(a) == 2 && std::abs(std::log(a / b)) > most);
    };
    for (int round = 0; round < rounds; ++round) {
        std::vector<double> finer_x, finer_y;
        for (std::size_t i = 0; i < line.x.size(); ++i) {
            if (i > 0 && apart(line.y[i - 1], line.y[i])) {
                const double middle = std::sqrt(line.x[i - 1] * line.x[i]);
                finer_x.push_back(middle), finer_y.push_back(y(middle));
            }
            finer_x.push_back(line.x[i]), finer_y.push_back(line.y[i]);
        }
        if (finer_x.size() == line.x.size()) return;
        line.x = std::move(finer_x), line.y = std::move(finer_y);
    }
}

}  // namespace stickslip
