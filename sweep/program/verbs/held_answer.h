// What a folder holds that was taken for a sweep's.
#pragma once
#include <filesystem>
#include <string>

namespace stickslip {

/// For a folder without results.nc, in a sentence: the answer of another verb and where its page is, a sweep that is
/// not finished, a folder that is not there. Names the folder.
std::string instead_of_a_sweep(const std::filesystem::path& folder);

}  // namespace stickslip
