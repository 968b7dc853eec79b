// The names of codes in answers, in the order of their enumerators; those of points are the names in results.nc.
#pragma once
#include "analysis/results/boundary.h"
#include "analysis/simulation/attractor/nonlinear.h"
#include "sweep/files/json/archive.h"

namespace stickslip::archive {

template <>
struct Names<Region> {
    static constexpr std::array<std::string_view, 7> list{"stable",   "memory_only", "velocity_only", "unstable",
                                                          "bistable", "undecided",   "neutral"};
};
template <>
struct Names<Curve::Kind> {
    static constexpr std::array<std::string_view, 4> list{"velocity_only", "state_variable", "fold", "outcome"};
};
template <>
struct Names<Outcome> {
    static constexpr std::array<std::string_view, 10> list{"not_asked",   "stable-sliding", "stick-slip", "limit-cycle",
                                                           "reversal",    "period-n",       "irregular",  "undecided",
                                                           "linear-only", "solver-failure"};
};
template <>
struct Names<NonlinearRegion> {
    static constexpr std::array<std::string_view, 4> list{"undecided", "stable", "bistable", "stick-slip"};
};
template <>
struct Names<Criticality> {
    static constexpr std::array<std::string_view, 4> list{"none", "supercritical", "subcritical", "degenerate"};
};
template <>
struct Names<DecisionPath> {
    static constexpr std::array<std::string_view, 5> list{"none", "lanes", "cvode", "shooting", "method-of-steps"};
};
template <>
struct Names<Reason> {
    static constexpr std::array<std::string_view, 11> list{
        "none",          "no_velocity",   "law_needs_motion", "no_steady_state", "not_finite", "linear_only",
        "not_converged", "solver_failed", "unsupported",      "neutral",         "diverges"};
};
template <>
struct Names<LocationMethod> {
    static constexpr std::array<std::string_view, 3> list{"interpolation", "bisection", "shooting"};
};
template <>
struct Names<DisturbanceKind> {
    static constexpr std::array<std::string_view, 6> list{"position", "velocity", "impulse",
                                                          "offset",   "state",    "start"};
};
template <>
struct Names<Quantity> {
    static constexpr std::array<std::string_view, 22> list{
        "number",      "time",           "rate",      "angular_frequency", "position",   "velocity",        "effort",
        "effort_rate", "impulse",        "stiffness", "damping",           "inertia",    "per_position",    "angle",
        "length",      "rotary_inertia", "voltage",   "current",           "resistance", "torque_constant", "back_emf",
        "temperature"};
};

}  // namespace stickslip::archive
