// Axes of the boundary tests.
#pragma once
#include "analysis/results/stability_map.h"

#include <utility>

namespace stickslip {

/// An axis that is searched from end to end, without values between.
inline Axis axis(std::string path, double low, double high, bool log = true)
{
    Axis a;
    a.path = std::move(path);
    a.log = log;
    a.values = {low, high};
    return a;
}

}  // namespace stickslip
