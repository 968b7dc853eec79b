// Symbol and name of a joint's numbers, as their declarations have them (Field::called).
#pragma once
#include <string>
#include <string_view>

#include "analysis/base/field.h"

namespace stickslip {

/// How a number is written on charts and pages.
struct Sign {
    std::string symbol;  ///< "k_{p}"; "k_{m-tr}" where the declaration has k_{#} and the table is motor_transmission
    std::string name;    ///< "position gain"
    Quantity quantity = Quantity::number;
};

/// Of the number at a path such as "control.k_p" or "friction.motor.L" (a list without its index), nullptr where its
/// declaration names none. Every model, controller, drive and law is known. Safe from any thread.
const Sign* sign_of(std::string_view path);

}  // namespace stickslip
