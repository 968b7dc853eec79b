// Elementary functions of packs, accurate to a few last bits on the range that the lanes use.
#pragma once
#include "analysis/simulation/lanes/pack.h"

namespace stickslip::lanes {

/// e^w and e^w − 1 from one evaluation; the second keeps its relative accuracy at small w.
template <class P>
struct Exponential {
    P value, minus_one;
};

/// w = k ln 2 + r, |r| ≤ ln 2/2 (Cody-Waite in two parts), e^r − 1 by its Taylor polynomial of degree 13, then
/// e^w − 1 = (2^k − 1) + 2^k (e^r − 1). |w| is clamped to 700. Adding and subtracting 1.5·2^52 rounds to the nearest
/// whole number: -ffast-math would delete that pair, and must not be used.
template <int width, int count>
[[gnu::always_inline]] inline Exponential<Pack<width, count>> exponential(const Pack<width, count>& argument)
{
    using P = Pack<width, count>;
    using Integers = typename Native<width>::Integers;
    using Doubles = typename Native<width>::Doubles;
    constexpr double rounder = 6755399441055744.0;
    constexpr double per_ln2 = 1.4426950408889634074, ln2_high = 6.93147180369123816490e-01,
                     ln2_low = 1.90821492927058770002e-10;
    const P w = max(min(argument, P(700.0)), P(-700.0));
    const P shifted = w * P(per_ln2) + P(rounder);
    P power;  // 2^k, the exponent field filled with the low bits of `shifted`
    for (int i = 0; i < count; ++i) {
        const Integers k = bits_of<width>(shifted.part[i]) - bits_of<width>(Doubles{} + rounder);
        power.part[i] = doubles_of<width>((k + 1023) << 52);
    }
    const P k = shifted - P(rounder);
    const P r = (w - k * P(ln2_high)) - k * P(ln2_low);
    const P r2 = r * r, r4 = r2 * r2;
    const P low = (P(1.0 / 2) + r * P(1.0 / 6)) + r2 * (P(1.0 / 24) + r * P(1.0 / 120));
    const P middle = (P(1.0 / 720) + r * P(1.0 / 5040)) + r2 * (P(1.0 / 40320) + r * P(1.0 / 362880));
    const P high = (P(1.0 / 3628800) + r * P(1.0 / 39916800)) + r2 * (P(1.0 / 479001600) + r * P(1.0 / 6227020800.0));
    const P tail = r + r2 * (low + r4 * (middle + r4 * high));  // e^r − 1
    return {power + power * tail, (power - P(1.0)) + power * tail};
}

/// e^(−3/16) for e > 0 to a few per cent, by the logarithm in the exponent field: all a step size asks for.
template <int width, int count>
[[gnu::always_inline]] inline Pack<width, count> rough_power(const Pack<width, count>& e)
{
    using Integers = typename Native<width>::Integers;
    constexpr std::int64_t one = INT64_C(0x3ff0000000000000);
    Pack<width, count> r;
    for (int i = 0; i < count; ++i) {
        const Integers bits = bits_of<width>(e.part[i]);
        r.part[i] = doubles_of<width>(one + (one >> 3) + (one >> 4) - (bits >> 3) - (bits >> 4));
    }
    return r;
}

}  // namespace stickslip::lanes
