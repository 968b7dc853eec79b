// The [boundary] table of a spec: the questions of `stickslip boundary` where its command line has none.
#pragma once
#include "sweep/files/text/toml_input.h"
#include "sweep/files/toml/hand_keys.h"
#include "sweep/study/spec.h"

namespace stickslip::files {

/// Reads the keys that a self-describing struct cannot hold: kind, along and over, one text or a list. `axis` is
/// another name of along.
void read_boundary_lists(const toml::table& table, const Joint& joint, BoundarySpec& spec, Complaints& complaints);

/// Those keys.
inline const std::vector<std::string> boundary_lists = names_of(spec_keys, "boundary");

}  // namespace stickslip::files
