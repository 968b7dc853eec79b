// The numbers of a joint that a data sheet has, by the effect that changes them. Internal to
// analysis/diagnosis/verdict.
#pragma once
#include "analysis/diagnosis/effects/catalogue.h"

#include <span>
#include <string_view>

namespace stickslip::gap {

struct SheetNumber {
    std::string_view effect, key;
    Quantity quantity;
    double (*of)(Joint& joint);   ///< one of its own, which stays as it is
    std::string_view form = {};   ///< empty: every form without a line of its own
    bool per_documented = false;  ///< the number itself has no meaning apart from the documented one
};

/// In the order in which they are told.
std::span<const SheetNumber> data_sheet();

/// Whether a cause of this form changes the number.
bool is_about(const SheetNumber& number, const Effect& effect, const EffectForm& form);

}  // namespace stickslip::gap
