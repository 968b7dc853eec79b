// Where roots of a delayed loop cross the border of stability as its gain grows, and the gains between.
#include <Eigen/Dense>
#include <algorithm>
#include <numbers>

#include "analysis/base/work_limits.h"
#include "analysis/loop/root_count.h"
#include "analysis/numerics/eigenvalues.h"
#include "analysis/numerics/root.h"

namespace stickslip {
namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

/// The gain that puts a real root at 0, where −T is flat and not nothing from there to `beside`: an integrator, which
/// rounding may leave beside 0, is not.
std::optional<Crossing> crossing_at_rest(const OpenedLoop& open, double beside)
{
    constexpr double flat = 0.1;
    const double still = open.towards(0).real();
    if (!(still > 0 && std::abs(open.towards(Complex(0, beside)) - still) < flat * still)) return std::nullopt;
    const double left = open.towards(-beside).real(), right = open.towards(beside).real();
    return Crossing{1 / still, 0, right < left ? 1 : -1};
}

struct Reach {
    double from, to;
    double rounding;  ///< below it a pole may be an integrator
};
Reach features(const DelayedLoop& loop, const OpenedLoop& open)
{
    double low = infinity, high = 0;
    const auto take = [&](Complex s) {
        high = std::max(high, std::abs(s));
        if (std::abs(s) > 0) low = std::min(low, std::abs(s));
    };
    for (const Complex& s : open.poles()) take(s);
    if (loop.period == 0) {
        const Eigen::VectorXcd poles = eigenvalues_of(loop.A + loop.input * loop.held);
        for (const Complex& s : poles) take(s);
        for (const Complex& s : poles)
            if (std::abs(s) < 1e-9 * high) low = std::min(low, 1e-6 * high);
    }
    if (std::isfinite(open.turns_in())) low = std::min(low, open.turns_in());
    constexpr double turns = 50 * pi, far = 1e4, above = 30, integrator = 1e-9;
    const bool delayed = std::isfinite(open.turns_in());
    const double to = delayed ? std::max(turns * open.turns_in(), above * high) : far * high;
    return {1e-4 * low, std::isfinite(open.end()) ? open.end() : to, integrator * high};
}

/// A root at half the sampling rate, where z is −1 and every loop is real.
void cross_at_end(const OpenedLoop& open, double before, AxisCrossings& found)
{
    const Complex end = open.towards(Complex(0, open.end()));
    found.crossings.push_back({1 / end.real(), open.end(), before > 0 ? 1 : -1});
}

/// Whether a phase that has one sign at both ends of a step may have the other one within: as the middle shows, or the
/// parabola through all three, whose error is taken for a quarter of what they differ by.
bool may_cross_twice(double at, double middle, double there)
{
    constexpr double error = 0.25, rounding = 1e-12;
    if (std::signbit(at) != std::signbit(there)) return false;
    const double farthest = std::max(std::abs(at), std::abs(there));
    if (farthest < rounding) return false;
    if (std::signbit(middle) != std::signbit(at)) return std::abs(middle) > rounding;
    const double bend = std::abs(at) + std::abs(there) - 2 * std::abs(middle);
    const double slope = 0.5 * (std::abs(there) - std::abs(at));
    if (!(std::abs(slope) < bend)) return false;  // nearest to 0 at an end
    const double nearest = std::abs(middle) - slope * slope / (2 * bend);
    return nearest < error * (farthest - nearest);
}

}  // namespace

AxisCrossings axis_crossings(const DelayedLoop& loop)
{
    AxisCrossings found;
    if (!loop.A.allFinite()) return found;
    const OpenedLoop open(loop);
    const Reach reach = features(loop, open);
    const bool sampled = std::isfinite(open.end());
    const auto phase = [&](double omega) { return std::arg(open.towards(Complex(0, omega))); };
    const double widest = std::min(0.3 * open.turns_in(), reach.to);
    if (const auto still = crossing_at_rest(open, std::max(reach.from, reach.rounding)))
        found.crossings.push_back(*still);
    double omega = reach.from, at = phase(omega), step = 0.1 * omega;
    const auto turn = [](double from, double to) { return std::remainder(to - from, 2 * pi); };
    const auto doubt = [&](double from, double to) {
        auto& bands = found.doubtful;
        if (!bands.empty() && bands.back().high == from)
            bands.back().high = to;
        else
            bands.push_back({from, to});
    };
    // a band in which rounding turns the phase is left in growing steps
    constexpr double resolved = 1e-12;
    double least = resolved;
    for (long steps = 0; omega < reach.to; ++steps) {
        if (steps * open.cost() > work::crossing_steps) {
            doubt(omega, reach.to);
            break;
        }
        const double room = std::max(open.room(Complex(0, omega)), 1e-9 * omega);
        const double next = std::min(reach.to, omega + std::min({step, widest, room}));
        const double middle = phase(0.5 * (omega + next)), there = phase(next);
        const double first = turn(at, middle), second = turn(middle, there);
        const bool coarse = std::abs(first) > 0.3 || std::abs(second) > 0.3 || std::abs(first - second) > 0.1 ||
                            (std::abs(at) < 1 && may_cross_twice(at, middle, there));
        if (coarse && next - omega > least * next) {
            step = (next - omega) / 2;
            continue;
        }
        if (coarse) doubt(omega, next);
        least = coarse ? 4 * least : std::max(resolved, least / 2);
        if (sampled && next == reach.to && std::abs(there) < 1) {
            cross_at_end(open, at, found);
        } else if (!coarse && std::signbit(at) != std::signbit(there) && std::abs(at) < 1) {
            const double root = bracketed_root(phase, omega, at, next, there, 1e-15).value;
            const double gain = 1 / open.towards(Complex(0, root)).real();
            if (gain > 0) found.crossings.push_back({gain, root, there < at ? 1 : -1});
        }
        omega = next, at = there;
        step *= 1.6;
    }
    // further up each turn of the dead time asks for more gain still; a search that was cut short excludes no gain
    if (omega < reach.to)
        found.searched_to = 0;
    else if (!sampled && std::isfinite(open.turns_in()))
        found.searched_to = 0.5 / std::abs(open.towards(Complex(0, reach.to)));
    std::erase_if(found.crossings, [&](const Crossing& c) { return c.k_p > found.searched_to; });
    std::sort(found.crossings.begin(), found.crossings.end(),
              [](const Crossing& a, const Crossing& b) { return a.k_p < b.k_p; });
    return found;
}

namespace {

/// Growth somewhere between two neighbouring crossings, at the own gain where that lies there, so that no window
/// contradicts the verdict. Where it cannot be confirmed at one gain, another has the same sign.
double growth_between(const DelayedLoop& loop, double low, double high, double own)
{
    if (own > low && own < high) {
        const double growth = delayed_growth(loop, own);
        if (std::isfinite(growth)) return growth;
    }
    const double from = low > 0 ? low : high < infinity ? 1e-6 * high : 1, to = high < infinity ? high : 1e6 * from;
    for (const double share : {0.5, 0.25, 0.75, 0.1, 0.9}) {
        const double growth = delayed_side(loop, from * std::pow(to / from, share));
        if (std::isfinite(growth)) return growth;
    }
    return not_set;
}

/// By counting once, at one gain, and adding what each crossing brings over: long dead time has hundreds. Nothing
/// where that cannot be, as then a crossing is missing.
std::optional<std::vector<Interval>> stable_by_count(const DelayedLoop& loop, const AxisCrossings& all, double at)
{
    constexpr double beside = 1e-6;
    const OpenedLoop open(loop);
    // short dead time turns far above every root: the line has to stand left of the rightmost one
    const double growth = delayed_growth(loop, at), nearest = beside * std::min(open.turns_in(), growth);
    if (std::isnan(growth) || growth == 0) return std::nullopt;
    const auto there = growth < 0 ? std::optional(0) : roots_right_of(open, at, nearest, nearest);
    if (!there) return std::nullopt;
    const auto change = [&](const Crossing& c) {
        const bool real = c.omega == 0 || c.omega >= open.end();
        return (real ? 1 : 2) * c.direction;
    };
    int right = *there;
    for (const auto& c : all.crossings)
        if (c.k_p < at) right -= change(c);
    std::vector<Interval> intervals;
    double low = 0;
    for (std::size_t i = 0; i <= all.crossings.size(); ++i) {
        const double high = i < all.crossings.size() ? all.crossings[i].k_p : all.searched_to;
        if (right < 0) return std::nullopt;
        if (right == 0 && high > low) {
            if (!intervals.empty() && intervals.back().high == low)
                intervals.back().high = high;
            else
                intervals.push_back({low, high});
        }
        if (i < all.crossings.size()) right += change(all.crossings[i]);
        low = high;
    }
    return intervals;
}

}  // namespace

std::vector<Interval> stable_gains(const DelayedLoop& loop, AxisCrossings& all, double own)
{
    constexpr std::size_t many = 12;  // crossings, between which a growth each takes longer than it is worth
    if (all.crossings.size() > many && all.doubtful.empty()) {
        const double first = all.crossings[0].k_p, second = all.crossings[1].k_p;
        for (const double gain : {own, 0.5 * first, std::sqrt(first * second)})
            if (gain >= 0 && gain < all.searched_to)
                if (auto intervals = stable_by_count(loop, all, gain)) return *intervals;
    }
    std::vector<double> bounds{0};
    for (const auto& c : all.crossings) bounds.push_back(c.k_p);
    if (all.searched_to > bounds.back()) bounds.push_back(all.searched_to);
    std::vector<Interval> intervals;
    for (std::size_t i = 0; i + 1 < bounds.size(); ++i) {
        const double low = bounds[i], high = bounds[i + 1];
        const double growth = growth_between(loop, low, high, own);
        if (std::isnan(growth)) {
            // nothing is said of gains from here on
            all.searched_to = low;
            break;
        }
        if (!(growth < 0)) continue;
        if (!intervals.empty() && intervals.back().high == low)
            intervals.back().high = high;
        else
            intervals.push_back({low, high});
    }
    return intervals;
}

CommandMargins command_margins(const DelayedLoop& loop, const DelayedSpectrum& closed)
{
    const OpenedLoop open(loop);
    double size = 0;
    for (const auto& s : closed.roots) size = std::max(size, std::abs(s));
    constexpr double below = 1e-7, above = 1e2;
    const auto L = [&](double omega) {
        const Complex s(0, omega);
        return open.prompt(s).first * open.delayed(s);
    };
    const bool stable = closed.growth < 0;
    auto all = axis_crossings(loop);
    const auto factors = stable ? std::vector<Interval>{} : stable_gains(loop, all, 1);
    return command_margins(stable, all.crossings, factors, L, below * size, std::min(above * size, open.end()));
}

}  // namespace stickslip
