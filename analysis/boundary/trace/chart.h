// A chart in scaled coordinates: the unit square, logarithmic axes by their logarithm.
#pragma once
#include "analysis/results/unit_axis.h"

#include <cmath>

namespace stickslip {

/// A point or a direction in scaled coordinates.
struct UnitPoint {
    double u = 0, v = 0;

    friend UnitPoint operator+(UnitPoint a, UnitPoint b) { return {a.u + b.u, a.v + b.v}; }
    friend UnitPoint operator-(UnitPoint a, UnitPoint b) { return {a.u - b.u, a.v - b.v}; }
    friend UnitPoint operator*(double s, UnitPoint a) { return {s * a.u, s * a.v}; }
    double dot(UnitPoint b) const { return u * b.u + v * b.v; }
    double cross(UnitPoint b) const { return u * b.v - v * b.u; }
    double length() const { return std::hypot(u, v); }
    UnitPoint normalized() const { return 1 / length() * *this; }
    UnitPoint rotated(double angle) const
    {
        const double c = std::cos(angle), s = std::sin(angle);
        return {c * u - s * v, s * u + c * v};
    }
    bool inside() const { return u >= 0 && u <= 1 && v >= 0 && v <= 1; }
};

/// From a to b, counter-clockwise.
inline double angle_between(UnitPoint a, UnitPoint b)
{
    return std::atan2(a.cross(b), a.dot(b));
}

}  // namespace stickslip
