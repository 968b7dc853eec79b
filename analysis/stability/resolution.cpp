#include "analysis/stability/resolution.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "analysis/numerics/maximum.h"
#include "analysis/numerics/root.h"
#include "analysis/stability/gain_scan.h"
#include "analysis/stability/joint_crossings.h"
#include "analysis/stability/joint_spectrum.h"
#include "analysis/stability/linear_friction.h"
#include "analysis/stability/real_loop.h"
#include "analysis/stability/steady.h"
#include "analysis/stability/winding.h"

namespace stickslip {
namespace {

/// Negative where the joint is stable at its own velocity, by either theory; NaN where it cannot slide. With dead time
/// or delayed friction only its sign is that of the growth: counting roots costs less than locating them.
double instability(const Joint& joint, Theory theory)
{
    const bool simple = theory == Theory::velocity_only;
    const auto steady = possible_sliding(joint);
    if (steady.reason != Reason::none) return missing;
    if (loop_kind(joint) != LoopKind::ideal) return real_side(joint, simple);
    if (simple) return velocity_only_growth_rate(joint);
    const auto linear = linear_joint(joint, steady.slides_at);
    if (linear.rational()) return growth_rate(joint);
    const auto right = roots_right_of(linear, 0);
    return !right ? missing : *right == 0 ? -1 : 1;
}

/// Where f, known at one of two places and not at the other, stops being known.
template <class Function>
double end_of_known(Function&& f, double known, double unknown)
{
    constexpr double close = 1e-10;
    while (std::abs(unknown - known) > close * std::abs(known)) {
        const double middle = 0.5 * (known + unknown);
        (std::isnan(f(middle)) ? unknown : known) = middle;
    }
    return known;
}

/// Where the sign of f changes between a and b; what is not known is not negative.
template <class Function>
double change_between(Function&& f, double a, double fa, double b, double fb)
{
    const double end = std::isnan(fa) ? end_of_known(f, b, a) : std::isnan(fb) ? end_of_known(f, a, b) : not_set;
    if (std::isnan(fa)) a = end, fa = f(a);
    if (std::isnan(fb)) b = end, fb = f(b);
    if ((fa < 0) == (fb < 0)) return end;
    return bracketed_root(f, a, fa, b, fb, 1e-10).value;
}

/// Where f < 0 within [low, high] of one sign, by a logarithmic scan and bracketed roots.
template <class Function>
std::vector<Interval> negative_intervals(Function&& f, double low, double high, int scan)
{
    std::vector<Interval> found;
    double a = low, fa = f(a);
    if (fa < 0) found.push_back({low, high});
    for (int i = 1; i <= scan; ++i) {
        const double b = i == scan ? high : low * std::pow(high / low, double(i) / scan), fb = f(b);
        if ((fa < 0) != (fb < 0)) {
            const double change = change_between(f, a, fa, b, fb);
            if (fb < 0)
                found.push_back({change, high});
            else
                found.back().high = change;
        }
        a = b, fa = fb;
    }
    return found;
}

/// What lies in both. Ascending and disjoint, as the result.
std::vector<Interval> common(const std::vector<Interval>& a, const std::vector<Interval>& b)
{
    std::vector<Interval> both;
    for (const auto& i : a)
        for (const auto& k : b)
            if (std::max(i.low, k.low) < std::min(i.high, k.high))
                both.push_back({std::max(i.low, k.low), std::min(i.high, k.high)});
    return both;
}

}  // namespace

StableVelocities stable_velocities(const Joint& given, double low, double high, Theory theory, int scan)
{
    Joint joint = given;
    joint.control.force_rate = not_set;
    const auto at = [&](double V) {
        joint.control.V0 = V;
        return instability(joint, theory);
    };
    // speeds rise away from rest, whichever way the joint moves
    const double turned = high < 0 ? -1 : 1, slowest = turned * (high < 0 ? high : low),
                 fastest = turned * (high < 0 ? low : high);
    StableVelocities result;
    auto speeds = negative_intervals([&](double speed) { return at(turned * speed); }, slowest, fastest, scan);
    if (speeds.empty()) return result;
    result.least = turned * speeds.front().low;
    if (speeds.back().high == fastest) result.all_above = turned * speeds.back().low;
    if (turned < 0) {
        std::reverse(speeds.begin(), speeds.end());
        for (auto& i : speeds) i = {-i.high, -i.low};
    }
    result.intervals = std::move(speeds);
    if (given.control.kind == ControlKind::force)
        result.least_force_rate = result.least * (given.control.k_p + given.control.contact_stiffness);
    return result;
}

std::vector<Interval> stable_springs(const Joint& given, double rate, double low, double high, Theory theory)
{
    if (given.control.kind != ControlKind::force)
        throw std::invalid_argument("a force ramps through a spring in force control only");
    Joint joint = given;
    joint.control.force_rate = rate;
    const auto at = [&](double k_p) {
        joint.control.k_p = k_p;
        return instability(joint, theory);
    };
    constexpr int scan = 60;  // a real loop asks for a count of roots at each
    if (loop_kind(joint) != LoopKind::ideal) return negative_intervals(at, low, high, scan);
    joint.control.k_p = std::clamp(given.control.k_p, low, high);
    if (steady_sliding(joint).reason != Reason::none) return {};
    const auto gains = gain_moves_sliding(joint) ? scan_gains(joint, theory, {low, high}) : stable_gains(joint, theory);
    return common(gains.stable, {{low, std::min(high, gains.searched_to)}});
}

namespace {

/// For several bodies and real loops, where too much velocity feedback is unstable, too.
RangeGain common_gain(const Joint& joint, const std::vector<double>& V)
{
    const bool ideal = loop_kind(joint) == LoopKind::ideal;
    Joint there = joint;
    there.control.force_rate = not_set;
    const auto gains = [&](double commanded) {
        there.control.V0 = commanded;
        const double v = sliding_velocity(there);
        auto linear = linear_joint(joint, v);
        if (ideal) return velocity_only_gains(linear);
        const auto loop = real_loop(joint, velocity_only(std::move(linear)), v, TurnedGain::k_v);
        return loop ? turned_gains(*loop).stable : std::vector<Interval>{};
    };
    const auto least = [&](double v) {
        const auto stable = gains(v);
        return stable.empty() ? infinity : stable.front().low;
    };
    RangeGain range{missing, V.front(), {{0, infinity}}};
    std::size_t best = 0;
    double most = -infinity;
    for (std::size_t i = 0; i < V.size() && !range.stable_k_v.empty(); ++i) {
        const auto stable = gains(V[i]);
        range.stable_k_v = common(range.stable_k_v, stable);
        const double low = stable.empty() ? infinity : stable.front().low;
        if (low > most) most = low, best = i;
    }
    range.velocity = V[best];
    if (range.stable_k_v.empty()) return range;
    const auto [near, far] = std::minmax(V[best == 0 ? 0 : best - 1], V[std::min(best + 1, V.size() - 1)]);
    const double between = maximiser(least, near, far);
    if (least(between) > most) {
        range.velocity = between;
        range.stable_k_v = common(range.stable_k_v, gains(between));
    }
    if (!range.stable_k_v.empty()) range.k_v = range.stable_k_v.front().low;
    return range;
}

}  // namespace

RangeGain velocity_gain_for_range(const Joint& joint, double highest, int scan)
{
    const auto falling = [&](double V) { return -steady_slope(linearise(joint.friction, V)); };
    std::vector<double> V;
    for (int i = 0; i <= scan; ++i) V.push_back(highest * std::pow(1e-6, 1 - double(i) / scan));
    if (joint.mechanism.model != Model::single_mass || loop_kind(joint) != LoopKind::ideal)
        return common_gain(joint, V);
    std::size_t best = 0;
    for (std::size_t i = 1; i < V.size(); ++i)
        if (falling(V[i]) > falling(V[best])) best = i;
    const auto [near, far] = std::minmax(V[best == 0 ? 0 : best - 1], V[std::min(best + 1, V.size() - 1)]);
    double hardest = maximiser(falling, near, far);
    // the ends of the range belong to it
    for (const double end : {V.front(), V.back()})
        if (falling(end) > falling(hardest)) hardest = end;
    const double k_v = std::max(0.0, falling(hardest));
    return {k_v, hardest, {{k_v, infinity}}};
}

}  // namespace stickslip
