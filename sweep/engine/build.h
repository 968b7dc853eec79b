// Who computed: results are the same bytes only for the same source, compiler, flags and kind of CPU.
#pragma once
#include <string>

namespace stickslip {

/// "0.1.0"
std::string program_version();

/// Hash of the sources that make the numbers.
std::string method_hash();

/// Version, hash of the sources that make the numbers, compiler, flags, C library, features of the CPU, and a hash of
/// what exp, log, sin and the like answer here, for glibc chooses their code at run time. Equal text: equal bytes.
std::string build_fingerprint();

}  // namespace stickslip
