#include "analysis/stability/comparison.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "analysis/numerics/maximum.h"
#include "analysis/stability/joint_crossings.h"
#include "analysis/stability/joint_spectrum.h"
#include "analysis/stability/real_loop.h"
#include "analysis/stability/stable_gains.h"
#include "analysis/stability/steady.h"

namespace stickslip {
namespace {

/// What of `set` lies in no interval of `other`. Both ascending and disjoint.
std::vector<Interval> without(const std::vector<Interval>& set, const std::vector<Interval>& other)
{
    std::vector<Interval> rest;
    for (auto piece : set) {
        for (const auto& hole : other) {
            if (hole.high <= piece.low || hole.low >= piece.high) continue;
            if (hole.low > piece.low) rest.push_back({piece.low, hole.low});
            piece.low = hole.high;
        }
        if (piece.low < piece.high) rest.push_back(piece);
    }
    return rest;
}

/// The part of the set that the search covers.
std::vector<Interval> up_to(double limit, std::vector<Interval> set)
{
    std::erase_if(set, [&](const Interval& i) { return i.low >= limit; });
    for (auto& i : set) i.high = std::min(i.high, limit);
    return set;
}

/// Damping that the joint knows of: a natural unit of k_v.
double damping_unit(const LinearJoint& j)
{
    double sum = std::abs(j.k_v), inertia = 0;
    for (int i = 0; i < j.bodies; ++i) {
        sum += std::abs(j.friction[i].f_v) + std::abs(kernel_integral(j.friction[i]));
        inertia += j.inertia[i];
    }
    return sum + std::sqrt(std::abs(j.k_p) * inertia);
}

/// By a scan, for joints with infinitely many roots.
std::vector<Interval> scanned_in_k_v(LinearJoint j)
{
    constexpr int steps = 60;
    constexpr double decades_below = 6, decades_above = 3, precision = 1e-6;
    const double unit = damping_unit(j);
    const auto stable = [&](double k_v) {
        j.k_v = k_v;
        return is_stable(j);
    };
    std::vector<Interval> found;
    double a = 0;
    bool at_a = stable(0);
    if (at_a) found.push_back({0, infinity});
    for (int i = 0; i <= steps; ++i) {
        const double b = unit * std::pow(10, -decades_below + (decades_below + decades_above) * i / steps);
        const bool at_b = stable(b);
        if (at_a != at_b) {
            double low = a, high = b;
            while (high - low > precision * high) {
                const double middle = (low + high) / 2;
                (stable(middle) == at_a ? low : high) = middle;
            }
            if (at_b)
                found.push_back({high, infinity});
            else
                found.back().high = low;
        }
        a = b, at_a = at_b;
    }
    return found;
}

std::vector<Interval> ideal_velocity_gains(const LinearJoint& j)
{
    return j.rational() ? stable_intervals(j, rational_crossings(j, Gain::k_v), infinity, Gain::k_v)
                        : scanned_in_k_v(j);
}

}  // namespace

std::optional<std::vector<Interval>> stable_velocity_gains(const Joint& joint, Theory theory)
{
    const auto steady = steady_sliding(joint);
    if (steady.reason != Reason::none) return std::vector<Interval>{};
    auto linear = linear_joint(joint, steady.slides_at);
    if (theory == Theory::velocity_only) linear = velocity_only(std::move(linear));
    if (loop_kind(joint) == LoopKind::ideal) return ideal_velocity_gains(linear);
    const auto loop = real_loop(joint, linear, steady.slides_at, TurnedGain::k_v);
    if (!loop) return std::nullopt;
    return turned_gains(*loop).stable;
}

Comparison compare_theories(const Joint& joint)
{
    return steady_sliding(joint).reason == Reason::none ? compare_theories(joint, joint, stable_gains(joint))
                                                        : Comparison{};
}

Comparison compare_theories(const Joint& joint, const Joint& as_given, const StableGains& gains)
{
    Comparison result;
    const auto thought = stable_gains(as_given, Theory::velocity_only);
    const auto k_v_memory = stable_velocity_gains(joint, Theory::state_variable);
    const auto k_v_simple = stable_velocity_gains(joint, Theory::velocity_only);
    result.known = gains.known && thought.known && k_v_memory && k_v_simple;
    if (!result.known) return result;
    result.searched_to = gains.searched_to;
    result.k_p_memory = gains.stable;
    result.k_p_velocity_only = up_to(result.searched_to, thought.stable);
    result.forbidden_needlessly = without(result.k_p_memory, result.k_p_velocity_only);
    result.allowed_wrongly = without(result.k_p_velocity_only, result.k_p_memory);
    result.k_v_memory = *k_v_memory;
    result.k_v_velocity_only = *k_v_simple;
    return result;
}

double least_position_gain(const Joint& joint)
{
    const auto steady = steady_sliding(joint);
    if (steady.reason != Reason::none) return missing;
    const auto gains = stable_gains(joint);
    return gains.stable.empty() ? missing : gains.stable.front().low;
}

GainMix optimal_mix(const Joint& given, double velocity_noise)
{
    GainMix best;
    const auto steady = steady_sliding(given);
    if (steady.reason != Reason::none) return best;
    Joint joint = given;
    const auto linear = linear_joint(joint, steady.slides_at);
    const auto mix = [&](double k_v) {
        joint.control.k_v = k_v;
        const double k_p = least_position_gain(joint);
        return GainMix{k_p, k_v, std::hypot(k_p, velocity_noise * k_v)};
    };
    const auto kind = loop_kind(joint);
    // each of the many searches below would end like this
    if (kind == LoopKind::ideal && crossings(linear).exhausted) return best;
    const auto quieter = [&](const GainMix& m) {
        if (m.noise < best.noise || std::isnan(best.noise)) best = m;
    };
    // from pure position feedback to the k_v that needs no position gain, and somewhat beyond
    const int steps = gain_moves_sliding(given) || kind == LoopKind::continuous ? 24
                      : linear.rational() && kind == LoopKind::ideal            ? 160
                                                                                : 40;
    const double unit = damping_unit(linear);
    std::vector<double> k_v{0};
    for (int i = 0; i <= steps; ++i) k_v.push_back(unit * std::pow(10, -5 + 6.0 * i / steps));
    std::size_t at = 0;
    for (std::size_t i = 0; i < k_v.size(); ++i) {
        const auto m = mix(k_v[i]);
        if (m.noise < best.noise || (std::isnan(best.noise) && !std::isnan(m.noise))) best = m, at = i;
    }
    if (std::isnan(best.noise)) return best;
    // the least k_v that is looked at needs no position gain: the noise goes to nothing with the gains
    if (at <= 1 && best.k_p == 0) return {0, 0, 0};
    const double low = k_v[at == 0 ? 0 : at - 1], high = k_v[std::min(at + 1, k_v.size() - 1)];
    quieter(mix(maximiser(
        [&](double v) {
            const double noise = mix(v).noise;
            return std::isnan(noise) ? -infinity : -noise;
        },
        low, high)));
    return best;
}

}  // namespace stickslip
