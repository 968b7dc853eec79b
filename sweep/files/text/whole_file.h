// Files that appear whole or not at all.
#pragma once
#include <filesystem>
#include <string_view>

namespace stickslip {

/// Writes the bytes beside the file and then gives them its name; missing folders are made. Throws
/// std::filesystem::filesystem_error with the path and the reason (a full disk, a place that may not be written);
/// what stood there before, stays. A device or a pipe (/dev/stdout) is written to as it is.
void write_whole(const std::filesystem::path& file, std::string_view bytes);

}  // namespace stickslip
