// A sweep from TOML: joint, axes, design point, what is asked and what is drawn.
#pragma once
#include "sweep/spec.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace stickslip {

/// How large a sweep may be, and what its estimate is made of.
struct PlanLimits {
    std::uint64_t points = 1'000'000'000'000;  ///< refuse more; the engine's own limit
    double bytes_per_row = 128;                ///< of the result, for the estimate in the message
    double points_per_second = 1e5;            ///< of this machine, for the estimate in the message
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

/// The values of an axis, both ends included and exact. Needs from < to, and from > 0 for a log scale.
std::vector<double> spaced(double from, double to, std::size_t points, bool log);

}  // namespace stickslip
