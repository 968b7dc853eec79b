#include "analysis/stability/winding.h"

#include <algorithm>
#include <numbers>
#include <span>

#include "analysis/stability/characteristic.h"
#include "analysis/stability/frequency_search.h"

namespace stickslip {
namespace {

using Matrix = std::array<std::array<Complex, max_bodies>, max_bodies>;

/// The joint without what is delayed: delays and tables.
LinearJoint prompt(LinearJoint j)
{
    for (int i = 0; i < j.bodies; ++i) {
        j.friction[i].delays = {};
        j.friction[i].table = {};
    }
    return j;
}

/// |g(0)| + ∫|g'| e^{−σt} + |g(end)| e^{−σT} or more: by parts, |G(s)| ≤ this / |s| on Re s = σ.
double variation(const KernelTable& table, double sigma)
{
    const auto weight = [&](double t) { return std::exp(-sigma * t); };
    const auto& g = table.value;
    double sum = std::abs(g.front()) + std::abs(g.back()) * weight(table.duration());
    for (std::size_t k = 0; k + 1 < g.size(); ++k)
        sum += std::abs(g[k + 1] - g[k]) * std::max(weight(table.time[k]), weight(table.time[k + 1]));
    return sum;
}

double longest_memory(const LinearJoint& j)
{
    double longest = 0;
    for (const LinearFriction& f : std::span(j.friction).first(j.bodies)) {
        for (const auto& d : f.delays) longest = std::max(longest, d.time);
        if (f.table) longest = std::max(longest, f.table->duration());
    }
    return longest;
}

/// Z(s) with the loop in it.
Matrix closed_matrix(const LinearJoint& j, Complex s)
{
    std::array<Complex, max_bodies> resistance, scale;
    for (int i = 0; i < j.bodies; ++i) {
        resistance[i] = j.friction[i].f_v - transfer(j.friction[i], s);
        scale[i] = 1;
    }
    auto Z = open_loop_matrix(j, s, resistance, scale);
    for (int i = 0; i < j.bodies; ++i) Z[i][j.measured] += j.actuated[i] * (j.k_p + j.k_v * s);
    return Z;
}

/// The principal minor of the bodies of `set` (a bit each); 1 for none.
Complex principal_minor(const Matrix& Z, unsigned set)
{
    std::array<int, max_bodies> at{};
    int n = 0;
    for (int i = 0; i < max_bodies; ++i)
        if (set >> i & 1) at[n++] = i;
    const auto z = [&](int i, int k) { return Z[at[i]][at[k]]; };
    if (n == 0) return 1;
    if (n == 1) return z(0, 0);
    if (n == 2) return z(0, 0) * z(1, 1) - z(0, 1) * z(1, 0);
    return z(0, 0) * (z(1, 1) * z(2, 2) - z(1, 2) * z(2, 1)) - z(0, 1) * (z(1, 0) * z(2, 2) - z(1, 2) * z(2, 0)) +
           z(0, 2) * (z(1, 0) * z(2, 1) - z(1, 1) * z(2, 0));
}

/// The line Re s = σ, seen at one frequency.
struct Look {
    double omega = 0;
    Complex value, drift;                ///< F, and d log(F Π(s − λ))/ds
    Complex prompt_value, prompt_drift;  ///< the same without what is delayed
    double delayed_share = 0;            ///< |F − F without what is delayed| / |the latter| at most
};

class Line {
  public:
    Line(const LinearJoint& joint, double sigma)
        : joint_(joint), prompt_(prompt(joint)), sigma_(sigma), has_delays_(!joint.rational())
    {
        for (int i = 0; i < joint.bodies; ++i) {
            const auto& f = joint.friction[i];
            for (int k = 0; k < f.states; ++k)
                if (f.weight(k) != 0) poles_.push_back(f.lambda[k]);
            for (const auto& d : f.delays) delayed_[i] += std::abs(d.weight) * std::exp(-sigma * d.time);
            if (!f.table) continue;
            table_[i] = std::abs(f.table_scale) * f.table->moment(0, sigma);
            variation_[i] = std::abs(f.table_scale) * variation(*f.table, sigma);
        }
    }

    std::span<const double> poles() const { return poles_; }

    Look at(double omega) const
    {
        const Complex s(sigma_, omega);
        Look look;
        look.omega = omega;
        const auto whole = closed_loop(joint_, s);
        Complex from_poles = 0;
        for (const double lambda : poles_) from_poles += 1.0 / (s - lambda);
        look.value = whole.value;
        look.drift = whole.slope / whole.value + from_poles;
        if (!has_delays_) {
            look.prompt_value = look.value, look.prompt_drift = look.drift;
            return look;
        }
        const auto part = closed_loop(prompt_, s);
        look.prompt_value = part.value;
        look.prompt_drift = part.slope / part.value + from_poles;
        look.delayed_share = delayed_share(s);
        return look;
    }

    /// Change of arg(F Π(s − λ)) from a to b where it is foretold, else nothing. `h_delayed`: how long a step may be
    /// that has to follow what is delayed.
    std::optional<double> turn(const Look& a, const Look& b, double h_delayed) const
    {
        const double h = b.omega - a.omega;
        double poles = 0;
        for (const double lambda : poles_)
            poles += std::arg(Complex(sigma_ - lambda, b.omega) / Complex(sigma_ - lambda, a.omega));
        const auto foretold = [&](Complex before, Complex after, Complex drift_before, Complex drift_after) {
            constexpr double longest = 0.8, most_off = 0.15;
            const double told = h * (drift_before.real() + drift_after.real()) / 2;
            const double seen = std::arg(after / before) + poles;
            const double off = std::remainder(seen - told, 2 * std::numbers::pi);
            const bool good =
                h * std::max(std::abs(drift_before), std::abs(drift_after)) < longest && std::abs(off) < most_off;
            return good ? std::optional(told + off) : std::nullopt;
        };
        constexpr double quiet = 0.2;
        if (has_delays_ && std::max(a.delayed_share, b.delayed_share) < quiet) {
            const auto told = foretold(a.prompt_value, b.prompt_value, a.prompt_drift, b.prompt_drift);
            if (!told) return told;
            return *told + std::arg(b.value / b.prompt_value) - std::arg(a.value / a.prompt_value);
        }
        if (has_delays_ && h > h_delayed) return std::nullopt;
        return foretold(a.value, b.value, a.drift, b.drift);
    }

  private:
    /// A determinant is linear in each resistance: Σ over sets of bodies of Π(|G_delayed| |s|) · |minor of the others|.
    double delayed_share(Complex s) const
    {
        const auto Z = closed_matrix(prompt_, s);
        const unsigned all = (1u << joint_.bodies) - 1;
        const double size = std::abs(s);
        double sum = 0;
        for (unsigned set = 1; set <= all; ++set) {
            double product = 1;
            for (int i = 0; i < joint_.bodies; ++i)
                if (set >> i & 1) product *= delayed_[i] * size + std::min(table_[i] * size, variation_[i]);
            if (product > 0) sum += product * std::abs(principal_minor(Z, all & ~set));
        }
        return sum / std::abs(principal_minor(Z, all));
    }

    const LinearJoint& joint_;
    LinearJoint prompt_;
    double sigma_;
    bool has_delays_;
    std::vector<double> poles_;
    std::array<double, max_bodies> delayed_{}, table_{}, variation_{};
};

bool is_number(Complex z)
{
    return std::isfinite(z.real()) && std::isfinite(z.imag());
}

}  // namespace

std::optional<LineCount> count_right_of(const LinearJoint& j, double sigma, int most)
{
    const Line line(j, sigma);
    const double share = 1.0 / (4 * j.bodies);
    const double end = frequency_bound(j, std::abs(j.k_p), std::min(sigma, 0.0), share) + 2 * std::abs(sigma);
    if (!std::isfinite(end) || !(end > 0)) return std::nullopt;
    const double h_delayed = 1.0 / longest_memory(j);  // infinite where nothing is delayed
    LineCount count;
    count.sigma = sigma;
    double turned = 0;
    Look here = line.at(0);
    if (!is_number(here.value) || here.value == 0.0) return std::nullopt;
    count.nodes.push_back({0, std::abs(here.drift)});
    double h = std::min(0.4 / std::abs(here.drift), end);
    if (!(h > 0)) h = end;
    while (here.omega < end) {
        if (most-- <= 0) return std::nullopt;
        // far above a slow root as at 0, between it and its conjugate, the slope of the phase may not show it
        const double most_step = here.omega > 0 ? here.omega : end;
        const double next = std::min(here.omega + std::min(h, most_step), end);
        if (!(next > here.omega)) return std::nullopt;
        const Look there = line.at(next);
        if (!is_number(there.value)) return std::nullopt;
        auto turn = line.turn(here, there, h_delayed);
        if (turn && here.omega == 0) {
            const Look between = line.at(next / 2);
            const auto first = line.turn(here, between, h_delayed), second = line.turn(between, there, h_delayed);
            turn = first && second ? std::optional(*first + *second) : std::nullopt;
        }
        if (!turn) {
            h = (next - here.omega) / 2;
            if (h < 1e-14 * end && h < 1e-13 * std::abs(Complex(sigma, next))) return std::nullopt;
            continue;
        }
        turned += *turn;
        here = there;
        count.nodes.push_back({next, std::abs(here.drift)});
        h *= 1.6;
    }
    // on the closing arc F Π(s − λ) is Π m s^(2n + poles) up to a factor near one
    const Complex top(sigma, end);
    Complex rest = here.value;
    for (int i = 0; i < j.bodies; ++i) rest /= j.inertia[i] * top * top;
    double arc = 2 * j.bodies * std::arg(top) + std::arg(rest);
    for (const double lambda : line.poles()) arc += std::arg(top - lambda);
    const double roots = (arc - turned) / std::numbers::pi;
    if (!(std::abs(roots - std::round(roots)) < 0.1)) return std::nullopt;
    count.roots = static_cast<int>(std::lround(roots));
    return count;
}

std::optional<int> roots_right_of(const LinearJoint& j, double sigma)
{
    const auto count = count_right_of(j, sigma);
    return count ? std::optional(count->roots) : std::nullopt;
}

}  // namespace stickslip
