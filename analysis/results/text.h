// Numbers as a reader sees them: three digits, SI prefix, unit. One place, so that charts, cards, tables and the
// terminal agree.
#pragma once
#include "analysis/results/quantity.h"

#include <string>

namespace stickslip {

/// "55 kN/m", "10 µm", "1.5", "−14.2 1/s": `digits` significant digits without trailing zeros, a true minus sign, and
/// an SI prefix where the unit takes one (mass, angle and pure numbers do not). NaN reads "–", infinity "∞".
std::string with_unit(double value, Quantity quantity, Motion motion, int digits = 3);

/// A unit with the SI prefix that suits numbers of one size: {1000, "kN/m"}. Divide by `size` to print.
struct ScaledUnit {
    double size = 1;
    std::string text;
};

/// For a column or an axis whose largest number is `largest`; the bare unit where it takes no prefix.
ScaledUnit scaled_unit(double largest, Quantity quantity, Motion motion);

/// The number alone, "5.5×10^{4}" in chart mark-up where a plain one would be long.
std::string plain_number(double value, int digits = 3);

/// "38.7 %"; a share that is not quite 0 or 1 is never printed as if it were.
std::string percent(double share);

}  // namespace stickslip
