#include "sweep/study/maps.h"

#include "analysis/boundary/trace/locate.h"
#include "analysis/joint/parameters.h"
#include "analysis/results/text.h"
#include "analysis/stability/verdict.h"

#include <tbb/parallel_for.h>

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

double& number_at(Joint& joint, const std::string& path)
{
    double* number = find_parameter(joint, path);
    if (!number) throw std::invalid_argument("the joint has no number " + path);
    return *number;
}

bool within(const Axis& axis, double value)
{
    return value >= axis.values.front() && value <= axis.values.back();
}

constexpr int layer_mesh = 32;

}  // namespace

std::string held_text(const std::vector<Held>& held, Motion motion)
{
    std::string text;
    for (const auto& h : held)
        text += (text.empty() ? "" : ", ") + h.axis.symbol + " = " + with_unit(h.value, h.axis.quantity, motion);
    return text;
}

Joint joint_at(Joint joint, const std::vector<Held>& held)
{
    for (const auto& h : held) number_at(joint, h.axis.path) = h.value;
    return joint;
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

DesignPoint design_point(const Joint& given, const Slice& slice)
{
    Joint design = given;
    DesignPoint point;
    point.x = number_at(design, slice.x.path);
    point.y = number_at(design, slice.y.path);
    point.inside = within(slice.x, point.x) && within(slice.y, point.y);
    const auto row = linear_point(joint_at(design, slice.held));
    point.region = row.region;
    point.spectral_abscissa = row.spectral_abscissa;
    return point;
}

std::vector<Curve> chart_boundaries(const Joint& joint, const Axis& x, const Axis& y, int mesh)
{
    std::vector<Curve> curves;
    for (const auto theory : {Curve::Kind::velocity_only, Curve::Kind::state_variable}) {
        auto curve = locate_over_chart(joint, x, y, theory, mesh);
        if (!curve.x.empty()) curves.push_back(std::move(curve));
    }
    return curves;
}

StabilityMap stability_map(const Joint& design, const Slice& slice)
{
    StabilityMap map;
    map.motion = design.mechanism.motion;
    map.title = "Stability of sliding over (" + slice.x.symbol + ", " + slice.y.symbol + ")";
    map.fixed = held_text(slice.held, map.motion);
    map.x = slice.x;
    map.y = slice.y;
    map.abscissa = slice.abscissa;
    map.region = slice.region;
    const auto shares = area_shares(slice.x, slice.y);
    for (std::size_t i = 0; i < shares.size(); ++i) {
        if (map.region[i] == Region::memory_only || map.region[i] == Region::velocity_only)
            map.disagreement += shares[i];
        if (map.region[i] == Region::undecided) map.undecided += shares[i];
    }
    const Joint held = joint_at(design, slice.held);
    map.curves = chart_boundaries(held, slice.x, slice.y, map_mesh);
    map.readings = slice.readings;
    map.depth = slice.depth;
    map.layers = slice.layers;
    for (const auto& h : slice.held)
        if (h.axis.path == slice.depth.path) map.depth_value = h.value;
    tbb::parallel_for(std::size_t{0}, map.layers.size(), [&](std::size_t i) {
        Joint joint = held;
        number_at(joint, slice.depth.path) = map.layers[i].value;
        map.layers[i].curves = chart_boundaries(joint, slice.x, slice.y, layer_mesh);
    });
    map.has_design = true;
    map.design = design_point(design, slice);
    return map;
}

CriticalGainSurface critical_gain_surface(const Joint& design, const Axis& x, const Axis& y)
{
    CriticalGainSurface surface;
    surface.title = "Critical position gain k_{cr}(" + x.symbol + ", " + y.symbol + ")";
    surface.motion = design.mechanism.motion;
    surface.x = x;
    surface.y = y;
    surface.z_name = "critical position gain";
    surface.z_symbol = "k_{cr}";
    Joint joint = design;
    double &u = number_at(joint, x.path), &v = number_at(joint, y.path);
    for (const double b : y.values)
        for (const double a : x.values) {
            u = a, v = b;
            surface.z.push_back(linear_point(joint).k_cr);
        }
    return surface;
}

std::string where_no_critical_gain(Joint joint, const CriticalGainSurface& surface)
{
    int always = 0, never = 0, windows = 0;
    double &u = number_at(joint, surface.x.path), &v = number_at(joint, surface.y.path);
    std::size_t place = 0;
    for (const double b : surface.y.values)
        for (const double a : surface.x.values) {
            if (std::isfinite(surface.z[place++])) continue;
            u = a, v = b;
            const auto verdict = linear_verdict(joint);
            if (verdict.steady.reason != Reason::none) continue;
            const auto& stable = verdict.state_variable.stable_intervals;
            if (stable.empty())
                ++never;
            else if (stable.size() == 1 && stable[0].low <= 0 && stable[0].high == infinity)
                ++always;
            else
                ++windows;
        }
    std::string text;
    if (always) text += " Every positive gain is stable at " + percent(double(always) / place) + " of the places.";
    if (never) text += " No gain is stable at " + percent(double(never) / place) + ".";
    if (windows) text += " Windows of gains are stable at " + percent(double(windows) / place) + ".";
    return text.empty() ? text : " Where the surface is missing:" + text;
}

}  // namespace stickslip
