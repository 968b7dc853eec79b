#include "analysis/stability/reduction_error.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "analysis/joint/parameters.h"
#include "analysis/numerics/root.h"
#include "analysis/stability/joint_crossings.h"
#include "analysis/stability/joint_spectrum.h"
#include "analysis/stability/real_loop.h"
#include "analysis/stability/stable_gains.h"
#include "analysis/stability/steady.h"
#include "analysis/stability/verdict.h"

namespace stickslip {
namespace {

/// Every sign change of f over a logarithmic scan.
template <class Function>
std::vector<double> sign_changes(Function&& f, double low, double high, int scan)
{
    std::vector<double> found;
    double a = low, fa = f(a);
    for (int i = 1; i <= scan; ++i) {
        const double b = low * std::pow(high / low, double(i) / scan), fb = f(b);
        if (std::signbit(fa) != std::signbit(fb) && !std::isnan(fa) && !std::isnan(fb))
            found.push_back(bracketed_root(f, a, fa, b, fb, 1e-10).value);
        a = b, fa = fb;
    }
    return found;
}

/// Of the loop that the joint has.
StableGains windows(const Reduction& joint, double velocity)
{
    StableGains gains;
    if (loop_kind(joint.joint) == LoopKind::ideal) {
        const auto linear = linear_joint(joint, velocity);
        auto search = crossings(linear);
        gains.stable = stable_intervals(linear, search.crossings, search.searched_to);
        gains.searched_to = search.searched_to;
        return gains;
    }
    if (const auto loop = real_loop(joint.joint, linear_joint(joint, velocity), velocity, TurnedGain::k_p))
        return turned_gains(*loop);
    return gains;
}

/// The ends of the stable set in k_p: exact where the spectrum's real parts drown in rounding, and faster than a scan.
std::vector<double> gain_boundaries(const Reduction& joint, double low, double high)
{
    std::vector<double> found;
    const auto steady = steady_sliding(joint.joint);
    if (steady.reason != Reason::none) return found;
    const auto gains = windows(joint, steady.slides_at);
    for (const auto& stable : gains.stable)
        for (const double end : {stable.low, stable.high})
            if (end > low && end < high && end != gains.searched_to) found.push_back(end);
    return found;
}

/// Two frictions on one body at one velocity. There must be room (three_mass_to_two_mass).
LinearFriction sum(LinearFriction a, const LinearFriction& b)
{
    a.f_v += b.f_v;
    for (int i = 0; i < b.states; ++i, ++a.states) {
        a.lambda[a.states] = b.lambda[i];
        a.b[a.states] = b.b[i];
        a.h[a.states] = b.h[i];
    }
    for (const auto& d : b.delays) a.delays.push_back(d);
    if (b.table) a.table = b.table, a.table_scale = b.table_scale;
    return a;
}

}  // namespace

LinearJoint linear_joint(const Reduction& reduced, double V)
{
    auto linear = linear_joint(reduced.joint, V);
    const Chain chain = chain_of(reduced.joint);
    for (const auto& j : reduced.joined) {
        const int at = j.on_link ? linear.link() : 0;
        const auto& body = chain.body[at];
        auto own = reflected(linearise(j.friction, j.turns * body.velocity(V)), j.turns * body.ratio);
        linear.friction[at] = sum(std::move(linear.friction[at]), own);
    }
    return linear;
}

double growth_rate(const Reduction& reduced)
{
    if (reduced.joined.empty()) return growth_rate(reduced.joint);
    const auto steady = steady_sliding(reduced.joint);
    if (steady.reason != Reason::none) return missing;
    if (loop_kind(reduced.joint) == LoopKind::ideal) return spectral_abscissa(linear_joint(reduced, steady.slides_at));
    const double sliding = steady.slides_at;
    const auto loop = real_loop(reduced.joint, linear_joint(reduced, sliding), sliding, TurnedGain::all);
    return loop ? growth(*loop) : missing;
}

namespace {

/// A number with the sign of the growth; behind dead time a count of roots, which costs much less than to locate them.
double side(const Reduction& reduced)
{
    const auto steady = steady_sliding(reduced.joint);
    if (steady.reason != Reason::none) return missing;
    if (loop_kind(reduced.joint) != LoopKind::continuous) return growth_rate(reduced);
    const double sliding = steady.slides_at;
    const auto loop = real_loop(reduced.joint, linear_joint(reduced, sliding), sliding, TurnedGain::all);
    return loop ? side(*loop) : missing;
}

}  // namespace

ReductionError compare_reduction(const Joint& full, const std::function<Reduction(const Joint&)>& reduce,
                                 std::string_view path, double low, double high, int scan)
{
    Joint joint = full;
    const auto parameter = number_at(joint, path);
    Reduction whole;
    const auto side_at = [&](double value, bool reduced) {
        parameter = value;
        if (reduced) return side(reduce(joint));
        whole.joint = joint;
        return side(whole);
    };
    ReductionError result;
    const Reduction small = reduce(full);
    // crossings in k_p are those at one velocity, and of a reduction that leaves the loop as it is
    if (path == "control.k_p" && small.joint.control.k_p == full.control.k_p && !gain_moves_sliding(full)) {
        whole.joint = full;
        result.full = gain_boundaries(whole, low, high);
        result.reduced = gain_boundaries(small, low, high);
    } else {
        result.full = sign_changes([&](double v) { return side_at(v, false); }, low, high, scan);
        result.reduced = sign_changes([&](double v) { return side_at(v, true); }, low, high, scan);
    }
    if (result.full.size() != result.reduced.size()) {
        result.error = infinity;
        return result;
    }
    if (!result.full.empty()) result.error = 0;
    for (std::size_t i = 0; i < result.full.size(); ++i)
        result.error = std::max(result.error, std::abs(result.reduced[i] / result.full[i] - 1));
    return result;
}

}  // namespace stickslip
