// Numbers of a joint that another table names by their dotted paths. Internal to sweep/files.
#pragma once
#include "analysis/joint/parameters.h"
#include "sweep/files/text/toml_input.h"

#include <optional>
#include <string>
#include <vector>

namespace stickslip::files {

/// A numeric leaf of the joint that a table of a spec names by its dotted path, and what stands there.
struct NamedValue {
    std::string path;
    Place place;             ///< of the path
    const toml::node* node;  ///< of the value
};

/// Flattens `"control.k_p" = …`, `control.k_p = …` and `[axes.control]` to dotted paths in the order of the file. A
/// table that holds one of `leaf_keys` is a value, any other table is part of the path.
/// Keys of the table itself that are in `skip` have another reader.
std::vector<NamedValue> dotted_values(const toml::table& table, const std::vector<std::string>& leaf_keys,
                                      const std::vector<std::string>& skip = {});

/// The leaf at a path, or nothing after a complaint that lists near names.
std::optional<Parameter> find_leaf(Joint& joint, const std::string& path, const Place& place, std::string_view prefix,
                                   Complaints& complaints);

/// A number, plain or with a unit, within the range of the leaf; or nothing after a complaint.
std::optional<double> read_value(const toml::node& node, const Parameter& leaf, Units units, const Place& fallback,
                                 const std::string& path, Complaints& complaints);

}  // namespace stickslip::files
