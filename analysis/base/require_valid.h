// Options say themselves what is wrong with them: problem(), which is empty where nothing is.
#pragma once
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>

namespace stickslip {

/// "rtol: got -1, expected above 0 and at most 0.01"
inline std::string not_valid(const char* name, double got, const char* expected)
{
    char number[32];
    std::snprintf(number, sizeof number, "%g", got);
    return std::string(name) + ": got " + number + ", expected " + expected;
}

/// Empty where `good`.
inline std::string problem_unless(bool good, const char* name, double got, const char* expected)
{
    return good ? std::string() : not_valid(name, got, expected);
}

/// The first problem of a list, empty where there is none.
template <class... Text>
std::string first_problem(const Text&... texts)
{
    std::string first;
    ((first = first.empty() ? texts : first), ...);
    return first;
}

/// Throws std::invalid_argument with the problem of the options.
template <class Options>
void require_valid(const Options& options)
{
    if (const std::string text = options.problem(); !text.empty()) throw std::invalid_argument(text);
}

/// A relative tolerance of an integration.
inline std::string tolerance_problem(double rtol)
{
    return problem_unless(rtol > 0 && rtol <= 0.01, "rtol", rtol, "above 0 and at most 0.01");
}

}  // namespace stickslip
