// Packs of doubles as wide as the processor: one source for AVX-512, AVX2 and baseline x86-64. A pack is N native
// vectors side by side, since two independent vectors hide the latency of one another; wider GCC vectors than the
// hardware has would be split badly. Every operation is element by element, so that a lane's bits never depend on its
// neighbours. A pack of one lane is a bare double under the same names.
// In one file: one vector type with its operators.
#pragma once
#include <bit>
#include <cstdint>
#ifdef __AVX__
#include <immintrin.h>
#endif

namespace stickslip::lanes {

/// Native vectors of `width` doubles.
template <int width>
struct Native {
    typedef double Doubles __attribute__((vector_size(width * 8)));
    typedef std::int64_t Integers __attribute__((vector_size(width * 8)));
};

template <>
struct Native<1> {
    typedef double Doubles;
    typedef std::int64_t Integers;
};

/// The bits of doubles, and doubles of these bits.
template <int width>
[[gnu::always_inline]] inline typename Native<width>::Integers bits_of(typename Native<width>::Doubles x)
{
    return std::bit_cast<typename Native<width>::Integers>(x);
}
template <int width>
[[gnu::always_inline]] inline typename Native<width>::Doubles doubles_of(typename Native<width>::Integers x)
{
    return std::bit_cast<typename Native<width>::Doubles>(x);
}

/// Lane by lane all bits or none.
template <int width, int count>
struct Mask {
    typename Native<width>::Integers part[count];

    [[gnu::always_inline]] bool operator[](int lane) const
    {
        if constexpr (width == 1)
            return part[lane] != 0;
        else
            return part[lane / width][lane % width] != 0;
    }
    [[gnu::always_inline]] void set(int lane, bool on)
    {
        if constexpr (width == 1)
            part[lane] = on ? -1 : 0;
        else
            part[lane / width][lane % width] = on ? -1 : 0;
    }
};

template <int width, int count>
struct Pack {
    static constexpr int lanes = width * count;
    using MaskType = Mask<width, count>;
    typename Native<width>::Doubles part[count];

    [[gnu::always_inline]] Pack() {}
    /// Part by part: a struct of vectors would be copied in pieces of 16 bytes, and a wider load after it waits for all
    /// of them.
    [[gnu::always_inline]] Pack(const Pack& other) { *this = other; }
    [[gnu::always_inline]] Pack& operator=(const Pack& other)
    {
        for (int i = 0; i < count; ++i) part[i] = other.part[i];
        return *this;
    }
    [[gnu::always_inline]] Pack(double value)
    {
        for (int i = 0; i < count; ++i) part[i] = typename Native<width>::Doubles{} + value;
    }
    [[gnu::always_inline]] double operator[](int lane) const
    {
        if constexpr (width == 1)
            return part[lane];
        else
            return part[lane / width][lane % width];
    }
    [[gnu::always_inline]] void set(int lane, double value)
    {
        if constexpr (width == 1)
            part[lane] = value;
        else
            part[lane / width][lane % width] = value;
    }
};

/// Applies f to each native part.
template <int width, int count, class F>
[[gnu::always_inline]] inline Pack<width, count> map(const Pack<width, count>& a, const Pack<width, count>& b, F f)
{
    Pack<width, count> r;
    for (int i = 0; i < count; ++i) r.part[i] = f(a.part[i], b.part[i]);
    return r;
}
template <int width, int count, class F>
[[gnu::always_inline]] inline Mask<width, count> compare(const Pack<width, count>& a, const Pack<width, count>& b, F f)
{
    Mask<width, count> r;
    for (int i = 0; i < count; ++i)
        if constexpr (width == 1)
            r.part[i] = -static_cast<std::int64_t>(f(a.part[i], b.part[i]));
        else
            r.part[i] = f(a.part[i], b.part[i]);
    return r;
}

template <int w, int n>
[[gnu::always_inline]] inline Pack<w, n> operator+(const Pack<w, n>& a, const Pack<w, n>& b)
{
    return map(a, b, [](auto x, auto y) { return x + y; });
}
template <int w, int n>
[[gnu::always_inline]] inline Pack<w, n> operator-(const Pack<w, n>& a, const Pack<w, n>& b)
{
    return map(a, b, [](auto x, auto y) { return x - y; });
}
template <int w, int n>
[[gnu::always_inline]] inline Pack<w, n> operator*(const Pack<w, n>& a, const Pack<w, n>& b)
{
    return map(a, b, [](auto x, auto y) { return x * y; });
}
template <int w, int n>
[[gnu::always_inline]] inline Pack<w, n> operator/(const Pack<w, n>& a, const Pack<w, n>& b)
{
    return map(a, b, [](auto x, auto y) { return x / y; });
}
template <int w, int n>
[[gnu::always_inline]] inline Pack<w, n> operator*(double a, const Pack<w, n>& b)
{
    return Pack<w, n>(a) * b;
}
template <int w, int n>
[[gnu::always_inline]] inline Pack<w, n> operator+(const Pack<w, n>& a, double b)
{
    return a + Pack<w, n>(b);
}
template <int w, int n>
[[gnu::always_inline]] inline Pack<w, n> operator-(const Pack<w, n>& a, double b)
{
    return a - Pack<w, n>(b);
}
template <int w, int n>
[[gnu::always_inline]] inline Pack<w, n> operator+(double a, const Pack<w, n>& b)
{
    return Pack<w, n>(a) + b;
}
template <int w, int n>
[[gnu::always_inline]] inline Pack<w, n> operator-(double a, const Pack<w, n>& b)
{
    return Pack<w, n>(a) - b;
}
template <int w, int n>
[[gnu::always_inline]] inline Pack<w, n> operator-(const Pack<w, n>& a)
{
    return Pack<w, n>(0.0) - a;
}
template <int w, int n>
[[gnu::always_inline]] inline Mask<w, n> operator<(const Pack<w, n>& a, const Pack<w, n>& b)
{
    return compare(a, b, [](auto x, auto y) { return x < y; });
}
template <int w, int n>
[[gnu::always_inline]] inline Mask<w, n> operator<=(const Pack<w, n>& a, const Pack<w, n>& b)
{
    return compare(a, b, [](auto x, auto y) { return x <= y; });
}
template <int w, int n>
[[gnu::always_inline]] inline Mask<w, n> operator>(const Pack<w, n>& a, const Pack<w, n>& b)
{
    return b < a;
}
template <int w, int n>
[[gnu::always_inline]] inline Mask<w, n> operator!=(const Pack<w, n>& a, const Pack<w, n>& b)
{
    return compare(a, b, [](auto x, auto y) { return x != y; });
}
template <int w, int n>
[[gnu::always_inline]] inline Mask<w, n> operator&(const Mask<w, n>& a, const Mask<w, n>& b)
{
    Mask<w, n> r;
    for (int i = 0; i < n; ++i) r.part[i] = a.part[i] & b.part[i];
    return r;
}
template <int w, int n>
[[gnu::always_inline]] inline Mask<w, n> operator|(const Mask<w, n>& a, const Mask<w, n>& b)
{
    Mask<w, n> r;
    for (int i = 0; i < n; ++i) r.part[i] = a.part[i] | b.part[i];
    return r;
}
template <int w, int n>
[[gnu::always_inline]] inline Mask<w, n> operator^(const Mask<w, n>& a, const Mask<w, n>& b)
{
    Mask<w, n> r;
    for (int i = 0; i < n; ++i) r.part[i] = a.part[i] ^ b.part[i];
    return r;
}
template <int w, int n>
[[gnu::always_inline]] inline Mask<w, n> operator~(const Mask<w, n>& a)
{
    Mask<w, n> r;
    for (int i = 0; i < n; ++i) r.part[i] = ~a.part[i];
    return r;
}
template <int w, int n>
[[gnu::always_inline]] inline Pack<w, n> select(const Mask<w, n>& mask, const Pack<w, n>& yes, const Pack<w, n>& no)
{
    Pack<w, n> r;
    for (int i = 0; i < n; ++i) r.part[i] = mask.part[i] ? yes.part[i] : no.part[i];
    return r;
}
template <int w, int n>
[[gnu::always_inline]] inline bool any(const Mask<w, n>& mask)
{
    auto all = mask.part[0];
    for (int i = 1; i < n; ++i) all |= mask.part[i];
    if constexpr (w == 1) {
        return all != 0;
#ifdef __AVX512DQ__
    } else if constexpr (w == 8) {
        return _mm512_movepi64_mask(std::bit_cast<__m512i>(all)) != 0;
#endif
#ifdef __AVX__
    } else if constexpr (w == 4) {
        return _mm256_movemask_pd(std::bit_cast<__m256d>(all)) != 0;
#endif
    } else {
        std::int64_t bits = 0;
        for (int i = 0; i < w; ++i) bits |= all[i];
        return bits != 0;
    }
}
template <int w, int n>
[[gnu::always_inline]] inline bool every(const Mask<w, n>& mask)
{
    return !any(~mask);
}
template <int w, int n>
[[gnu::always_inline]] inline Pack<w, n> abs(const Pack<w, n>& a)
{
    Pack<w, n> r;
    for (int i = 0; i < n; ++i) r.part[i] = doubles_of<w>(bits_of<w>(a.part[i]) & INT64_MAX);
    return r;
}
/// The magnitude of a with the sign of b.
template <int w, int n>
[[gnu::always_inline]] inline Pack<w, n> copysign(const Pack<w, n>& a, const Pack<w, n>& b)
{
    Pack<w, n> r;
    for (int i = 0; i < n; ++i)
        r.part[i] = doubles_of<w>((bits_of<w>(a.part[i]) & INT64_MAX) | (bits_of<w>(b.part[i]) & INT64_MIN));
    return r;
}
/// y unless x > y, NaN and zeros included, by the one instruction that does this: comparisons of vectors become two.
template <class D>
[[gnu::always_inline]] inline D larger(D x, D y)
{
#ifdef __AVX512F__
    if constexpr (sizeof(D) == 64) return _mm512_mask_max_pd(x, 0xff, x, y);
#endif
#ifdef __AVX__
    if constexpr (sizeof(D) == 32) return _mm256_max_pd(x, y);
#endif
    return x > y ? x : y;
}
/// y unless x < y.
template <class D>
[[gnu::always_inline]] inline D smaller(D x, D y)
{
#ifdef __AVX512F__
    if constexpr (sizeof(D) == 64) return _mm512_mask_min_pd(x, 0xff, x, y);
#endif
#ifdef __AVX__
    if constexpr (sizeof(D) == 32) return _mm256_min_pd(x, y);
#endif
    return x < y ? x : y;
}
template <int w, int n>
[[gnu::always_inline]] inline Pack<w, n> max(const Pack<w, n>& a, const Pack<w, n>& b)
{
    return map(a, b, [](auto x, auto y) { return larger(x, y); });
}
template <int w, int n>
[[gnu::always_inline]] inline Pack<w, n> min(const Pack<w, n>& a, const Pack<w, n>& b)
{
    return map(a, b, [](auto x, auto y) { return smaller(x, y); });
}

}  // namespace stickslip::lanes
