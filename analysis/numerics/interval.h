// Interval arithmetic on reals and complex rectangles: bounds that hold for every frequency of a band.
#pragma once
#include <algorithm>
#include <cmath>
#include <numbers>

namespace stickslip {

/// A closed interval. Every operation widens its result by a few units in the last place, more than rounding loses.
struct Band {
    double low = 0, high = 0;

    Band() = default;
    Band(double v) : low(v), high(v) {}
    Band(double a, double b) : low(a), high(b) {}

    double middle() const { return low + (high - low) / 2; }
    double width() const { return high - low; }
    bool contains_zero() const { return low <= 0 && high >= 0; }
};

inline Band widened(double a, double b)
{
    constexpr double units = 4 * 2.220446049250313e-16, least = 1e-300;
    return {a - units * std::abs(a) - least, b + units * std::abs(b) + least};
}
inline Band operator-(const Band& a)
{
    return {-a.high, -a.low};
}
inline Band operator+(const Band& a, const Band& b)
{
    return widened(a.low + b.low, a.high + b.high);
}
inline Band operator-(const Band& a, const Band& b)
{
    return a + -b;
}
inline Band operator*(const Band& a, const Band& b)
{
    const double p = a.low * b.low, q = a.low * b.high, r = a.high * b.low, s = a.high * b.high;
    return widened(std::min(std::min(p, q), std::min(r, s)), std::max(std::max(p, q), std::max(r, s)));
}
/// 1/a for a band without zero.
inline Band inverse(const Band& a)
{
    return widened(1 / a.high, 1 / a.low);
}
inline Band square(const Band& a)
{
    const double p = a.low * a.low, q = a.high * a.high;
    return a.contains_zero() ? widened(0, std::max(p, q)) : widened(std::min(p, q), std::max(p, q));
}
inline Band intersection(const Band& a, const Band& b)
{
    return {std::max(a.low, b.low), std::min(a.high, b.high)};
}

/// cos over a band: its ends, and ±1 where an extremum lies within.
inline Band cosine(const Band& a)
{
    constexpr double pi = std::numbers::pi;
    if (a.width() >= 2 * pi) return {-1, 1};
    Band c{std::min(std::cos(a.low), std::cos(a.high)), std::max(std::cos(a.low), std::cos(a.high))};
    constexpr double slack = 1e-12;  // of the position of an extremum: a false ±1 only widens
    const double first = std::ceil(a.low / pi - slack), last = std::floor(a.high / pi + slack);
    for (double k = first; k <= last; ++k) (std::fmod(k, 2) == 0 ? c.high = 1 : c.low = -1);
    return {std::max(-1.0, c.low - 1e-15), std::min(1.0, c.high + 1e-15)};
}
inline Band sine(const Band& a)
{
    return cosine(a - Band(std::numbers::pi / 2));
}

/// A rectangle of the complex plane.
struct Box {
    Band re, im;

    Box() = default;
    Box(double v) : re(v) {}
    Box(const Band& r, const Band& i = Band()) : re(r), im(i) {}
    bool contains_zero() const { return re.contains_zero() && im.contains_zero(); }
};
inline Box operator+(const Box& a, const Box& b)
{
    return {a.re + b.re, a.im + b.im};
}
inline Box operator-(const Box& a, const Box& b)
{
    return {a.re - b.re, a.im - b.im};
}
inline Box operator*(const Box& a, const Box& b)
{
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}
inline Box conj(const Box& a)
{
    return {a.re, -a.im};
}
inline Box intersection(const Box& a, const Box& b)
{
    return {intersection(a.re, b.re), intersection(a.im, b.im)};
}

}  // namespace stickslip
