#include "analysis/diagnosis/records/between_rows.h"

#include "analysis/diagnosis/records/ticks.h"

#include <cmath>

namespace stickslip::gap {
namespace {

/// How a reference goes on inside a row interval: smoothly, straight, or along the line on its left or right up to
/// where both meet.
enum class Course { smooth, straight, left, right };

/// A ramp has kinks, next to which a polynomial would ring. Where both neighbours of an interval are straight lines
/// that do not continue each other, they meet inside.
Course course_of(const std::vector<double>& x, std::size_t k, double s)
{
    if (k < 2 || k + 3 >= x.size()) return Course::smooth;
    constexpr double little = 0.1;  // numerical: of the bend; in a smooth curve neighbouring bends are alike
    const double before = x[k - 1] - x[k - 2], left = x[k] - x[k - 1], here = x[k + 1] - x[k],
                 right = x[k + 2] - x[k + 1], after = x[k + 3] - x[k + 2];
    const double bend = right - left;
    const auto small = [](double a, double of) { return std::abs(a) <= little * std::abs(of); };
    if (bend != 0 && small(left - before, bend) && small(after - right, bend) && (here - left) * (right - here) >= 0) {
        const double from_left = x[k] + s * left, from_right = x[k + 1] - (1 - s) * right;
        return (bend > 0) == (from_left > from_right) ? Course::left : Course::right;
    }
    const bool bent_before = here != left && small(right - here, here - left);
    const bool bent_after = here != right && small(here - left, right - here);
    return bent_before || bent_after ? Course::straight : Course::smooth;
}

}  // namespace

double at_or(const std::vector<double>& column, std::size_t k, double otherwise)
{
    return column.empty() ? otherwise : column[k];
}

double between(const std::vector<double>& x, std::size_t k, double s)
{
    if (k == 0 || k + 2 >= x.size()) return x[k] + s * (x[k + 1] - x[k]);
    const double a = x[k - 1], b = x[k], c = x[k + 1], d = x[k + 2];
    return b + 0.5 * s * (c - a + s * (2 * a - 5 * b + 4 * c - d + s * (3 * (b - c) + d - a)));
}

double reference_between(const std::vector<double>& x, std::size_t k, double s)
{
    switch (course_of(x, k, s)) {
        case Course::left:
            return x[k] + s * (x[k] - x[k - 1]);
        case Course::right:
            return x[k + 1] - (1 - s) * (x[k + 2] - x[k + 1]);
        case Course::straight:
            return x[k] + s * (x[k + 1] - x[k]);
        default:
            return between(x, k, s);
    }
}

double rate_between(const std::vector<double>& x, const std::vector<double>& rate, std::size_t k, double s)
{
    switch (course_of(x, k, s)) {
        case Course::left:
            return rate[k];
        case Course::right:
            return rate[k + 1];
        case Course::straight:
            return rate[k] + s * (rate[k + 1] - rate[k]);
        default:
            return between(rate, k, s);
    }
}

}  // namespace stickslip::gap
