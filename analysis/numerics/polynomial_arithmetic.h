// Real polynomials of small degree, for the characteristic function of joints without delays.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/friction/response.h"

namespace stickslip {

/// c_0 + c_1 s + …, without allocation. Large enough for a characteristic polynomial of three bodies and six
/// neighbours times its mirror.
struct Polynomial {
    static constexpr int capacity = 2 * (6 + 3 * max_states + 12) + 2;
    int size = 1;
    std::array<double, capacity> c;

    Polynomial() { c[0] = 0; }
    Polynomial(double constant) { c[0] = constant; }
    Polynomial(double constant, double linear) : size(2)
    {
        c[0] = constant;
        c[1] = linear;
    }
    Polynomial(const Polynomial& other) : size(other.size) { std::copy_n(other.c.begin(), size, c.begin()); }
    Polynomial& operator=(const Polynomial& other)
    {
        size = other.size;
        std::copy_n(other.c.begin(), size, c.begin());
        return *this;
    }
    int degree() const { return size - 1; }
};

inline Polynomial operator+(const Polynomial& a, const Polynomial& b)
{
    Polynomial sum = a.size >= b.size ? a : b;
    const Polynomial& other = a.size >= b.size ? b : a;
    for (int i = 0; i < other.size; ++i) sum.c[i] += other.c[i];
    return sum;
}
inline Polynomial operator*(const Polynomial& a, const Polynomial& b)
{
    Polynomial product;
    product.size = a.size + b.size - 1;
    std::fill_n(product.c.begin(), product.size, 0.0);
    for (int i = 0; i < a.size; ++i)
        if (a.c[i] != 0)
            for (int k = 0; k < b.size; ++k) product.c[i + k] += a.c[i] * b.c[k];
    return product;
}
inline Polynomial operator-(const Polynomial& a, const Polynomial& b)
{
    return a + Polynomial(-1.0) * b;
}

/// Without leading zeros.
inline Polynomial trimmed(Polynomial p)
{
    while (p.size > 1 && p.c[p.size - 1] == 0) --p.size;
    return p;
}

/// What Routh's scheme says of the roots of a polynomial.
enum class Routh {
    all_decay,        ///< every real part is negative
    not_all_decay,    ///< some is positive or zero
    rounding_decides  ///< a number of the first column is next to nothing beside what it is the difference of
};

/// Every number of the first column is of one sign where all roots decay.
/// Source: E. J. Routh, A Treatise on the Stability of a Given State of Motion (1877).
inline Routh routh(const Polynomial& p)
{
    constexpr double next_to_nothing = 1e-10;
    const int n = p.degree();
    const double sign = p.c[n] > 0 ? 1 : -1;
    std::array<double, Polynomial::capacity> above, row;  // two rows of the scheme, from the highest power down
    int length = n / 2 + 1;
    for (int i = 0; i < length; ++i) {
        above[i] = sign * p.c[n - 2 * i];
        row[i] = 2 * i + 1 <= n ? sign * p.c[n - 2 * i - 1] : 0;
    }
    bool doubtful = false;
    for (int k = n; k > 0; --k) {
        if (!(row[0] > 0)) return doubtful ? Routh::rounding_decides : Routh::not_all_decay;
        const double ratio = above[0] / row[0];
        for (int i = 0; i + 1 < length; ++i) {
            const double next = above[i + 1] - ratio * row[i + 1];
            if (i == 0 && k > 1) doubtful = doubtful || std::abs(next) < next_to_nothing * std::abs(above[i + 1]);
            above[i] = row[i];
            row[i] = next;
        }
        above[length - 1] = row[length - 1];
        row[length - 1] = 0;
    }
    return doubtful ? Routh::rounding_decides : Routh::all_decay;
}

}  // namespace stickslip
