// Where a key of a joint stands, for messages about what it leads to after everything has been read.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace stickslip {

/// "joint.toml:12:16" of a number by its dotted path, in the joint's file or the one that a spec names; "--set" where
/// the last word on it is a setting; the file alone where a default or a servo's registers say it.
std::string stated_place(const std::filesystem::path& file, const std::vector<std::string>& settings,
                         std::string_view path);

}  // namespace stickslip
