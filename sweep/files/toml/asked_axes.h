// The subject of a verb that takes a joint or a spec: the design point, and axes named on the command line.
#pragma once
#include "sweep/study/spec.h"

#include <filesystem>
#include <string>
#include <vector>

namespace stickslip {

/// A spec with its design point after `--set`; of a joint file, a spec without axes.
struct Asked {
    Spec spec;
    Joint design;
};

/// Reads SPEC or JOINT, distinguished by the [axes] that only a spec has. Throws BadInput like their readers.
Asked read_spec_or_joint(const std::filesystem::path& file, const std::vector<std::string>& settings);

/// "PATH" or "PATH=FROM..TO", numbers with or without units, perhaps followed by ":log" or ":linear". Without a range:
/// that of the spec's axis of this name, else two decades to either side of the design's value. Only the ends are
/// values of the axis. Throws BadInput naming `option`.
Axis axis_from(const Asked& asked, const std::string& text, const std::string& option);

}  // namespace stickslip
