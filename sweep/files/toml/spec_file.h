// A sweep from TOML: joint, axes, design point, questions and charts.
#pragma once
#include "sweep/engine/plan_cost.h"
#include "sweep/study/spec.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace stickslip {

/// How large a sweep may be.
struct PlanLimits {
    std::uint64_t points = max_points;  ///< refuse more
};

/// Reads spec.toml. `joint = "joint.toml"` is looked up from the folder of the spec; or the joint's tables stand
/// inline. Throws BadInput with every error of the spec and of its joint, each `file:line:column: path: …`.
Spec read_spec(const std::filesystem::path& file, const PlanLimits& limits = {});

/// The same from text (the embedded example); `name` is what messages call it, `folder` where a joint file is looked
/// up.
Spec read_spec_text(std::string_view text, const std::string& name, const std::filesystem::path& folder = {},
                    const PlanLimits& limits = {});

/// The spec as one text that needs no other file: comments go, and a joint file is replaced by the joint's own tables.
/// Throws BadInput like read_spec.
std::string self_contained_text(const std::filesystem::path& file);

}  // namespace stickslip
