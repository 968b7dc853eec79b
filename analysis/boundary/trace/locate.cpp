#include "analysis/boundary/trace/locate.h"

#include "analysis/joint/gains.h"
#include "analysis/joint/parameters.h"
#include "analysis/numerics/root.h"
#include "analysis/stability/joint_spectrum.h"
#include "analysis/stability/neutral.h"
#include "analysis/stability/real_loop.h"
#include "analysis/stability/spectrum.h"
#include "analysis/stability/steady.h"
#include "analysis/stability/winding.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace stickslip {
namespace {

/// A mass whose friction is of velocity or of states has its growth rate as soon as its side.
bool is_told_at_once(const Joint& joint, Curve::Kind theory)
{
    if (joint.mechanism.model != Model::single_mass) return false;
    if (theory == Curve::Kind::velocity_only) return true;
    const auto steady = possible_sliding(joint);
    return steady.reason != Reason::none || !is_plain_mass(joint) ||
           linear_mass(joint, steady.slides_at).friction.rational();
}

}  // namespace

double instability(const Joint& joint, Curve::Kind theory)
{
    if (theory == Curve::Kind::ideal_loop) return growth_rate(with_ideal_loop(joint));
    if (theory == Curve::Kind::velocity_only) {
        const auto steady = possible_sliding(joint);
        if (steady.reason != Reason::none) return missing;
        if (loop_kind(joint) != LoopKind::ideal) return real_growth(joint, true);
        const auto& c = joint.control;
        if (joint.mechanism.model != Model::single_mass || c.force_gain != 0 || c.contact_stiffness != 0 ||
            joint.normal.moves() || joint.neighbour.size > 0)
            return spectral_abscissa(velocity_only(linear_joint(joint, steady.slides_at)));
        const auto mass = linear_mass(joint, steady.slides_at);
        return std::max(-velocity_only_damping(mass, mass.k_v), -mass.k_p);
    }
    return growth_rate(joint);
}

std::optional<bool> is_stable(const Joint& joint, Curve::Kind theory)
{
    if (loop_kind(joint) == LoopKind::ideal && !is_told_at_once(joint, theory)) {
        const auto steady = possible_sliding(joint);
        if (steady.reason != Reason::none) return {};
        auto linear = linear_joint(with_gains(joint), steady.slides_at);
        if (theory == Curve::Kind::velocity_only) linear = velocity_only(linear);
        if (linear.rational()) return is_stable(linear);
        // nothing is counted where a root lies on the axis within rounding
        if (const auto unstable = roots_right_of(linear, 0)) return *unstable == 0;
    }
    if (theory != Curve::Kind::ideal_loop && loop_kind(joint) != LoopKind::ideal) {
        const auto steady = possible_sliding(joint);
        if (steady.reason != Reason::none) return {};
        // of delayed loops a count of roots, where the growth is a search for one
        const double side = real_side(joint, theory == Curve::Kind::velocity_only);
        if (std::isnan(side)) return {};
        return side < 0;
    }
    const double size = instability(joint, theory);
    if (std::isnan(size)) return {};
    return size < 0;
}

std::vector<BoundaryPoint> locate_on_ray(const Joint& given, std::string_view path, double low, double high, bool log,
                                         Curve::Kind theory, int scan)
{
    Joint joint = given;
    const auto parameter = number_at(joint, path);
    const auto at = [&](double value) {
        parameter = value;
        return instability(joint, theory);
    };
    const auto node = [&](int i) {
        const double share = static_cast<double>(i) / scan;
        return i == 0 ? low : i == scan ? high : log ? low * std::pow(high / low, share) : low + share * (high - low);
    };
    std::vector<BoundaryPoint> found;
    double a = low, fa = at(low);
    for (int i = 1; i <= scan; ++i) {
        const double b = node(i), fb = at(b);
        if (!std::isnan(fa + fb) && (fa < 0) != (fb < 0)) {
            const auto root = bracketed_root(at, a, fa, b, fb, linear_precision);
            found.push_back({root.value, root.low, root.high, fb > fa ? 1 : -1, root.converged, root.evaluations});
        }
        a = b, fa = fb;
    }
    return found;
}

Margin margin_along(const Joint& joint, const Axis& axis)
{
    Margin margin;
    margin.axis = axis;
    margin.axis.values.clear();
    const double* parameter = find_parameter(joint, axis.path);
    if (!parameter) throw std::invalid_argument("no number at " + axis.path);
    margin.value = *parameter;
    const bool log = axis.log && margin.value > 0;
    margin.low = std::min(axis.values.front(), margin.value);
    margin.high = std::max(axis.values.back(), margin.value);
    if (log) margin.low /= 10, margin.high *= 10;
    for (const auto& point :
         locate_on_ray(joint, axis.path, margin.low, margin.high, log, Curve::Kind::state_variable, 400)) {
        const auto away = [&](double v) {
            return log ? std::abs(std::log(v / margin.value)) : std::abs(v - margin.value);
        };
        if (margin.found && away(point.value) >= away(margin.boundary)) continue;
        margin.found = true;
        margin.boundary = point.value;
    }
    return margin;
}

}  // namespace stickslip
