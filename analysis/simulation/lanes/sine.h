// Sine and logarithm of packs, to a last bit or two: what records of friction and loads need beside the exponential.
#pragma once
#include "analysis/simulation/lanes/functions.h"

#include <cmath>

namespace stickslip::lanes {

/// x = k π + r with |r| ≤ π/2 (Cody-Waite in three parts), sin x = (−1)^k sin r by its Taylor polynomial of degree 21,
/// whose remainder there is 2e-18. Beyond 1e6 the parts of π no longer hold k exactly; lanes that far out (of
/// predictions that have run away) take the library's.
template <int width, int count>
[[gnu::always_inline]] inline Pack<width, count> sine(const Pack<width, count>& x)
{
    using P = Pack<width, count>;
    constexpr double rounder = 6755399441055744.0, per_pi = 0.31830988618379067154, farthest = 1e6;
    // 33 bits each of the first two
    constexpr double high = 3.14159265346825122833e+00, middle = 1.2154201012607932e-10, low = 4.044532497591901e-21;
    const P shifted = x * P(per_pi) + P(rounder);
    const P k = shifted - P(rounder);
    const P r = ((x - k * P(high)) - k * P(middle)) - k * P(low);
    const P r2 = r * r, r4 = r2 * r2, r8 = r4 * r4;
    const P a = P(-1.0 / 6) + r2 * P(1.0 / 120);
    const P b = P(-1.0 / 5040) + r2 * P(1.0 / 362880);
    const P c = P(-1.0 / 39916800) + r2 * P(1.0 / 6227020800.0);
    const P d = P(-1.0 / 1307674368000.0) + r2 * P(1.0 / 355687428096000.0);
    const P e = P(-1.0 / 121645100408832000.0) + r2 * P(1.0 / 51090942171709440000.0);
    const P tail = (a + r4 * b) + r8 * ((c + r4 * d) + r8 * e);
    P result = r + r * (r2 * tail);
    for (int i = 0; i < count; ++i)
        result.part[i] = doubles_of<width>(bits_of<width>(result.part[i]) ^ (bits_of<width>(shifted.part[i]) << 63));
    if (const auto far = P(farthest) < abs(x); any(far))
        for (int lane = 0; lane < P::lanes; ++lane)
            if (far[lane]) result.set(lane, std::sin(x[lane]));
    return result;
}

/// ln x of normal x > 0: x = 2^k m with m in [√½, √2), and with s = (m − 1)/(m + 1), ln m = 2 artanh s by its series to
/// s^21, whose remainder is 1e-18.
template <int width, int count>
[[gnu::always_inline]] inline Pack<width, count> logarithm(const Pack<width, count>& x)
{
    using P = Pack<width, count>;
    using Integers = typename Native<width>::Integers;
    using Doubles = typename Native<width>::Doubles;
    constexpr double rounder = 6755399441055744.0;
    constexpr double ln2_high = 6.93147180369123816490e-01, ln2_low = 1.90821492927058770002e-10;
    constexpr std::int64_t root_half = INT64_C(0x3fe6a09e667f3bcd);
    P k, m;
    for (int i = 0; i < count; ++i) {
        const Integers above = bits_of<width>(x.part[i]) - root_half;
        // a right shift that keeps the sign, of what fits into the mantissa of the rounder
        const Integers power = above >> 52;
        k.part[i] = doubles_of<width>(power + bits_of<width>(Doubles{} + rounder)) - rounder;
        m.part[i] = doubles_of<width>(bits_of<width>(x.part[i]) - (power << 52));
    }
    const P f = m - P(1.0), s = f / (m + P(1.0)), s2 = s * s, s4 = s2 * s2, s8 = s4 * s4;
    const P a = P(2.0 / 3) + s2 * P(2.0 / 5);
    const P b = P(2.0 / 7) + s2 * P(2.0 / 9);
    const P c = P(2.0 / 11) + s2 * P(2.0 / 13);
    const P d = P(2.0 / 15) + s2 * P(2.0 / 17);
    const P e = P(2.0 / 19) + s2 * P(2.0 / 21);
    const P tail = s2 * ((a + s4 * b) + s8 * ((c + s4 * d) + s8 * e));
    // 2 s = f − s f, so that f carries no rounding of the quotient
    return k * P(ln2_high) + ((f - s * (f - tail)) + k * P(ln2_low));
}

}  // namespace stickslip::lanes
