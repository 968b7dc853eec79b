#include "analysis/simulation/flows/speed_history.h"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>

namespace stickslip {
namespace {

/// The polynomial through five equidistant values: a line between the ends, and f (1 − f) times a parabola, whose
/// values at the quarters are what is left there.
SpeedHistory::Speed evaluate(const SpeedHistory::Step& step, double instant)
{
    const double h = step.to - step.from, f = (instant - step.from) / h, rest = 1 - f;
    const auto& V = step.velocity;
    const auto left = [&](int i) {
        const double at = 0.25 * i;
        return (V[i] - (1 - at) * V[0] - at * V[4]) / (at * (1 - at));
    };
    const double u = 4 * f - 2, bend = 0.5 * (left(3) - left(1)), curl = 0.5 * (left(1) + left(3)) - left(2);
    const double parabola = left(2) + u * (bend + u * curl), slope = 4 * (bend + 2 * u * curl);
    return {rest * V[0] + f * V[4] + f * rest * parabola, (V[4] - V[0] + (rest - f) * parabola + f * rest * slope) / h};
}

}  // namespace

void SpeedHistory::append(const Step& step, double forget_before)
{
    while (!steps_.empty() && steps_.front().to < forget_before) steps_.pop_front();
    steps_.push_back(step);
}

void SpeedHistory::scale(double by)
{
    for (auto& step : steps_)
        for (double& V : step.velocity) V = before_ + by * (V - before_);
}

SpeedHistory::Speed SpeedHistory::at(double instant, double pick) const
{
    if (steps_.empty() || pick < steps_.front().from) return {before_, 0};
    const auto begun = [](double t, const Step& s) { return t < s.from; };
    const auto after = std::upper_bound(steps_.begin(), steps_.end(), pick, begun);
    return evaluate(*(after - 1), instant);
}

std::complex<double> SpeedHistory::memory(std::complex<double> s, double lag, double now) const
{
    using Rule = boost::math::quadrature::gauss<double, 7>;  // steps have degree 4, and s changes little over one
    std::complex<double> sum = 0;
    for (const auto& step : steps_) {
        const double from = std::max(step.from, now - lag), to = std::min(step.to, now);
        if (!(to > from)) continue;
        const auto part = [&](double t) {
            return std::exp(-s * (t + lag - now)) * (evaluate(step, t).value - before_);
        };
        sum += Rule::integrate([&](double t) { return part(t).real(); }, from, to) +
               std::complex<double>(0, Rule::integrate([&](double t) { return part(t).imag(); }, from, to));
    }
    return sum;
}

}  // namespace stickslip
