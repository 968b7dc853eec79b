// The linear verdict in words, for the report and the terminal.
#pragma once
#include "analysis/results/nonlinear_verdict.h"
#include "analysis/results/report.h"
#include "analysis/stability/verdict.h"

#include <string>

namespace stickslip {

/// What takes a joint out of sliding whose small disturbances decay.
enum class TakenOut { by_nothing, by_larger, by_noise };
TakenOut taken_out(bool bistable, const NonlinearVerdict& verdict);

/// The answer in one sentence, in chart mark-up. Where something takes the joint out of it, what the linear theory
/// calls stable is half of the answer. `rests`: what does not slide on stays at rest.
std::string verdict_text(const Joint& joint, const LinearVerdict& verdict, TakenOut taken = TakenOut::by_nothing,
                         bool rests = false);

/// Of the design on a map. `rests`: what does not slide on comes to rest for good.
std::string design_point_text(Region region, double spectral_abscissa, bool rests);

/// The stable gains of a search in k_p; nothing found in one that ended below the joint's own gain is no denial.
std::string stable_gains_text(const Joint& joint, const StateVariableVerdict& memory);

/// Every number of the verdict with its unit.
Table linear_table(const Joint& joint, const LinearVerdict& verdict);

/// Every number of the nonlinear verdict with its unit.
Table nonlinear_table(const Joint& joint, const NonlinearVerdict& verdict);

/// What a cycle does for the share of its period that is `stick_fraction`: a motion backwards is no rest.
std::string rest_text(const NonlinearVerdict& verdict);

}  // namespace stickslip
