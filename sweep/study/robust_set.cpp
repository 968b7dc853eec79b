#include "sweep/study/robust_set.h"

#include "analysis/boundary/trace/locate.h"
#include "analysis/joint/parameters.h"
#include "sweep/study/samples.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

constexpr int chart_columns = 161, chart_rows = 121;  ///< as fine as the lines are wide
constexpr double aside = 1e-3;                        ///< of a row's height

/// Where the curve crosses the row at y, ascending.
std::vector<double> crossings(const Curve& curve, double y)
{
    std::vector<double> found;
    for (std::size_t i = 1; i < curve.x.size(); ++i) {
        const double a = curve.y[i - 1], b = curve.y[i];
        if (std::isnan(a) || std::isnan(b) || (a < y) == (b < y)) continue;
        found.push_back(curve.x[i - 1] + (y - a) / (b - a) * (curve.x[i] - curve.x[i - 1]));
    }
    std::sort(found.begin(), found.end());
    return found;
}

/// Whether each node of a row is stable: known at its left end, changing at each crossing.
std::vector<bool> row_of(const std::vector<double>& x, const std::vector<double>& crossings, bool stable_at_left)
{
    std::vector<bool> stable;
    for (const double v : x) {
        const auto passed = std::lower_bound(crossings.begin(), crossings.end(), v) - crossings.begin();
        stable.push_back(stable_at_left != (passed % 2 == 1));
    }
    return stable;
}

}  // namespace

RobustSet robust_set(const MarginsAnswer& a)
{
    RobustSet set{a.robust->x, a.robust->y, {}};
    set.x.values = spaced(set.x.values.front(), set.x.values.back(), chart_columns, set.x.log);
    set.y.values = spaced(set.y.values.front(), set.y.values.back(), chart_rows, set.y.log);
    const auto robust_curve = curve_of(*a.robust), nominal_curve = curve_of(*a.nominal);
    Joint joint = a.joint;
    number_at(joint, set.x.path) = set.x.values.front();
    const auto y = number_at(joint, set.y.path);
    const auto& ys = set.y.values;
    for (std::size_t j = 0; j < ys.size(); ++j) {
        // curves end on the borders: their rows are taken a little within
        const double v = j == 0               ? ys[0] + aside * (ys[1] - ys[0])
                         : j + 1 == ys.size() ? ys[j] - aside * (ys[j] - ys[j - 1])
                                              : ys[j];
        y = v;
        const double described = instability(joint, Curve::Kind::state_variable);
        const double worst = worst_case(joint, a.uncertainty, Curve::Kind::state_variable, false).instability;
        const auto stable = row_of(set.x.values, crossings(nominal_curve, v), described < 0);
        const auto always = row_of(set.x.values, crossings(robust_curve, v), worst < 0);
        const bool decided = !std::isnan(described) && !std::isnan(worst);
        for (std::size_t i = 0; i < stable.size(); ++i)
            set.classes.push_back(!decided    ? RobustClass::no_verdict
                                  : always[i] ? RobustClass::robust
                                  : stable[i] ? RobustClass::nominal_only
                                              : RobustClass::unstable);
    }
    return set;
}

}  // namespace stickslip
