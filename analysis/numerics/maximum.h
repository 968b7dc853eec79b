// The largest value of a function of one variable.
#pragma once
#include <cmath>

namespace stickslip {

/// Where f, unimodal between 0 ≤ a < b, is largest: golden sections down to `precision` of the given b. A maximum
/// itself is known no better than to the square root of rounding, about 1e-8.
template <class Function>
double maximiser(Function&& f, double a, double b, double precision = 1e-10)
{
    const double golden = (std::sqrt(5.0) - 1) / 2, close = precision * b;
    double x = b - golden * (b - a), y = a + golden * (b - a), fx = f(x), fy = f(y);
    while (b - a > close && x < y) {
        if (fx > fy) {
            b = y, y = x, fy = fx;
            x = b - golden * (b - a), fx = f(x);
        } else {
            a = x, x = y, fx = fy;
            y = a + golden * (b - a), fy = f(y);
        }
    }
    return (a + b) / 2;
}

}  // namespace stickslip
