// What the program said before, and whether it says it still: words exactly, numbers to a few thousandths, so that
// another processor's rounding is no difference. Lines that name places or times are left out.
#pragma once
#include "tests/program/run.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <regex>
#include <vector>

namespace program {

/// The lines that are the same on every machine and in every folder.
inline std::string lasting_lines(const std::string& output)
{
    std::istringstream in(output);
    std::string kept;
    for (std::string line; std::getline(in, line);) {
        // where a check of a dense map falls short by a rounding, more of its points are computed
        const bool passing = line.find("computed now") != std::string::npos ||
                             line.find("points interpolated") != std::string::npos ||
                             std::regex_search(line, std::regex("(evaluations,|merged in) [0-9.]+ s$")) ||
                             std::regex_search(line, std::regex("^(results|report|page|trajectory|diagnosis): "));
        if (!passing) kept += line + "\n";
    }
    return kept;
}

/// Empty where both say the same, else the first line that differs.
inline std::string difference(const std::string& then, const std::string& now)
{
    constexpr double rounding = 2e-8;  // of differences that are zero but for rounding
    const std::regex number("[0-9]+(\\.[0-9]+)?(e[-+]?[0-9]+)?");
    const auto numbers = [&](const std::string& line) {
        std::vector<double> list;
        for (std::sregex_iterator it(line.begin(), line.end(), number), end; it != end; ++it)
            list.push_back(std::stod(it->str()));
        return list;
    };
    std::istringstream a(then), b(now);
    for (std::string x, y;;) {
        const bool more_then(std::getline(a, x)), more_now(std::getline(b, y));
        if (!more_then && !more_now) return "";
        const auto p = numbers(x), q = numbers(y);
        bool same = more_then && more_now && p.size() == q.size() &&
                    std::regex_replace(x, number, "#") == std::regex_replace(y, number, "#");
        for (std::size_t i = 0; same && i < p.size(); ++i)
            same = std::abs(p[i] - q[i]) <= 4e-3 * std::max(std::abs(p[i]), std::abs(q[i])) + rounding;
        if (!same) return "said before: " + x + "\nsays now:    " + y;
    }
}

/// Compares an output with the one stored under tests/program/expected; `STICKSLIP_UPDATE=1` stores it instead.
inline void check_said(const std::string& name, const std::string& output)
{
    const auto file = std::string(SOURCE_ROOT) + "/tests/program/expected/" + name + ".txt";
    const auto now = lasting_lines(output);
    if (std::getenv("STICKSLIP_UPDATE")) std::ofstream(file) << now;
    INFO(name << ": where the change is meant, STICKSLIP_UPDATE=1 tests_program stores what is said now");
    CHECK(difference(program::read(file), now) == "");
}

}  // namespace program
