// What a located boundary point costs, against plain bisection on the rows of a grid: every node of a row is evaluated,
// and each change of side is halved until its bracket is as narrow. CPU time, since a shared machine's clock counts
// what else runs on it. Prints, asserts nothing about time.
#include "analysis/boundary/kinds/boundary.h"
#include "analysis/joint/parameters.h"
#include "analysis/simulation/attractor/nonlinear.h"
#include "tests/analysis/boundary/axis.h"
#include "tests/analysis/simulation/joints.h"

#include <cmath>
#include <cstdio>
#include <ctime>

using namespace stickslip;

namespace {

constexpr int grid_columns = 121;  // of the grid that a sweep would have along x

double cpu_seconds()
{
    timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Cost {
    int points = 0;
    long evaluations = 0;
    double cpu = 0;  ///< s
};

/// Evaluates a row of the grid along x and halves each change.
template <class Side>
void bisect_row(Side&& side, const Axis& x, double precision, Cost& cost)
{
    const auto start = cpu_seconds();
    const double low = x.values[0], ratio = x.values[1] / low;
    double a = low, fa = side(a);
    ++cost.evaluations;
    for (int i = 1; i < grid_columns; ++i) {
        const double b = low * std::pow(ratio, static_cast<double>(i) / (grid_columns - 1)), fb = side(b);
        ++cost.evaluations;
        if ((fa < 0) != (fb < 0) && !std::isnan(fa) && !std::isnan(fb)) {
            double l = a, h = b;
            while (h - l > precision * l) {
                const double middle = (l + h) / 2;
                ++cost.evaluations;
                if (middle <= l || middle >= h) break;
                ((side(middle) < 0) == (fa < 0) ? l : h) = middle;
            }
            ++cost.points;
        }
        a = b, fa = fb;
    }
    cost.cpu += cpu_seconds() - start;
}

void print(const char* name, const Cost& followed, const Cost& bisected, double precision)
{
    const auto per = [](const Cost& c) { return static_cast<double>(c.evaluations) / c.points; };
    const double a = per(followed), b = per(bisected);
    std::printf(
        "%-16s %7.0e | %6d points %8.1f evaluations, %9.1f µs a point | %4d points %8.1f evaluations, %9.1f µs "
        "a point | %5.1f times fewer, %5.1f times faster\n",
        name, precision, followed.points, a, 1e6 * followed.cpu / followed.points, bisected.points, b,
        1e6 * bisected.cpu / bisected.points, b / a, bisected.cpu / bisected.points / (followed.cpu / followed.points));
}

void compare(const char* name, BoundaryRequest request, const Joint& joint, const Axis& x, const Axis& y, int rows)
{
    const auto start = cpu_seconds();
    const auto curve = follow_boundaries(joint, x, y, request);
    const Cost followed{curve.points(), curve.evaluations, cpu_seconds() - start};
    const double precision = default_precision(request.kind);
    // what bisection asks of a fold: whether any cycle is reached from near rest
    BoundaryRequest side = request;
    if (request.kind == BoundaryKind::fold) {
        side.kind = BoundaryKind::outcome;
        side.disturbance = {DisturbanceKind::start, 1e-4};
    }
    Cost bisected;
    Joint copy = joint;
    const auto u = number_at(copy, x.path), v = number_at(copy, y.path);
    for (int j = 0; j < rows; ++j) {
        const double share = (j + 0.5) / rows;
        v = y.log ? y.values[0] * std::pow(y.values[1] / y.values[0], share)
                  : y.values[0] + share * (y.values[1] - y.values[0]);
        bisect_row(
            [&](double value) {
                u = value;
                return side_of(copy, side);
            },
            x, precision, bisected);
    }
    print(name, followed, bisected, precision);
}

}  // namespace

int main()
{
    std::printf("%-16s %7s | followed, guard and starts included | grid of %d columns and bisection\n", "kind",
                "bracket", grid_columns);
    BoundaryRequest request;
    request.kind = BoundaryKind::state_variable;
    compare("linear", request, example_joint(6e4, 10, 1e-3), axis("control.k_p", 1e3, 1e6), axis("control.k_v", 1, 1e3),
            81);
    compare("linear over V_0", request, example_joint(6e4, 0, 1e-3), axis("control.k_p", 1e3, 1e6),
            axis("control.V0", 1e-6, 1e-2), 81);
    request.kind = BoundaryKind::fold;
    compare("fold", request, example_joint(2.2e4, 47.5, 1e-2), axis("control.k_p", 1e4, 6e4),
            axis("control.k_v", 44.6, 50.5, false), 2);
    request.kind = BoundaryKind::outcome;
    request.disturbance = {DisturbanceKind::position, 5e-5};
    compare("outcome", request, example_joint(2.2e4, 47.5, 1e-2), axis("control.k_p", 1e4, 6e4),
            axis("control.k_v", 44.6, 49.5, false), 2);
}
