// The linear verdict as `stickslip evaluate --json` prints it: documented, stable names.
#pragma once
#include "analysis/stability/verdict.h"
#include "sweep/study/idle_axes.h"
#include "sweep/study/left_out_loop.h"

#include <nlohmann/json.hpp>

namespace stickslip {

using Json = nlohmann::ordered_json;

/// JSON has no NaN and no infinity: what does not exist is null.
Json json_number(double value);

/// [[low, high], …]; an end without bound is null.
Json intervals_json(const std::vector<Interval>& list);

/// The name of a reason as in results.nc; null for none.
Json code_json(Reason reason);

/// {"kind": …, "used": […], "not_used": [{"key", "why", "why_code", "matters"}], "left_out": null}; with --ideal-loop
/// left_out is the loop that it stands in place of: {"kind", "keys", "spectral_abscissa"}.
Json loop_json(const LoopUse& loop, const std::optional<LeftOut>& left_out = {});

/// [{"path", "why", "why_code", "matters"}]: each axis or uncertain parameter that no linear answer depends on.
Json idle_json(const std::vector<IdleAxis>& idle);

/// {"steady": …, "linear": {"velocity_only": …, "state_variable": …}}; without steady sliding "linear" is null and
/// "reason" says why.
Json verdict_json(const LinearVerdict& verdict);

}  // namespace stickslip
