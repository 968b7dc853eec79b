#include "analysis/results/text.h"

#include <array>
#include <cmath>
#include <cstdio>

namespace stickslip {
namespace {

struct Prefix {
    int exponent;
    const char* symbol;
};
constexpr Prefix prefixes[] = {{-12, "p"}, {-9, "n"}, {-6, "µ"}, {-3, "m"}, {0, ""},
                               {3, "k"},   {6, "M"},  {9, "G"},  {12, "T"}};
constexpr const char* minus = "−";

/// Whether an SI prefix in front of the unit is how the field writes it.
bool takes_prefix(std::string_view unit)
{
    return unit.starts_with("N") || unit.starts_with("m") || unit == "s" || unit.starts_with("V") || unit == "A" ||
           unit == "Ω";
}

std::string signed_text(const char* text)
{
    return text[0] == '-' ? minus + std::string(text + 1) : text;
}

std::string digits_of(double value, int digits)
{
    std::array<char, 40> buffer;
    std::snprintf(buffer.data(), buffer.size(), "%.*g", digits, value);
    return signed_text(buffer.data());
}

/// The value as it reads after rounding to `digits`, so that 999.9 becomes 1.00 k and not 1000.
double rounded(double value, int digits)
{
    if (value == 0) return 0;
    const double unit = std::pow(10, std::floor(std::log10(std::abs(value))) - digits + 1);
    return std::round(value / unit) * unit;
}

}  // namespace

std::string plain_number(double value, int digits)
{
    if (std::isnan(value)) return "–";
    if (std::isinf(value)) return value < 0 ? std::string(minus) + "∞" : "∞";
    if (value == 0) value = 0;  // −0 is none
    const double size = std::abs(rounded(value, digits));
    if (size == 0 || (size >= 1e-3 && size < std::pow(10, std::max(digits, 5)))) {
        if (size >= std::pow(10, digits)) {  // no exponent yet: all digits before the point
            std::array<char, 40> buffer;
            std::snprintf(buffer.data(), buffer.size(), "%.0f", rounded(value, digits));
            return signed_text(buffer.data());
        }
        return digits_of(value, digits);
    }
    const int exponent = static_cast<int>(std::floor(std::log10(size) + 1e-12));
    return digits_of(value / std::pow(10, exponent), digits) + "×10^{" + signed_text(std::to_string(exponent).c_str()) +
           "}";
}

ScaledUnit scaled_unit(double largest, Quantity quantity, Units units)
{
    return scaled_unit(largest, std::string(unit_of(quantity, units)));
}

ScaledUnit scaled_unit(double largest, const std::string& unit)
{
    if (takes_prefix(unit))
        for (const auto& p : prefixes) {
            const double scaled = std::abs(largest) / std::pow(10, p.exponent);
            if (scaled >= 1 - 1e-12 && scaled < 1000 * (1 - 1e-12)) return {std::pow(10, p.exponent), p.symbol + unit};
        }
    return {1, unit};
}

std::string with_unit(double value, Quantity quantity, Units units, int digits)
{
    const std::string unit(unit_of(quantity, units));
    if (std::isnan(value) || unit == "1") return plain_number(value, digits);
    const ScaledUnit scaled = scaled_unit(std::isfinite(value) ? rounded(value, digits) : 0, quantity, units);
    return plain_number(value / scaled.size, digits) + " " + scaled.text;
}

bool reads_alike(double low, double high, Quantity quantity, Units units, int digits)
{
    return with_unit(low, quantity, units, digits) == with_unit(high, quantity, units, digits);
}

std::string span_text(double low, double high, Quantity quantity, Units units, RangeWords words, int digits)
{
    const std::string least = with_unit(low, quantity, units, digits);
    if (reads_alike(low, high, quantity, units, digits)) return std::string(words.single) + least;
    return std::string(words.before) + least + std::string(words.between) + with_unit(high, quantity, units, digits);
}

std::string range_text(double low, double high, Quantity quantity, Units units, RangeWords words, int digits)
{
    constexpr int most = 9;  // searches locate their ends to 1e-9 at best
    while (digits < most && low != high && reads_alike(low, high, quantity, units, digits)) ++digits;
    return span_text(low, high, quantity, units, words, digits);
}

std::string counted(std::uint64_t count, std::string_view noun)
{
    return std::to_string(count) + " " + std::string(noun) + (count == 1 ? "" : "s");
}

std::string grouped(std::uint64_t count)
{
    std::string digits = std::to_string(count);
    for (auto at = static_cast<std::ptrdiff_t>(digits.size()) - 3; at > 0; at -= 3)
        digits.insert(static_cast<std::size_t>(at), "\u202f");
    return digits;
}

std::string percent(double share)
{
    if (std::isnan(share)) return "–";
    std::array<char, 40> buffer;
    const double p = 100 * share;
    if (p > 0 && p < 0.05) return "< 0.1 %";
    if (p < 100 && p >= 99.95) return "> 99.9 %";
    std::snprintf(buffer.data(), buffer.size(), p == 0 || p == 100 ? "%.0f %%" : "%.1f %%", p);
    return buffer.data();
}

}  // namespace stickslip
