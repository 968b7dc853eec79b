// The options --disturbance and --size, which simulate and evaluate share.
#pragma once
#include "sweep/study/spec.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cmath>
#include <string>
#include <vector>

namespace stickslip {

/// CLI11's ranges let NaN pass.
inline CLI::Validator finite_number()
{
    return {[](const std::string& text) -> std::string {
                double value = 0;
                return CLI::detail::lexical_cast(text, value) && std::isfinite(value)
                           ? ""
                           : "got " + text + ", expected a finite number";
            },
            "", "finite"};
}

/// As CLI11's range, whose words round small ends to 0.
inline CLI::Validator between(double low, double high)
{
    return {[low, high](const std::string& text) -> std::string {
                double value = 0;
                return CLI::detail::lexical_cast(text, value) && value >= low && value <= high
                           ? ""
                           : fmt::format("Value {} not in range {} to {}", text, low, high);
            },
            fmt::format("in [{} - {}]", low, high), "range"};
}

struct DisturbanceOption {
    std::string kind;
    double size = missing;

    void add_to(CLI::App& verb)
    {
        std::vector<std::string> kinds;
        for (const auto& k : DisturbanceSpec::kinds) kinds.emplace_back(k.name);
        verb.add_option("--disturbance", kind, "what is disturbed; default: a spec's own, else position")
            ->check(CLI::IsMember(kinds));
        verb.add_option("--size", size,
                        "size of the disturbance in SI; default: a spec's own, else small, in the slow mode")
            ->check(finite_number());
    }

    /// The disturbance of the command line, or else that of the spec. A size belongs to its kind: another kind starts
    /// without.
    Disturbance disturbance(const NonlinearSpec& spec) const
    {
        Disturbance d = spec.disturbance.disturbance;
        for (const auto& k : DisturbanceSpec::kinds)
            if (k.name == kind) d = {k.value, missing};
        if (is_set(size)) d.size = size;
        return d;
    }
};

}  // namespace stickslip
