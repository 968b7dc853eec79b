// A root between two points of opposite sign, to a stated relative precision.
#pragma once
#include <algorithm>
#include <cmath>
#include <utility>

namespace stickslip {

/// A root and the bracket that proves it.
struct Bracketed {
    double value, low, high;
    int evaluations;
    bool converged;
};

/// The sign change of f within [a, b], given f(a) and f(b) of opposite sign (or zero). Stops when the bracket is
/// narrower than precision · |value| or than `floor`, or f is exactly zero. Superlinear and never slower than bisection
/// by more than a factor; an end at which f is zero is the answer; begins with the chord, which is all that a narrow
/// bracket needs. Source: T. R. Chandrupatla, Adv. Eng. Softw. 28 (1997) 145-149.
template <class Function>
Bracketed bracketed_root(Function&& f, double a, double fa, double b, double fb, double precision, double floor = 0)
{
    // neither sign belongs to a zero, least of all that of −0.0
    if (fa == 0) return {a, a, a, 0, true};
    if (fb == 0) return {b, b, b, 0, true};
    double c = a, fc = fa;
    const auto clamped = [&](double t, double wanted) {
        const double least = std::min(0.5 * wanted / std::abs(b - a), 0.5);
        return std::clamp(t, least, 1 - least);
    };
    double t = clamped(fa / (fa - fb), std::max(floor, precision * std::min(std::abs(a), std::abs(b))));
    if (std::isnan(t)) t = 0.5;
    int evaluations = 0;
    for (; evaluations < 200; ++evaluations) {
        const double x = a + t * (b - a);
        const double fx = f(x);
        if (std::isnan(fx)) break;
        if (std::signbit(fx) == std::signbit(fa)) {
            c = a, fc = fa;
        } else {
            c = b, fc = fb;
            b = a, fb = fa;
        }
        a = x, fa = fx;
        const bool a_is_better = std::abs(fa) < std::abs(fb);
        const double best = a_is_better ? a : b;
        const double width = std::abs(b - a), wanted = std::max(floor, precision * std::abs(best));
        if ((a_is_better ? fa : fb) == 0) return {best, best, best, evaluations + 1, true};
        if (width <= wanted) return {best, std::min(a, b), std::max(a, b), evaluations + 1, true};
        // inverse quadratic interpolation where it is safe, else bisection
        const double xi = (a - b) / (c - b), phi = (fa - fb) / (fc - fb);
        const bool safe = phi * phi < xi && (1 - phi) * (1 - phi) < 1 - xi;
        t = safe ? fa / (fb - fa) * fc / (fb - fc) + (c - a) / (b - a) * fa / (fc - fa) * fb / (fc - fb) : 0.5;
        t = clamped(t, wanted);
    }
    return {std::abs(fa) < std::abs(fb) ? a : b, std::min(a, b), std::max(a, b), evaluations, false};
}

}  // namespace stickslip
