// How a sweep evaluates its points: the one place where linear and nonlinear answers meet.
#pragma once
#include "analysis/simulation/attractor/nonlinear.h"
#include "sweep/engine/engine.h"
#include "sweep/engine/plan.h"
#include "sweep/study/spec.h"

#include <string>
#include <vector>

namespace stickslip {

/// The options of the nonlinear evaluation that a spec asks for.
NonlinearOptions nonlinear_options(const NonlinearSpec& spec);

/// Whether a sweep over these axes computes some of its points and interpolates the others: a nonlinear one of many
/// points that allows it.
bool is_dense(const NonlinearSpec& spec, const std::vector<Axis>& axes);

/// Rows of a chunk: linear verdicts, and nonlinear outcomes where the spec asks for them. The axes must outlive it.
EvaluateChunk evaluator(const NonlinearSpec& spec, const std::vector<Axis>& axes);

/// Canonical text of everything that the evaluation depends on besides the joint; goes into the plan's id.
std::string evaluation_text(const NonlinearSpec& spec, const std::vector<Axis>& axes);

/// Rough cost of a point on one core [s], for the size of chunks.
double seconds_per_point(const NonlinearSpec& spec, const Joint& joint);

}  // namespace stickslip
