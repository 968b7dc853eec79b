#include "sweep/study/idle_axes.h"

#include "analysis/joint/parameters.h"
#include "analysis/joint/rules.h"
#include "analysis/simulation/set_point/set_point.h"
#include "analysis/stability/verdict.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

constexpr int tries = 5;  ///< values along an axis

/// Of an axis that knows only its ends, values between them.
std::vector<double> tried(const Axis& axis)
{
    const double low = axis.values.front(), high = axis.values.back();
    std::vector<double> values;
    for (int i = 0; i < tries; ++i) {
        const double part = static_cast<double>(i) / (tries - 1);
        if (axis.values.size() > 2)
            values.push_back(
                axis.values[static_cast<std::size_t>(std::lround(part * static_cast<double>(axis.values.size() - 1)))]);
        else if (axis.log && low > 0)
            values.push_back(i == 0 ? low : i == tries - 1 ? high : low * std::pow(high / low, part));
        else
            values.push_back(low + part * (high - low));
    }
    return values;
}

Joint moved(Joint joint, const std::string& path, double value)
{
    number_at(joint, path) = value;
    return joint;
}

bool same(double a, double b)
{
    return a == b || (std::isnan(a) && std::isnan(b));
}

/// Of all that have a verdict; with fewer than two there is nothing to compare.
bool unchanged(const Joint& joint, const std::string& path, const std::vector<double>& values)
{
    std::optional<PointResult> first;
    double first_value = 0, last_value = 0;
    int answers = 0;
    for (const double value : values) {
        const auto now = linear_point(moved(joint, path, value));
        if (now.reason != Reason::none) continue;
        if (!first) first = now, first_value = value;
        last_value = value;
        ++answers;
        if (!same(now.spectral_abscissa, first->spectral_abscissa) || !same(now.k_v_min, first->k_v_min) ||
            !same(now.k_cr, first->k_cr))
            return false;
    }
    if (answers < 2) return false;
    // neutral sliding stays neutral with its frequency changed
    const auto spectrum_at = [&](double value) {
        return linear_verdict(moved(joint, path, value)).state_variable.eigenvalues;
    };
    return spectrum_at(first_value) == spectrum_at(last_value);
}

/// Whether a term that a verdict names is this parameter or the table that holds it.
bool names(const std::string& key, const std::string& path)
{
    return path == key || path.starts_with(key + ".");
}

std::optional<IdleAxis> idle(const Joint& joint, const Axis& axis)
{
    const auto values = tried(axis);
    if (axis.values.size() < 2 || !unchanged(joint, axis.path, values)) return {};
    IdleAxis found{axis.path, {}, false};
    for (const double value : values)
        for (const auto& term : verdict_loop(moved(joint, axis.path, value)).not_used)
            if (names(term.key, axis.path)) found.why = term.why, found.matters |= term.matters;
    return found;
}

}  // namespace

std::vector<IdleAxis> idle_axes(const Joint& joint, const std::vector<Axis>& axes)
{
    std::vector<IdleAxis> list;
    for (const auto& axis : axes)
        if (auto found = idle(joint, axis)) list.push_back(std::move(*found));
    return list;
}

std::optional<IdleAxis> idle_at_rest(const Joint& joint, const Axis& axis)
{
    if (axis.values.size() < 2) return {};
    IdleAxis found{axis.path, {}, false, true};
    std::optional<SetPoint> first;
    for (const double value : tried(axis)) {
        const Joint there = moved(joint, axis.path, value);
        if (!obeys_rules(there)) continue;
        const auto now = set_point(there, quick_set_point);
        for (const auto& key : now.not_used) found.matters |= names(key, axis.path);
        if (!first) first = now;
        if (now.hunting != first->hunting || now.reason != first->reason || !same(now.amplitude, first->amplitude) ||
            !same(now.period, first->period) || !same(now.rest_error, first->rest_error) ||
            !same(now.multiplier, first->multiplier))
            return {};
    }
    if (!first) return {};
    return found;
}

std::vector<IdleAxis> idle_coordinates(const Joint& joint, const Uncertainty& uncertainty)
{
    std::vector<Axis> axes;
    for (std::size_t i = 0; i < uncertainty.share.size(); ++i) {
        const auto& c = uncertainty.coordinates[i];
        const double value = value_of(joint, c), share = uncertainty.share[i];
        if (!c.less.empty() || std::isnan(value)) continue;
        Axis axis;
        axis.path = c.path;
        axis.values = {value * (1 - share), value * (1 + share)};
        axes.push_back(std::move(axis));
    }
    return idle_axes(joint, axes);
}

}  // namespace stickslip
