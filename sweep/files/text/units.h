// Units as people write them ("1 mm/s", "2e4 N/m", "30 rpm"), reduced to SI by a small dimension algebra.
// The radian counts as a dimension of its own: it is what tells N·m from N·m/rad and rad/s from 1/s.
#pragma once
#include "analysis/results/quantity.h"

#include <array>
#include <string>
#include <string_view>

namespace stickslip {

/// Exponents of m, kg, s, A, rad, K.
struct Dimension {
    std::array<int, 6> power{};
    friend bool operator==(const Dimension&, const Dimension&) = default;
};

/// value in SI = value · factor · 10^decimals + offset. The power of ten is apart so that decimal input stays exact:
/// "10 µm" is read as 10e-6, the double nearest to 1e-5.
struct Unit {
    Dimension dimension;
    double factor = 1;
    int decimals = 0;
    double offset = 0;  ///< °C only

    double to_si(double value) const;
};

/// A unit, or in words why the text is none.
struct UnitReading {
    Unit unit;
    std::string error;
};

/// Reads products, quotients, powers and brackets of unit symbols: "N·m·s/rad", "N m s/rad", "kg*m^2", "m s⁻²",
/// "N/(m/s)". A quotient binds to the next symbol only ("N/m·s" is (N/m)·s). Prefixes p n u µ m c k M G; symbols in
/// units.cpp.
UnitReading parse_unit(std::string_view text);

/// A number in the unit of its quantity, or in words what is wrong.
struct NumberReading {
    double value = 0;
    std::string error;
};

/// Reads "number unit" as the given quantity of a joint with this motion and returns it in the unit of unit_of().
/// Errors: no number, no unit, unknown unit, a unit of another kind (names the expected one), overflow.
NumberReading parse_number_with_unit(std::string_view text, Quantity quantity, Units units);

/// What turns a number written in `unit_text` into the unit of unit_of(): value · unit.factor · 10^decimals +
/// unit.offset. Errors: unknown unit, a unit of another kind.
UnitReading unit_for(std::string_view unit_text, Quantity quantity, Units units);

}  // namespace stickslip
