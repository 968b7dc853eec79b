#include "sweep/program/verbs/timestamp.h"

#include "sweep/files/text/bad_input.h"

#include <fmt/chrono.h>

#include <charconv>
#include <chrono>
#include <cstdlib>

namespace stickslip {
namespace {

constexpr long long last_second = 253'402'300'799;  // of the year 9999

std::string date_of(std::time_t seconds)
{
    return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(seconds));
}

}  // namespace

std::string timestamp(const std::string& wanted)
{
    if (wanted == "now") return date_of(std::chrono::system_clock::to_time_t(std::chrono::system_clock::now()));
    const char* variable = std::getenv("SOURCE_DATE_EPOCH");
    const std::string text = !wanted.empty() ? wanted : variable ? variable : "";
    if (text.empty()) return "";
    long long seconds = 0;
    const auto end = std::from_chars(text.data(), text.data() + text.size(), seconds);
    if (end.ec != std::errc{} || end.ptr != text.data() + text.size() || seconds < 0 || seconds > last_second)
        throw BadInput((wanted.empty() ? "SOURCE_DATE_EPOCH" : "--timestamp") + std::string(": got \"") + text +
                       "\", expected now or seconds since 1970");
    return date_of(static_cast<std::time_t>(seconds));
}

}  // namespace stickslip
