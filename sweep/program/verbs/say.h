// Words to standard error.
#pragma once
#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <utility>

namespace stickslip {

/// Prints to standard error. Where that cannot be written (a full disk, a closed terminal) the words are lost, and the
/// program goes on to its exit code: fmt::print would throw, from a catch clause or a thread of its own.
template <class... Arguments>
void say(fmt::format_string<Arguments...> format, Arguments&&... arguments)
{
    const std::string text = fmt::format(format, std::forward<Arguments>(arguments)...);
    [[maybe_unused]] const auto written = std::fwrite(text.data(), 1, text.size(), stderr);
}

}  // namespace stickslip
