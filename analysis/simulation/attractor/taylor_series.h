// Taylor series of a turn's unknowns and of their derivatives by parameters. Internal to
// analysis/simulation/attractor.
#pragma once
#include <array>

namespace stickslip {

constexpr int order = 20;

/// A coefficient of a series: of the motion first, then of its displacements by each component of the start.
template <std::size_t width>
using TaylorTerm = std::array<double, width>;

template <std::size_t width>
using TaylorSeries = std::array<TaylorTerm<width>, order + 1>;

/// The k-th coefficient of u w, displacements by the product rule.
template <std::size_t width>
TaylorTerm<width> product(const TaylorSeries<width>& u, const TaylorSeries<width>& w, int k)
{
    TaylorTerm<width> sum{}, other{};
    for (int j = 0; j <= k; ++j) {
        const double at = u[j][0], beside = w[k - j][0];
        for (std::size_t m = 0; m < width; ++m) sum[m] += at * w[k - j][m], other[m] += beside * u[j][m];
    }
    for (std::size_t m = 1; m < width; ++m) sum[m] += other[m];
    return sum;
}

/// The k-th coefficient of e^w and e^−w from those before: u̇ = ±ẇ u, so k u_k = ± Σ j w_j u_{k−j}.
template <std::size_t width>
void exponential(const TaylorSeries<width>& w, int k, TaylorSeries<width>& v, TaylorSeries<width>& g)
{
    TaylorTerm<width> up{}, down{}, up_beside{}, down_beside{};
    for (int j = 1; j <= k; ++j) {
        const double at_v = v[k - j][0], at_g = g[k - j][0], slope = j * w[j][0];
        for (std::size_t m = 0; m < width; ++m) {
            const double change = j * w[j][m];
            up[m] += change * at_v, down[m] += change * at_g;
            up_beside[m] += slope * v[k - j][m], down_beside[m] += slope * g[k - j][m];
        }
    }
    v[k][0] = up[0] / k, g[k][0] = -down[0] / k;
    for (std::size_t m = 1; m < width; ++m)
        v[k][m] = (up[m] + up_beside[m]) / k, g[k][m] = -(down[m] + down_beside[m]) / k;
}

template <std::size_t width>
TaylorTerm<width> value(const TaylorSeries<width>& u, double t)
{
    TaylorTerm<width> sum = u[order];
    for (int k = order; k-- > 0;)
        for (std::size_t m = 0; m < width; ++m) sum[m] = sum[m] * t + u[k][m];
    return sum;
}

template <std::size_t width>
double at(const TaylorSeries<width>& u, double t)
{
    double sum = u[order][0];
    for (int k = order; k-- > 0;) sum = sum * t + u[k][0];
    return sum;
}

template <std::size_t width>
double slope(const TaylorSeries<width>& u, double t)
{
    double sum = order * u[order][0];
    for (int k = order; k-- > 1;) sum = sum * t + k * u[k][0];
    return sum;
}

}  // namespace stickslip
