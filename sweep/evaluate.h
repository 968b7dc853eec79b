// How a sweep evaluates its points: the one place where linear and nonlinear answers meet.
#pragma once
#include "analysis/simulation/nonlinear.h"
#include "sweep/engine/engine.h"
#include "sweep/engine/plan.h"
#include "sweep/spec.h"

#include <string>

namespace stickslip {

/// The options of the nonlinear evaluation that a spec asks for.
NonlinearOptions nonlinear_options(const NonlinearSpec& spec);

/// Rows of a chunk: linear verdicts, and nonlinear outcomes where the spec asks for them.
EvaluateChunk evaluator(const NonlinearSpec& spec);

/// Canonical text of everything that the evaluation depends on besides the joint; goes into the plan's id.
std::string evaluation_text(const NonlinearSpec& spec);

/// Rough cost of a point on one core [s], for the size of chunks.
double seconds_per_point(const NonlinearSpec& spec);

}  // namespace stickslip
