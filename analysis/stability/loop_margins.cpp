#include "analysis/stability/loop_margins.h"

#include <Eigen/Dense>
#include <algorithm>
#include <numbers>

#include "analysis/numerics/maximum.h"
#include "analysis/numerics/root.h"
#include "analysis/stability/characteristic.h"
#include "analysis/stability/joint_crossings.h"
#include "analysis/stability/joint_spectrum.h"

namespace stickslip {
namespace {

/// Lowest and highest size of the roots: where a response has its features.
struct FrequencyRange {
    double low, high;
};
FrequencyRange features(const std::vector<Complex>& roots)
{
    FrequencyRange range{infinity, 0};
    for (const auto& s : roots) {
        if (std::abs(s) == 0) continue;
        range.low = std::min(range.low, std::abs(s));
        range.high = std::max(range.high, std::abs(s));
    }
    return range;
}

std::vector<double> logarithmic(double low, double high, int points)
{
    std::vector<double> list;
    for (int i = 0; i < points; ++i) list.push_back(low * std::pow(high / low, double(i) / (points - 1)));
    return list;
}

Complex open_loop(const LinearJoint& j, double omega)
{
    const Complex s(0, omega);
    const auto parts = characteristic_at(j, s);
    return (j.k_p + j.k_v * s) * parts.b.value / parts.a.value;
}

}  // namespace

Complex disturbance_response(const LinearJoint& j, Complex s)
{
    std::array<Complex, max_bodies> resistance, scale;
    for (int i = 0; i < j.bodies; ++i) {
        resistance[i] = j.friction[i].f_v - transfer(j.friction[i], s);
        scale[i] = 1;
    }
    for (const auto& n : j.neighbour)
        resistance[j.link()] -= n.coupling * n.coupling * s * s * s / ((n.inertia * s + n.damping) * s + n.stiffness);
    const auto open = open_loop_matrix(j, s, resistance, scale);
    Eigen::Matrix<Complex, Eigen::Dynamic, Eigen::Dynamic, 0, max_bodies, max_bodies> Z(j.bodies, j.bodies);
    for (int i = 0; i < j.bodies; ++i) {
        for (int k = 0; k < j.bodies; ++k) Z(i, k) = open[i][k];
        Z(i, j.measured) += j.actuated[i] * (j.k_p + j.k_v * s);
    }
    Eigen::Matrix<Complex, Eigen::Dynamic, 1, 0, max_bodies, 1> push(j.bodies);
    push.setZero();
    push[j.link()] = 1;
    return Z.partialPivLu().solve(push)[j.link()];
}

ResponsePeak response_peak(const LinearJoint& j, int points)
{
    const auto roots = spectrum(j);
    if (roots.empty() || !(roots.front().real() <= 0)) return {missing, missing};
    return response_peak(
        [&](double omega) {
            return std::abs(disturbance_response(j, {0, omega}));
        },
        roots, points, infinity);
}

ResponsePeak response_peak(const std::function<double(double)>& size, const std::vector<Complex>& roots, int points,
                           double highest)
{
    const auto range = features(roots);
    auto omegas = logarithmic(std::min(range.low, highest) / 100, std::min(10 * range.high, highest), points);
    for (const auto& s : roots)
        if (s.imag() > 0 && s.imag() < highest) omegas.push_back(s.imag());
    std::sort(omegas.begin(), omegas.end());
    ResponsePeak peak{0, size(0)};
    for (std::size_t i = 1; i + 1 < omegas.size(); ++i) {
        const double here = size(omegas[i]);
        if (here < size(omegas[i - 1]) || here < size(omegas[i + 1])) continue;
        const double omega = maximiser(size, omegas[i - 1], omegas[i + 1]);
        if (size(omega) > peak.magnitude) peak = {omega, size(omega)};
    }
    return peak;
}

LoopMargins loop_margins(const LinearJoint& j, int points)
{
    return loop_margins(j, crossings(j).crossings, points);
}

LoopMargins loop_margins(const LinearJoint& j, const std::vector<Crossing>& crossings, int points)
{
    if (!is_stable(j)) return {missing, missing, missing, missing};
    LoopMargins margins{0, infinity, infinity, missing};
    for (const auto& c : crossings) {
        if (c.k_p < j.k_p) margins.gain_below = c.k_p / j.k_p;
        if (c.k_p > j.k_p) margins.gain_above = std::min(margins.gain_above, c.k_p / j.k_p);
    }
    const auto range = features(spectrum(j));
    const auto excess = [&](double omega) { return std::log(std::abs(open_loop(j, omega))); };
    const auto omegas = logarithmic(range.low / 1000, 100 * range.high, points);
    for (std::size_t i = 0; i + 1 < omegas.size(); ++i) {
        const double a = excess(omegas[i]), b = excess(omegas[i + 1]);
        if (std::signbit(a) == std::signbit(b)) continue;
        const double omega = bracketed_root(excess, omegas[i], a, omegas[i + 1], b, 1e-12).value;
        // the lag that turns L onto −1
        double lag = std::arg(-open_loop(j, omega));
        if (lag <= 0) lag += 2 * std::numbers::pi;
        if (lag < margins.phase) margins.phase = lag, margins.crossover = omega;
    }
    return margins;
}

void follow_branches(std::vector<std::vector<Complex>>& rows)
{
    for (std::size_t r = 1; r < rows.size(); ++r) {
        auto& roots = rows[r];
        const auto& last = rows[r - 1];
        for (std::size_t i = 0; i < std::min(roots.size(), last.size()); ++i) {
            const auto nearest =
                std::min_element(roots.begin() + static_cast<std::ptrdiff_t>(i), roots.end(),
                                 [&](Complex a, Complex b) { return std::abs(a - last[i]) < std::abs(b - last[i]); });
            std::iter_swap(roots.begin() + static_cast<std::ptrdiff_t>(i), nearest);
        }
    }
}

std::vector<std::vector<Complex>> root_locus(LinearJoint j, const std::vector<double>& gains)
{
    std::vector<std::vector<Complex>> rows;
    for (const double k_p : gains) {
        j.k_p = k_p;
        rows.push_back(spectrum(j));
    }
    follow_branches(rows);
    return rows;
}

}  // namespace stickslip
