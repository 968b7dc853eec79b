// What numbers an option takes. The ranges of the library let NaN pass, as it is neither below nor above an end.
#pragma once
#include "sweep/program/verbs/command_line.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <optional>
#include <string>

namespace stickslip {

inline constexpr int most_threads = 4096;

/// A finite number for which `allowed` holds; `expected` names such numbers, `name` is their type in the help.
template <class Allowed>
Check number_where(Allowed allowed, const std::string& expected, const std::string& name)
{
    return {[allowed, expected](const std::string& text) -> std::string {
                const auto value = number_in(text);
                const bool good = value && std::isfinite(*value) && allowed(*value);
                return good ? "" : "got \"" + text + "\", expected " + expected;
            },
            name};
}

inline Check finite_number()
{
    return number_where([](double) { return true; }, "a finite number", "");
}

/// Normal numbers: what is divided by one stays finite.
inline Check positive_number()
{
    return number_where([](double x) { return x >= std::numeric_limits<double>::min(); }, "a number above 0",
                        "POSITIVE");
}

inline Check not_negative_number()
{
    return number_where([](double x) { return x >= 0; }, "a number of at least 0", "NONNEGATIVE");
}

/// "0.1" or "10 %" as a share.
inline std::optional<double> share_in(std::string text)
{
    const bool percent = text.ends_with('%');
    if (percent) text.erase(text.find_last_not_of(" %") + 1);
    const auto value = number_in(text);
    return value && percent ? std::optional(*value / 100) : value;
}

/// A share of at least 0, which may be above 1.
inline Check not_negative_share()
{
    return {[](const std::string& text) -> std::string {
                const auto value = share_in(text);
                const bool good = value && std::isfinite(*value) && *value >= 0;
                return good ? "" : "got \"" + text + "\", expected a share of at least 0 such as 0.1 or 10%";
            },
            "SHARE"};
}

inline Check between(double low, double high)
{
    return number_where([low, high](double x) { return x >= low && x <= high; }, fmt::format("{:g} to {:g}", low, high),
                        fmt::format("in [{:g} - {:g}]", low, high));
}

inline Check whole_between(int low, int high)
{
    return number_where([low, high](double x) { return x >= low && x <= high && x == std::floor(x); },
                        fmt::format("a whole number from {} to {}", low, high), fmt::format("in [{} - {}]", low, high));
}

/// Seeds and the like.
inline Check whole_number()
{
    return number_where([](double x) { return x >= 0 && x == std::floor(x); }, "a whole number of at least 0",
                        "NONNEGATIVE");
}

/// --threads, which every verb that computes in parallel has; 0: all cores.
inline Option add_threads(Verb& verb, int& threads, const std::string& says)
{
    return verb.add_option("--threads", threads, says)->check(whole_between(0, most_threads));
}

}  // namespace stickslip
