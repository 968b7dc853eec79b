#include "analysis/loop/command_margins.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "analysis/numerics/root.h"

namespace stickslip {
namespace {

constexpr double degrees = 180 / std::numbers::pi;

/// Of two angles from −1, the one that tells how far off stability an unstable loop is: one that lag has passed, and
/// the smaller of two such.
bool tells_more(double candidate, double kept)
{
    if (std::isnan(kept) || (candidate < 0) != (kept < 0)) return std::isnan(kept) || candidate < 0;
    return std::abs(candidate) < std::abs(kept);
}

double decibels(double factor)
{
    return std::abs(20 * std::log10(factor));
}

double least(double kept, double other)
{
    return kept <= other ? kept : other;
}

}  // namespace

CommandMargins command_margins(bool stable, const std::vector<Crossing>& crossings,
                               const std::vector<Interval>& stable_factors,
                               const std::function<std::complex<double>(double)>& L, double from, double to)
{
    CommandMargins margins;
    for (const auto& c : crossings) {
        if (c.k_p < 1) margins.gain_below = std::max(margins.gain_below, c.k_p);
        if (c.k_p > 1) margins.gain_above = std::min(margins.gain_above, c.k_p);
        if (stable) margins.gain_db = least(margins.gain_db, decibels(c.k_p));
    }
    // a crossing next to an unstable loop may be one more pair of roots that leaves
    for (const auto& i : stable_factors)
        for (const double end : {i.low, i.high})
            if (end > 0 && std::isfinite(end)) margins.gain_db = -least(-margins.gain_db, decibels(end));
    const auto excess = [&](double omega) { return std::log(std::abs(L(omega))); };
    constexpr int points = 2500;
    double low = from, at_low = excess(low), passed = not_set;
    for (int i = 1; i <= points; ++i) {
        const double high = i == points ? to : from * std::pow(to / from, double(i) / points), at_high = excess(high);
        if (std::signbit(at_low) != std::signbit(at_high)) {
            const double omega = bracketed_root(excess, low, at_low, high, at_high, 1e-12).value;
            const double angle = std::arg(-L(omega));  // positive: so much lag turns L onto −1
            const double lag = angle > 0 ? angle : angle + 2 * std::numbers::pi;
            if (lag < margins.lag) margins.lag = lag, margins.crossover = omega;
            if (tells_more(angle, passed)) passed = angle;
        }
        low = high, at_low = at_high;
    }
    if (stable && std::isfinite(margins.lag)) margins.phase_deg = margins.lag * degrees;
    if (!stable) margins.phase_deg = passed * degrees;
    return margins;
}

}  // namespace stickslip
