// What a sweep costs, stated before it starts. Everything that estimates size or time takes it from here.
#pragma once
#include <cstdint>
#include <string>

namespace stickslip {

/// Rough cost of one point on one core [s]. It sets the chunk size, which is part of the plan, and so must not be
/// measured.
inline constexpr double linear_point_cost = 4e-7;
inline constexpr double nonlinear_point_cost = 5e-5;  // lanes decide most points, CVODE the rest

/// The index of a plan's chunks stays below 100 MB up to here; more would take tens of terabytes.
inline constexpr std::uint64_t max_points = 1'000'000'000'000;

struct PlanCost {
    double bytes = 0;    ///< of results.nc; the journals take as much again until it is whole
    double seconds = 0;  ///< of one core
};

/// `points` may be beyond all limits.
PlanCost plan_cost(double points, bool nonlinear);

/// "128 PB of results and 317.1 years of one core"
std::string describe(const PlanCost& cost);

/// "1.7 GB", rounded up to a tenth
std::string bytes_text(double bytes);

}  // namespace stickslip
