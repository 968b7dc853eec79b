// Who computed: results are the same bytes only for the same source, compiler, flags and kind of CPU.
#pragma once
#include <string>

namespace stickslip {

/// "0.1.0"
std::string program_version();

/// Version, hash of the sources that make the numbers, compiler, flags, C library and the CPU features by which that
/// library and the lanes choose their floating point code. Equal text: equal bytes.
std::string build_fingerprint();

}  // namespace stickslip
