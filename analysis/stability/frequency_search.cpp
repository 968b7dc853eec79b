#include "analysis/stability/frequency_search.h"

#include <algorithm>
#include <atomic>
#include <span>

#include "analysis/numerics/interval.h"
#include "analysis/numerics/root.h"
#include "analysis/stability/characteristic.h"

namespace stickslip {
namespace {

using DualBox = Dual<Box>;
constexpr double narrowest = 1e-9;            // relative width of a band that is given up
constexpr int usual_bands = 30'000;           // of one search
constexpr std::size_t most_doubtful = 1'000;  // beyond, rounding decides everything and a search finds nothing
std::atomic<double> effort = 1;

int most_bands()
{
    return static_cast<int>(std::min(1e9, usual_bands * effort));
}

/// G(σ + iω) and its derivative by ω for every ω of a band.
DualBox transfer_over(const LinearFriction& f, double sigma, const Band& omega)
{
    Box G, slope;
    const Box i(0.0, 1.0);
    for (int k = 0; k < f.states; ++k) {
        if (f.weight(k) == 0) continue;
        const Band gap = Band(sigma) - Band(f.lambda[k]);
        const Band denominator = inverse(square(gap) + square(omega));
        const Box pole(gap * denominator, -omega * denominator);  // 1/(s − λ)
        G = G + Box(f.weight(k)) * pole;
        slope = slope - i * Box(f.weight(k)) * pole * pole;
    }
    for (const auto& d : f.delays) {
        const Band angle = omega * Band(d.time);
        const Box delayed = Box(d.weight * std::exp(-sigma * d.time)) * Box(cosine(angle), -sine(angle));
        G = G + delayed;
        slope = slope - i * Box(d.time) * delayed;
    }
    if (f.table) {
        const auto around = [&](Complex middle, double reach) {
            const Band r(-reach, reach);
            return Box(f.table_scale) * Box(Band(middle.real()) + r, Band(middle.imag()) + r);
        };
        const Complex s(sigma, omega.middle());
        const double half = omega.width() / 2, rounding = 1e-13 * f.table->moment(0, sigma);
        G = G + around(f.table->transform(s), f.table->moment(1, sigma) * half + rounding);
        slope = slope + i * around(f.table->transform_slope(s),
                                   f.table->moment(2, sigma) * half + rounding * f.table->duration());
    }
    return {G, slope};
}

Characteristic<DualBox> characteristic_over(const LinearJoint& j, double sigma, const Band& omega)
{
    std::array<DualBox, max_bodies> resistance, scale;
    for (int i = 0; i < j.bodies; ++i) {
        resistance[i] = DualBox(j.friction[i].f_v) - transfer_over(j.friction[i], sigma, omega);
        scale[i] = DualBox(1.0);
    }
    return characteristic(j, DualBox(Box(Band(sigma), omega), Box(0.0, 1.0)), resistance, scale);
}

/// The mean value form: f(middle) + f'(band)(band − middle), cut with the plain enclosure.
Box mean_value(const Box& at_middle, const DualBox& over, const Band& omega)
{
    const Band offset = omega - Band(omega.middle());
    return intersection(over.value, at_middle + over.slope * Box(offset));
}

struct MisphaseOver {
    Band value, slope;
};
MisphaseOver misphase_over(const LinearJoint& j, const Band& omega)
{
    const auto phase = [&](const Band& band) {
        const DualBox at(Box(0.0, band), Box(0.0, 1.0));
        const auto parts = split_by(Gain::k_p, characteristic_over(j, 0, band), j.k_p, j.k_v, at);
        return parts.a * DualBox(conj(parts.b.value), conj(parts.b.slope));
    };
    const DualBox over = phase(omega), middle = phase(Band(omega.middle()));
    return {mean_value(middle.value, over, omega).im, over.slope.im};
}

/// max |f_v − G| for Re s ≥ σ and |s| ≥ 2 |λ|
double resistance_bound(const LinearFriction& f, double sigma)
{
    double sum = std::abs(f.f_v);
    for (int i = 0; i < f.states; ++i)
        if (f.weight(i) != 0) sum += std::abs(f.weight(i)) / std::max(sigma - f.lambda[i], std::abs(f.lambda[i]));
    for (const auto& d : f.delays) sum += std::abs(d.weight) * std::exp(-sigma * d.time);
    if (f.table) sum += std::abs(f.table_scale) * f.table->moment(0, sigma);
    return sum;
}

double longest_delay(const LinearJoint& j)
{
    double longest = 0;
    for (const LinearFriction& f : std::span(j.friction).first(j.bodies))
        for (const auto& d : f.delays) longest = std::max(longest, d.time);
    return longest;
}

}  // namespace

void set_search_effort(double times_usual)
{
    effort = times_usual;
}

double search_effort()
{
    return effort;
}

double frequency_bound(const LinearJoint& j, double gain_limit, double sigma, double share)
{
    double bound = 0;
    for (int i = 0; i < j.bodies; ++i) {
        double damping = resistance_bound(j.friction[i], sigma) + std::abs(j.k_v * j.actuated[i]);
        double stiffness = gain_limit * std::abs(j.actuated[i]);
        for (int k = 0; k < j.bodies; ++k) {
            damping += std::abs(j.damping_at(i, k));
            stiffness += std::abs(j.stiffness_at(i, k));
        }
        // share · m ω² = damping ω + stiffness
        const double m = share * j.inertia[i];
        bound = std::max(bound, (damping + std::sqrt(damping * damping + 4 * m * stiffness)) / (2 * m));
        for (int k = 0; k < j.friction[i].states; ++k) bound = std::max(bound, 2 * std::abs(j.friction[i].lambda[k]));
    }
    return 1.001 * bound;
}

CrossingSearch search_crossings(const LinearJoint& j, double gain_limit)
{
    CrossingSearch found;
    found.searched_to = gain_limit;
    const double end = frequency_bound(j, gain_limit);
    const int most = most_bands();
    // rad of the longest delay: not even low gains get searched
    if (longest_delay(j) * end > 1e3 * most) {
        found.exhausted = true;
        found.searched_to = 0;
        return found;
    }
    std::vector<Band> open;
    // from the top down, so that a search that runs out of bands has cleared the low frequencies
    const int pieces = 64;
    for (int i = pieces; i-- > 0;) open.push_back({end * i / pieces, end * (i + 1) / pieces});
    const auto take = [&](double omega) {
        const double k_p = gain_at(j, Gain::k_p, omega);
        if (k_p > 0 && k_p <= gain_limit)
            found.crossings.push_back({k_p, omega, crossing_direction(j, Gain::k_p, k_p, omega)});
    };
    for (int used = 0; !open.empty(); ++used) {
        const Band band = open.back();
        open.pop_back();
        if (used > most || found.doubtful.size() > most_doubtful) {
            found.exhausted = true;
            found.searched_to = std::min(gain_limit, 0.5 * j.inertia[0] * band.low * band.low);
            break;
        }
        const auto phase = misphase_over(j, band);
        if (!phase.value.contains_zero()) continue;
        if (!phase.slope.contains_zero()) {
            if (band.low == 0) continue;  // its only zero is that of ω = 0
            const double low = misphase(j, Gain::k_p, band.low), high = misphase(j, Gain::k_p, band.high);
            if (std::signbit(low) != std::signbit(high))
                take(bracketed_root([&](double w) { return misphase(j, Gain::k_p, w); }, band.low, low, band.high, high,
                                    1e-15)
                         .value);
            continue;
        }
        if (band.width() <= narrowest * band.high) {
            found.doubtful.push_back({band.low, band.high});
            continue;
        }
        open.push_back({band.middle(), band.high});
        open.push_back({band.low, band.middle()});
    }
    std::sort(found.crossings.begin(), found.crossings.end(),
              [](const Crossing& a, const Crossing& b) { return a.k_p < b.k_p; });
    return found;
}

}  // namespace stickslip
