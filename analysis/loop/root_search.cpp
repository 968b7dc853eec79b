// In one file: one search, by every way that finds the rightmost root, cheapest first.
#include "analysis/loop/root_search.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "analysis/loop/root_count.h"

namespace stickslip {
namespace {

using Complex = std::complex<double>;

constexpr double cheap = 50;  ///< of a place; where it costs more, none is looked at twice

bool further_left(Complex a, Complex b)
{
    return a.real() < b.real();
}

/// d log/ds of 1 + L(s) times Π(s − p), p the poles of L that are known: next to a pole Newton's method would go away
/// from it, or end on it where its step is less than rounding.
Complex drift(const OpenedLoop& open, double gain, Complex s)
{
    const auto F = open.closing(gain, s);
    Complex slope = F.slope / F.value;
    for (const Complex& p : open.exact_poles())
        if (std::isfinite(p.real())) slope += 1.0 / (s - p);
    return slope;
}

}  // namespace

std::optional<Complex> polished_root(const OpenedLoop& open, double gain, Complex s, double rounding)
{
    double last = infinity;
    for (int i = 0; i < 16; ++i) {
        const Complex step = 1.0 / drift(open, gain, s);
        const double size = std::abs(step);
        if (!std::isfinite(size)) return std::nullopt;
        s -= step;
        if (size <= std::max(1e-14 * std::abs(s), rounding)) return s;
        if (size > 0.5 * last && size < 1e-6 * std::abs(s)) return s;
        last = size;
    }
    return std::nullopt;
}

RootSearch::RootSearch(const OpenedLoop& open, double gain, std::size_t most)
    : open_(open), gain_(gain), unit_(open.turns_in()), most_(most)
{
    constexpr double integrator = 1e-9;  // of the fastest pole
    double fastest = 0;
    for (const Complex& p : open.poles()) fastest = std::max(fastest, std::abs(p));
    for (const Complex& p : open.poles())
        if (std::abs(p) > integrator * fastest) unit_ = std::min(unit_, std::abs(p));
}

std::optional<int> RootSearch::look(double sigma, double nearest)
{
    std::vector<LookedAt> looked;
    const auto count = roots_right_of(open_, gain_, sigma, nearest, &looked);
    std::vector<LookedAt> peaks;
    for (std::size_t i = 0; i < looked.size(); ++i) {
        const bool above = i == 0 || looked[i].steepness >= looked[i - 1].steepness;
        if (above && (i + 1 == looked.size() || looked[i].steepness >= looked[i + 1].steepness))
            peaks.push_back(looked[i]);
    }
    std::sort(peaks.begin(), peaks.end(), [](const auto& a, const auto& b) { return a.steepness > b.steepness; });
    for (std::size_t i = 0; i < std::min(most_, peaks.size()); ++i) take({sigma, peaks[i].omega});
    return count;
}

void RootSearch::look_around()
{
    for (const double share : {1e-3, -0.3, -1.0, -2.0}) look(share * unit_);
}

std::optional<Complex> RootSearch::edge_of_steepest()
{
    const double axis = 1e-3 * unit_;
    const auto right = look(axis);
    // roots far left are none of those that are counted right of the axis
    if (right && *right > 0 && !knows_right_of(axis) && !climb(axis)) return std::nullopt;
    return roots_.empty() ? std::nullopt : edge_by_newton();
}

std::optional<Complex> RootSearch::edge_from(const std::vector<Complex>& starts)
{
    // next to roots Newton's method takes few steps and needs none of the care of near_root()
    constexpr std::size_t rightmost = 2;
    const auto most = open_.cost() > cheap ? std::min(rightmost, starts.size()) : starts.size();
    for (std::size_t i = 0; i < most; ++i)
        if (const auto s = polished_root(open_, gain_, starts[i], 0)) add(*s);
    return roots_.empty() ? std::nullopt : edge_by_newton();
}

bool RootSearch::knows_right_of(double sigma) const
{
    return std::any_of(roots_.begin(), roots_.end(), [&](Complex s) { return s.real() > sigma; });
}

bool RootSearch::are_all_known(Complex rightmost) const
{
    const auto known = all();
    for (const double share : {1e-2, 3e-2, 0.1, 0.3}) {
        const double width = share * std::abs(rightmost), sigma = rightmost.real() - width;
        const auto right = roots_right_of(open_, gain_, sigma, 1e-3 * width);
        if (!right) continue;
        return *right == std::count_if(known.begin(), known.end(), [&](Complex s) { return s.real() > sigma; });
    }
    return false;
}

/// From the imaginary axis Newton's method may miss what lies far right of it.
bool RootSearch::climb(double sigma)
{
    // once, and where a place costs little: what it does not find is halved for
    constexpr int most = 6;
    if (std::exchange(climbed_, true) || open_.cost() > cheap) return false;
    double wide = 0.3 * unit_;
    for (int i = 0; i < most; ++i, wide *= 2) {
        const auto right = look(sigma + wide);
        if (knows_right_of(sigma)) return true;
        if (!right || *right == 0) return false;
    }
    return false;
}

std::optional<Complex> RootSearch::edge()
{
    if (const auto found = edge_of_steepest()) return found;
    auto found = edge_at_pole();
    if (!found) found = edge_by_newton();
    if (!found) found = edge_by_counting();
    if (found && !is_known(*found)) roots_.push_back(*found);
    return found;
}

std::vector<Complex> RootSearch::all() const
{
    std::vector<Complex> both;
    for (const Complex& s : roots_) {
        both.push_back(s);
        if (s.imag() != 0 && s.imag() < open_.end() * (1 - 1e-9)) both.push_back(std::conj(s));
    }
    return both;
}

std::optional<Complex> RootSearch::edge_by_newton()
{
    for (double left = 0.3; roots_.empty() && left < 1e3; left *= 3) look(-left * unit_);
    constexpr int most = 20;
    for (int i = 0; i < most && !roots_.empty(); ++i) {
        const Complex s = *std::max_element(roots_.begin(), roots_.end(), further_left);
        std::optional<int> right;
        double nearest = 0;
        for (const double share : {1e-7, 1e-5, 1e-3}) {
            nearest = share * (std::abs(s.real()) + 1e-3 * std::abs(s));
            if ((right = look(s.real() + nearest, nearest))) break;
        }
        if (!right) return are_all_known(s) ? std::optional(s) : std::nullopt;
        if (*right == 0) return s;
        const Complex now = *std::max_element(roots_.begin(), roots_.end(), further_left);
        if (now.real() > s.real() + nearest || climb(s.real() + nearest)) continue;
        return std::nullopt;  // none of those that were counted is found
    }
    return std::nullopt;
}

std::optional<Complex> RootSearch::edge_at_pole() const
{
    constexpr double beside = 1e-9;
    auto poles = open_.exact_poles();
    std::sort(poles.begin(), poles.end(), [](Complex a, Complex b) { return further_left(b, a); });
    for (const Complex& p : poles) {
        const double width = beside * std::abs(p);
        if (!(width > 0) || !std::isfinite(width)) continue;
        const auto right = roots_right_of(open_, gain_, p.real() + width, width),
                   with = roots_right_of(open_, gain_, p.real() - width, width);
        if (right && with && *right == 0 && *with > 0) return Complex(p.real(), std::abs(p.imag()));
    }
    return std::nullopt;
}

std::optional<Complex> RootSearch::edge_by_counting() const
{
    constexpr int most_steps = 60;
    constexpr double exact = 1e-10, near = 1e-5;
    std::vector<LookedAt> looked;
    const auto count = [&](double sigma) {
        looked.clear();
        return roots_right_of(open_, gain_, sigma, near * unit_, &looked);
    };
    double low = 1e-3 * unit_;
    for (double left = 0.3; left < 1e3; left *= 3) {
        const auto right = count(low);
        if (right && *right > 0) break;
        low = -left * unit_;
    }
    double high = low, wide = unit_;
    for (int i = 0; i < most_steps; ++i, wide *= 2) {
        const auto right = count(low + wide);
        if (!right) continue;
        high = low + wide;
        if (*right == 0) break;
        low = high;
    }
    for (int i = 0; i < most_steps && high - low > exact * (std::abs(low) + std::abs(high)); ++i) {
        // beside the middle where a root lies on it
        std::optional<int> right;
        double sigma = low;
        for (const double share : {0.5, 0.45, 0.6}) {
            sigma = low + share * (high - low);
            if ((right = count(sigma))) break;
        }
        if (!right) break;  // so near to the root the count of no line is certain
        (*right > 0 ? low : high) = sigma;
    }
    const bool narrow = high > low && high - low <= near * (std::abs(low) + std::abs(high));
    // a line that no root was counted right of brackets none; the line of `high` is looked at last
    if (!narrow || count(low).value_or(0) == 0 || count(high) != 0) return std::nullopt;
    const auto steepest = std::max_element(
        looked.begin(), looked.end(), [](const LookedAt& a, const LookedAt& b) { return a.steepness < b.steepness; });
    const Complex edge((low + high) / 2, steepest->omega);
    const auto root = polished_root(open_, gain_, edge, 0);
    return root && std::abs(*root - edge) < near * std::abs(edge) ? root : edge;
}

std::optional<Complex> RootSearch::near_root(Complex s) const
{
    constexpr int most = 50;
    constexpr double close = 1e-6;
    for (int i = 0; i < most; ++i) {
        Complex slope = drift(open_, gain_, s);
        for (const Complex& r : roots_) {
            slope -= 1.0 / (s - r);
            if (r.imag() != 0) slope -= 1.0 / (s - std::conj(r));
        }
        const Complex step = 1.0 / slope;
        if (!std::isfinite(std::abs(step))) return std::nullopt;
        s -= step;
        if (std::abs(step) < close * std::abs(s)) return s;
    }
    return std::nullopt;
}

void RootSearch::take(Complex start)
{
    const auto near = near_root(start);
    if (!near) return;
    const auto found = polished_root(open_, gain_, *near, 0);
    if (!found || std::abs(*found - *near) > 1e-3 * std::abs(*near)) return;
    add(*found);
}

void RootSearch::add(Complex root)
{
    Complex s(root.real(), std::abs(root.imag()));
    if (s.imag() < 1e-9 * std::abs(s)) s.imag(0);
    if (s.imag() > open_.end() * (1 + 1e-9)) return;
    if (!is_known(s)) roots_.push_back(s);
}

bool RootSearch::is_known(Complex s) const
{
    const auto same = [&](Complex other) { return std::abs(other - s) < 1e-8 * (std::abs(s) + 1e-6 * unit_); };
    return std::any_of(roots_.begin(), roots_.end(), same);
}

}  // namespace stickslip
