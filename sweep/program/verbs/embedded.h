// The example that the program carries with it: examples/01-reference-joint/spec.toml, embedded at build time.
#pragma once
#include <string_view>

namespace stickslip {

std::string_view embedded_spec();

}  // namespace stickslip
