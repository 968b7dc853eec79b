// A number of the policy that writes down what it is compared with. The made copies of the policy have it in place of
// double.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <limits>
#include <type_traits>

namespace stickslip::evidence {

template <class T>
concept Arithmetic = std::is_arithmetic_v<T>;

/// What was compared with one threshold, in its own unit: how much of it on either side, how much within a factor of
/// two, the nearest values and the furthest.
struct Compared {
    static constexpr std::size_t kept = 6;
    const char* name;
    struct Side {
        long count = 0, close = 0;
        std::size_t stored = 0;
        std::array<double, kept> nearest{};  ///< the nearest first, each value once
        double furthest = 0;
    };
    Side below, above;

    void record(double value, double threshold)
    {
        if (std::isnan(value)) return;
        auto& [count, close, stored, nearest, furthest] = value > threshold ? above : below;
        if (count++ == 0 || std::abs(value - threshold) > std::abs(furthest - threshold)) furthest = value;
        if (std::min(value / threshold, threshold / value) > 0.5) ++close;
        std::size_t at = 0;
        while (at < stored && std::abs(nearest[at] - threshold) < std::abs(value - threshold)) ++at;
        if (at == kept || (at < stored && nearest[at] == value)) return;
        stored = std::min(stored + 1, kept);
        for (std::size_t i = stored - 1; i > at; --i) nearest[i] = nearest[i - 1];
        nearest[at] = value;
    }
};

/// base, or factor × base + offset, or factor ÷ base, or base squared: a comparison with any of them counts for base.
struct Traced {
    double value;
    Compared* compared = nullptr;
    double base = value, factor = 1, offset = 0;
    bool inverse = false, squared = false;

    /// A template, so that a Traced becomes a double and never, on its way, an int.
    template <std::same_as<double> T>
    constexpr operator T() const
    {
        return value;
    }

    /// What a rule of the diagnosis sets itself is no threshold.
    Traced& operator=(double other) { return *this = Traced{other}; }
    void set(double other) { value = base = other; }

    void record(double other) const
    {
        if (!compared || factor == 0) return;
        const double of_base = inverse ? factor / other : (other - offset) / factor;
        compared->record(squared ? std::sqrt(std::max(0.0, of_base)) : of_base, base);
    }
};

inline Traced operator*(Traced a, double b)
{
    a.value *= b, a.factor *= b, a.offset *= b;
    return a;
}
inline Traced operator+(Traced a, double b)
{
    if (a.inverse) return {a.value + b};
    a.value += b, a.offset += b;
    return a;
}
inline Traced operator/(double b, Traced a)
{
    if (a.inverse || a.squared || a.offset != 0) return {b / a.value};
    a.value = b / a.value, a.factor = b / a.factor, a.inverse = true;
    return a;
}
inline Traced operator*(double a, const Traced& b)
{
    return b * a;
}
inline Traced operator+(double a, const Traced& b)
{
    return b + a;
}
inline Traced operator-(const Traced& a)
{
    return a * -1.0;
}
inline Traced operator-(const Traced& a, double b)
{
    return a + -b;
}
inline Traced operator-(double a, const Traced& b)
{
    return b * -1.0 + a;
}
inline Traced operator/(const Traced& a, double b)
{
    return a * (1 / b);
}

/// Of two thresholds the first counts, except for the square of one.
inline Traced operator*(const Traced& a, const Traced& b)
{
    if (!a.compared) return b * a.value;
    if (a.compared != b.compared) return a * b.value;
    Traced square = a;
    square.value *= b.value, square.squared = true;
    return square;
}
inline Traced operator+(const Traced& a, const Traced& b)
{
    return a.compared ? a + b.value : b + a.value;
}
inline Traced operator-(const Traced& a, const Traced& b)
{
    return a.compared ? a - b.value : a.value - b;
}
inline double operator/(const Traced& a, const Traced& b)
{
    return a.value / b.value;
}

inline double& operator*=(double& a, const Traced& b)
{
    return a *= b.value;
}

/// Which of two thresholds is larger is no comparison of a result (std::max); `>` stands in conditions only.
inline bool operator<(const Traced& a, const Traced& b)
{
    return a.value < b.value;
}
inline bool operator>(const Traced& a, const Traced& b)
{
    a.record(b.value), b.record(a.value);
    return a.value > b.value;
}

template <Arithmetic T>
bool operator<(T a, const Traced& b)
{
    b.record(static_cast<double>(a));
    return static_cast<double>(a) < b.value;
}
template <Arithmetic T>
bool operator<=(T a, const Traced& b)
{
    b.record(static_cast<double>(a));
    return static_cast<double>(a) <= b.value;
}
template <Arithmetic T>
bool operator>(T a, const Traced& b)
{
    b.record(static_cast<double>(a));
    return static_cast<double>(a) > b.value;
}
template <Arithmetic T>
bool operator>=(T a, const Traced& b)
{
    b.record(static_cast<double>(a));
    return static_cast<double>(a) >= b.value;
}
template <Arithmetic T>
bool operator<(const Traced& a, T b)
{
    return b > a;
}
template <Arithmetic T>
bool operator>(const Traced& a, T b)
{
    return b < a;
}
template <Arithmetic T>
bool operator<=(const Traced& a, T b)
{
    return b >= a;
}
template <Arithmetic T>
bool operator>=(const Traced& a, T b)
{
    return b <= a;
}

}  // namespace stickslip::evidence

// The diagnosis calls these with std:: before them, so that overloads of Traced have to stand there.
namespace std {  // NOLINT(cert-dcl58-cpp)
using stickslip::evidence::Traced;
inline Traced max(const Traced& a, double b)
{
    return a.value < b ? Traced{b} : a;
}
inline Traced max(double a, const Traced& b)
{
    return max(b, a);
}
inline Traced min(const Traced& a, double b)
{
    return b < a.value ? Traced{b} : a;
}
inline Traced min(double a, const Traced& b)
{
    return min(b, a);
}
inline double sqrt(const Traced& a)
{
    return sqrt(a.value);
}
inline double exp(const Traced& a)
{
    return exp(a.value);
}
inline double log(const Traced& a)
{
    return log(a.value);
}
inline double abs(const Traced& a)
{
    return abs(a.value);
}
inline double pow(const Traced& a, double b)
{
    return pow(a.value, b);
}
}  // namespace std
