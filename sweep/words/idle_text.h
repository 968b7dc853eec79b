// Parameters that no linear answer depends on, in words.
#pragma once
#include "analysis/results/report.h"
#include "sweep/study/idle_axes.h"

#include <string>

namespace stickslip {

/// "the linear theory has no term for load.gravity_amplitude (it depends on position: …)".
std::string idle_words(const IdleAxis& axis);

/// A page over such axes says so, as a warning where the parameter may change the verdict; with `simulated`, a
/// simulation beside the linear theory answers for it.
void tell_idle(const std::vector<IdleAxis>& idle, bool simulated, Report& report);

}  // namespace stickslip
