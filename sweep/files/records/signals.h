// The signals that a record may hold: their names in files, their units, their places in Record.
#pragma once
#include "analysis/diagnosis/records/record.h"
#include "analysis/results/quantity.h"

#include <span>
#include <string_view>
#include <vector>

namespace stickslip {

/// A signal that a record may hold, under its own name.
struct Signal {
    std::string_view name;
    std::vector<double> Record::*column;
    Quantity quantity;
    bool measured;  ///< says what the joint did: a record needs one of these
    bool any_unit;  ///< in a unit of its own
    std::string_view help;
};

/// time, reference_position, … in the order of the documentation. drive_voltage and duty share Record::drive.
std::span<const Signal> signals();
const Signal* signal_named(std::string_view name);

}  // namespace stickslip
