// The names of codes in answers; those of points are the names in results.nc.
#pragma once
#include "analysis/results/boundary.h"
#include "analysis/results/nonlinear_verdict.h"
#include "analysis/results/point.h"
#include "sweep/files/json/archive.h"

namespace stickslip::archive {

/// As in a column of results.nc.
inline std::string_view column_name(std::string_view column, std::size_t code)
{
    const auto name = code < 256 ? code_name(column, static_cast<std::uint8_t>(code)) : std::string_view("unknown");
    return name == "unknown" ? std::string_view() : name;
}

template <>
struct Names<Region> {
    static std::string_view at(std::size_t code) { return column_name("region", code); }
};
template <>
struct Names<Outcome> {
    static std::string_view at(std::size_t code) { return column_name("outcome", code); }
};
template <>
struct Names<Reason> {
    static std::string_view at(std::size_t code) { return column_name("reason", code); }
};
template <>
struct Names<Detail> {
    static std::string_view at(std::size_t code) { return code < detail_names.size() ? detail_names[code] : ""; }
};
template <>
struct Names<LargerTried> {
    static std::string_view at(std::size_t code)
    {
        return code < larger_tried_names.size() ? larger_tried_names[code] : "";
    }
};
template <>
struct Names<DecisionPath> {
    static std::string_view at(std::size_t code) { return column_name("path", code); }
};

/// One of a list in the order of the enumerators.
template <std::size_t n>
std::string_view listed_name(const std::array<std::string_view, n>& names, std::size_t code)
{
    return code < n ? names[code] : std::string_view();
}

template <>
struct Names<Curve::Kind> {
    static std::string_view at(std::size_t code)
    {
        constexpr std::array<std::string_view, 4> names{"velocity_only", "state_variable", "fold", "outcome"};
        return listed_name(names, code);
    }
};
template <>
struct Names<NonlinearRegion> {
    static std::string_view at(std::size_t code)
    {
        constexpr std::array<std::string_view, 4> names{"undecided", "stable", "bistable", "stick-slip"};
        return listed_name(names, code);
    }
};
template <>
struct Names<Criticality> {
    static std::string_view at(std::size_t code)
    {
        constexpr std::array<std::string_view, 4> names{"none", "supercritical", "subcritical", "degenerate"};
        return listed_name(names, code);
    }
};
template <>
struct Names<LocationMethod> {
    static std::string_view at(std::size_t code)
    {
        constexpr std::array<std::string_view, 3> names{"interpolation", "bisection", "shooting"};
        return listed_name(names, code);
    }
};
template <>
struct Names<DisturbanceKind> {
    static std::string_view at(std::size_t code)
    {
        constexpr std::array<std::string_view, 6> names{"position", "velocity", "impulse", "offset", "state", "start"};
        return listed_name(names, code);
    }
};

}  // namespace stickslip::archive
