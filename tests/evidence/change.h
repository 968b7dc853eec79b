// Thresholds of the policy with another value.
#pragma once
#include "analysis/diagnosis/policy/entries.h"  // made by trace_policy.py

#include <stdexcept>
#include <string>

namespace stickslip::evidence {

/// NAME=VALUE
inline void change(const std::string& assignment)
{
    const auto equals = assignment.find('=');
    const std::string name = assignment.substr(0, equals);
    for (const auto& entry : gap::policy::entries) {
        if (name != entry.name || !entry.number) continue;
        entry.number->set(std::stod(assignment.substr(equals + 1)));
        gap::policy::ladder.prior = gap::policy::correction_prior;
        return;
    }
    throw std::invalid_argument(name + ": is no threshold that can be changed");
}

}  // namespace stickslip::evidence
