#include "analysis/loop/root_count.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stickslip {
namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

/// The line Re s = σ upwards from the real axis, around integrators by an arc, and the loop along it.
class Line {
  public:
    Line(const OpenedLoop& open, double gain, double sigma, double radius)
        : open_(open), gain_(gain), sigma_(sigma), radius_(radius), grown_(std::abs(open.delayed(sigma)))
    {
    }

    struct Look {
        Complex prompt, closed;  // L without dead time, 1 + L
    };
    double arc() const { return radius_ * pi / 2; }
    Complex place(double way) const
    {
        return way < arc() ? std::polar(radius_, way / radius_) : Complex(sigma_, radius_ + way - arc());
    }
    Look at(double way) const
    {
        const Complex s = place(way);
        const auto r = open_.prompt(s);
        const Complex L = gain_ * r.first - r.second;
        return Look{L, 1.0 + L * open_.delayed(s)};
    }
    double size(const Look& look) const { return std::abs(look.prompt) * grown_; }
    /// How far from there a step sees all that happens.
    double room(double way) const { return open_.room(place(way)); }

  private:
    const OpenedLoop& open_;
    double gain_, sigma_, radius_, grown_;
};

/// Where L has died out; of a sampled loop the top of the half circle. Nothing where it does not die out.
std::optional<double> end_of(const OpenedLoop& open, const Line& line, double size)
{
    if (std::isfinite(open.end())) return open.end();
    constexpr double far = 1e-3;
    const auto is_far = [&](double omega) { return line.size(line.at(omega)) < far; };
    double end = 10 * size + 1;
    while (!is_far(end) || !is_far(1.7 * end))
        if ((end *= 2) > 1e12 * (1 + size)) return std::nullopt;
    return end;
}

/// By how much 1 + L turns from the start of the line to its end; nothing where a root lies on the line or in the arc
/// around integrators, within which |L| has to be large.
std::optional<double> turning(const OpenedLoop& open, const Line& line, const OpenedLoop::Right& right, double nearest,
                              std::vector<LookedAt>* looked)
{
    constexpr double small = 0.5, most_turned = 0.3, most_bent = 0.1, large = 10;
    const auto is_small = [&](const Line::Look& look) { return line.size(look) < small; };
    const auto smooth = [&](Complex a, Complex b, Complex c) {
        const double first = std::arg(b / a), second = std::arg(c / b);
        return std::abs(first) < most_turned && std::abs(second) < most_turned && std::abs(first - second) < most_bent;
    };
    const auto found_end = end_of(open, line, right.size);
    if (!found_end) return std::nullopt;
    const double end = *found_end, widest = std::min(most_turned * open.turns_in(), end);
    // whatever turns beside the start is as far from it as the nearest root
    double turned = 0, omega = 0, step = std::min(1e-5 * end, nearest);
    Line::Look here = line.at(0);
    if (right.at_zero && !(std::abs(here.prompt) > large && std::abs(line.at(line.arc()).prompt) > large))
        return std::nullopt;
    constexpr int most = 400'000;
    for (int used = 0; omega < end; ++used) {
        if (used * open.cost() > most || !std::isfinite(std::abs(here.closed))) return std::nullopt;
        double next = std::min(end, omega + std::min(step, std::max(line.room(omega), nearest)));
        Line::Look middle = line.at(0.5 * (omega + next)), there = line.at(next);
        // |L| < 1 keeps 1 + L right of the axis however fast dead time turns L
        const bool quiet =
            is_small(here) && is_small(middle) && is_small(there) && smooth(here.prompt, middle.prompt, there.prompt);
        if (!quiet && next - omega > widest) {
            next = omega + widest;
            middle = line.at(0.5 * (omega + next)), there = line.at(next);
        }
        if (quiet) {
            turned += std::arg(there.closed) - std::arg(here.closed);
        } else if (smooth(here.closed, middle.closed, there.closed)) {
            turned += std::arg(middle.closed / here.closed) + std::arg(there.closed / middle.closed);
        } else {
            step = (next - omega) / 2;
            if (step < std::min(1e-13 * end, 1e-3 * nearest)) return std::nullopt;
            continue;
        }
        if (looked) looked->push_back({omega, std::abs(there.closed / here.closed - 1.0) / (next - omega)});
        step = 1.6 * (next - omega);
        omega = next, here = there;
    }
    // at half the sampling rate the loop is real, beyond everything else it has died out
    return std::isfinite(open.end()) ? turned : turned - std::arg(here.closed);
}

}  // namespace

std::optional<int> roots_right_of(const OpenedLoop& open, double gain, double sigma, double nearest,
                                  std::vector<LookedAt>* looked)
{
    constexpr double around = 1e-4;
    const auto right = open.right_of(sigma);
    if (!right) return std::nullopt;
    const Line line(open, gain, sigma, right->at_zero ? around * right->size : 0);
    const auto turned = turning(open, line, *right, nearest, looked);
    if (!turned) return std::nullopt;
    return right->poles - static_cast<int>(std::lround(*turned / pi));
}

}  // namespace stickslip
