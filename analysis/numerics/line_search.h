// The least value of a smooth function between two numbers.
#pragma once

namespace stickslip::gap {

/// Golden-section search: where in [low, high] the function is least, to 4e-9 of the interval after 40 steps, if it has
/// one minimum there.
template <class Function>
double least_between(double low, double high, Function&& f)
{
    constexpr double golden = 0.6180339887498949;
    constexpr int steps = 40;
    double a = high - golden * (high - low), b = low + golden * (high - low);
    double fa = f(a), fb = f(b);
    for (int i = 0; i < steps; ++i) {
        if (fa < fb)
            high = b, b = a, fb = fa, a = high - golden * (high - low), fa = f(a);
        else
            low = a, a = b, fa = fb, b = low + golden * (high - low), fb = f(b);
    }
    return 0.5 * (low + high);
}

}  // namespace stickslip::gap
