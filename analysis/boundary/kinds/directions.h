// Directions in scaled coordinates, and how thoroughly they are searched. Internal to analysis/boundary/kinds.
#pragma once
#include <cmath>
#include <vector>

namespace stickslip {

using Vector = std::vector<double>;

inline constexpr int global_evaluations = 150;  ///< per coordinate, of DIRECT over the directions

inline double norm(const Vector& v)
{
    double sum = 0;
    for (const double x : v) sum += x * x;
    return std::sqrt(sum);
}

inline Vector scaled_by(Vector v, double factor)
{
    for (double& x : v) x *= factor;
    return v;
}

}  // namespace stickslip
