// Numbers as a reader sees them: three digits, SI prefix, unit. One place, so that charts, cards, tables and the
// terminal agree.
#pragma once
#include "analysis/results/quantity.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace stickslip {

/// "55 kN/m", "10 µm", "1.5", "−14.2 1/s": `digits` significant digits without trailing zeros, a true minus sign, and
/// an SI prefix where the unit takes one (mass, angle and pure numbers do not). NaN reads "–", infinity "∞".
std::string with_unit(double value, Quantity quantity, Units units, int digits = 3);

/// How a range is put: "from 1 N to 2 N", "1 N … 2 N", "between 1 N and 2 N"; and what precedes a single number.
struct RangeWords {
    std::string_view before, between, single;
};
inline constexpr RangeWords from_to{"from ", " to ", "at "}, low_to_high{"", " … ", ""},
    between_and{"between ", " and ", "at "};

/// The ends of a set or of an axis, or a change: where `digits` do not distinguish them, as many as do, nine at most.
std::string range_text(double low, double high, Quantity quantity, Units units, RangeWords words = from_to,
                       int digits = 3);
/// The least and the largest of computed values: one number where `digits` do not distinguish them.
std::string span_text(double low, double high, Quantity quantity, Units units, RangeWords words = between_and,
                      int digits = 3);
/// Whether both ends read the same with so many digits.
bool reads_alike(double low, double high, Quantity quantity, Units units, int digits);

/// A unit with the SI prefix that suits numbers of one size: {1000, "kN/m"}. Divide by `size` to print.
struct ScaledUnit {
    double size = 1;
    std::string text;
};

/// For a column or an axis whose largest number is `largest`; the bare unit where it takes no prefix.
ScaledUnit scaled_unit(double largest, Quantity quantity, Units units);
ScaledUnit scaled_unit(double largest, const std::string& unit);

/// The number alone, "5.5×10^{4}" in chart mark-up where a plain one would be long.
std::string plain_number(double value, int digits = 3);

/// "1 point", "41 points": for nouns with a plain plural.
std::string counted(std::uint64_t count, std::string_view noun);

/// "401 841" with narrow no-break spaces, for pages.
std::string grouped(std::uint64_t count);

/// "38.7 %"; a share that is not quite 0 or 1 is never printed as if it were.
std::string percent(double share);

}  // namespace stickslip
