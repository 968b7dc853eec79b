// Catch2 3 under the header and the names of Catch2 2, which the tests are written for: Debian 12 has the one, Debian 13 the
// other. tests/CMakeLists.txt puts this folder on the include path where it found Catch2 3.
#pragma once
#include <catch2/catch_approx.hpp>
#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/catch_tostring.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/generators/catch_generators_adapters.hpp>
#include <catch2/generators/catch_generators_range.hpp>
#include <catch2/matchers/catch_matchers.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

namespace Catch {
namespace Matchers {

inline StringContainsMatcher Contains(const std::string& part) { return ContainsSubstring(part); }

}  // namespace Matchers
using Matchers::Contains, Matchers::EndsWith, Matchers::Matches, Matchers::StartsWith;

}  // namespace Catch

using Catch::Approx;  // of no namespace in Catch2 2
