#include "sweep/study/maps.h"

#include "analysis/joint/parameters.h"
#include "analysis/results/text.h"

#include <cmath>
#include <stdexcept>

namespace stickslip {
namespace {

/// Length of axis, as drawn, for which each value stands: half way to its neighbours.
std::vector<double> node_lengths(const Axis& axis)
{
    const auto& v = axis.values;
    if (v.size() < 2) return {1};
    const auto drawn = [&](std::size_t i) { return axis.log ? std::log(v[i]) : v[i]; };
    std::vector<double> lengths(v.size());
    for (std::size_t i = 0; i < v.size(); ++i) {
        const double low = i == 0 ? drawn(0) : (drawn(i - 1) + drawn(i)) / 2;
        const double high = i + 1 == v.size() ? drawn(i) : (drawn(i) + drawn(i + 1)) / 2;
        lengths[i] = (high - low) / (drawn(v.size() - 1) - drawn(0));
    }
    return lengths;
}

bool within(const Axis& axis, double value)
{
    return value >= axis.values.front() && value <= axis.values.back();
}

}  // namespace

std::string held_text(const std::vector<Held>& held, Units units)
{
    std::string text;
    for (const auto& h : held)
        text += (text.empty() ? "" : ", ") + h.axis.symbol + " = " + with_unit(h.value, h.axis.quantity, units);
    return text;
}

Joint joint_at(Joint joint, const std::vector<Held>& held)
{
    for (const auto& h : held) number_at(joint, h.axis.path) = h.value;
    return joint;
}

DesignPoint place_over(Joint design, const Axis& x, const Axis& y)
{
    DesignPoint point;
    point.x = number_at(design, x.path);
    point.y = number_at(design, y.path);
    point.inside = within(x, point.x) && within(y, point.y);
    return point;
}

std::vector<double> area_shares(const Axis& x, const Axis& y)
{
    const auto across = node_lengths(x), up = node_lengths(y);
    std::vector<double> shares;
    shares.reserve(across.size() * up.size());
    for (const double b : up)
        for (const double a : across) shares.push_back(a * b);
    return shares;
}

}  // namespace stickslip
