// `stickslip design --set-point`: k_i, dead zone and a push against friction such that nothing hunts.
#pragma once
#include <string>
#include <vector>

#include "analysis/base/field.h"
#include "sweep/program/verbs/verbs.h"

namespace stickslip {

struct SetPointOptions {
    std::string input, directory;
    std::vector<std::string> settings, over;
    double friction_margin = 0.1, integral_gain = not_set, push_speed = not_set, rest_error = infinity;
    int threads = 0;
    bool json = false;
};

/// Prints, writes and returns the exit code. Throws BadInput.
int design_set_point_answer(const SetPointOptions& options, Invocation& invocation);

}  // namespace stickslip
