// The roots of a delayed loop, and the rightmost of them.
#include <algorithm>
#include <cmath>

#include "analysis/loop/root_count.h"
#include "analysis/loop/root_search.h"
#include "analysis/numerics/eigenvalues.h"

namespace stickslip {
namespace {

using Complex = std::complex<double>;

/// Of a place that takes thousands of aliases, which is one of friction that grows many times over within a tick: a
/// search for the root takes seconds there and ends without one (a falling curve of 7 kN·s/m on 1 kg, ticks of 10 ms).
constexpr double hopeless = 300;

constexpr double most_growth = 18;  // of a term as a power of e, which leaves eight digits of what it is added to

/// Whether the mechanism, without what delays of its friction take off it, grows within a tick by so much that no digit
/// of their sum is left. Evidence: a falling curve of 5 kN·s/m with a lag of 2 ms, on 0.3 kg: at e^9 all roots are
/// those of the continuous loop to ten digits; at e^42 the rightmost ones were numbers that belong to nothing.
bool loses_all_digits(const DelayedLoop& loop, const OpenedLoop& open)
{
    if (!loop.ticked) return false;
    return std::any_of(open.poles().begin(), open.poles().end(),
                       [&](Complex p) { return p.real() * loop.period > most_growth; });
}

bool has_matrix(const DelayedLoop& loop)
{
    return loop.period == 0 && loop.friction.empty();
}

void sort_by_real_part(std::vector<Complex>& roots)
{
    std::sort(roots.begin(), roots.end(),
              [](Complex a, Complex b) { return a.real() != b.real() ? a.real() > b.real() : a.imag() > b.imag(); });
}

/// Whether no root lies further right than this one of the size |s|, by more than what the count resolves: beside slow
/// roots of fast loops rounding takes its digits.
bool is_rightmost(const DelayedLoop& loop, double gain, double real, double size)
{
    const OpenedLoop open(loop);
    for (const double share : {1e-7, 1e-5, 1e-3}) {
        const double nearest = share * (std::abs(real) + 1e-3 * size);
        if (const auto right = roots_right_of(open, gain, real + nearest, nearest)) return *right == 0;
    }
    return false;
}

/// A real part that is rounding beside `size` is 0.
double cleared(double real, double size)
{
    constexpr double rounding = 1e-14;
    return std::abs(real) < rounding * size ? 0 : real;
}

/// Whether a root right of that line is found near where roots about lie.
bool grows(const DelayedLoop& loop, const OpenedLoop& open, double gain, double right_of)
{
    const auto starts = rough_roots(loop, gain);
    return std::any_of(starts.begin(), starts.end(), [&](Complex start) {
        const auto root = start.real() > right_of ? polished_root(open, gain, start, 0) : std::nullopt;
        return root && root->real() > right_of && std::abs(root->imag()) <= open.end();
    });
}

DelayedSpectrum spectrum_by_lines(const DelayedLoop& loop, double gain)
{
    if (!loop.A.allFinite()) return {};
    const OpenedLoop open(loop);
    if (loses_all_digits(loop, open)) return {};
    RootSearch search(open, gain);
    auto edge = search.edge_from(rough_roots(loop, gain));
    if (!edge) edge = search.edge();  // the lines of look_around() may all lie left of it
    search.look_around();
    DelayedSpectrum found{search.all(), edge ? cleared(edge->real(), std::abs(*edge)) : not_set};
    sort_by_real_part(found.roots);
    // far to the left dead time multiplies friction's past by more than its digits bear: what is found there is no root
    std::erase_if(found.roots, [&](Complex s) { return -s.real() * loop.delay > most_growth; });
    return found;
}

DelayedSpectrum spectrum_by_matrix(const DelayedLoop& loop, double gain)
{
    constexpr int nodes = 32;
    // where dead time is short, its nodes lose the digits of slow roots, and without dead time these are near
    Eigen::VectorXcd starts = eigenvalues_of(loop.A + loop.input * (loop.held - gain * loop.output));
    std::vector<Complex> raw(starts.begin(), starts.end()), found;
    if (raw.empty()) return {};
    const OpenedLoop open(loop);
    double size = 0;
    for (const Complex& s : raw) size = std::max(size, std::abs(s));
    if (loop.delay == 0) {
        for (const Complex start : raw) {
            const auto s = polished_root(open, gain, start, 0);
            found.push_back(s && std::abs(*s - start) < 1e-6 * std::abs(start) ? *s : start);
        }
    } else {
        starts = eigenvalues_of(delayed_matrix(loop, gain, nodes));
        raw.insert(raw.end(), starts.begin(), starts.end());
        for (const Complex start : raw) {
            const auto s = polished_root(open, gain, start, 1e-15 * size);
            const auto same = [&](Complex other) {
                return std::abs(other - *s) < 1e-9 * (1e-6 + std::abs(*s)) + 1e-14 * size;
            };
            if (s && std::none_of(found.begin(), found.end(), same)) found.push_back(*s);
        }
        sort_by_real_part(found);
        // Chebyshev nodes over a long dead time miss the fast roots of a stiff mechanism
        if (found.empty() || !is_rightmost(loop, gain, found.front().real(), std::abs(found.front()))) {
            const auto edge = rightmost_root(loop, gain);
            if (!edge) return {found, not_set};
            found.push_back(*edge);
            if (edge->imag() > 0) found.push_back(std::conj(*edge));
        }
    }
    sort_by_real_part(found);
    for (const Complex& s : found) size = std::max(size, std::abs(s));
    const Complex first = found.front();
    return {found, cleared(first.real(), loop.delay > 0 ? std::abs(first) : size)};
}

}  // namespace

DelayedSpectrum delayed_spectrum(const DelayedLoop& loop, double gain)
{
    return has_matrix(loop) ? spectrum_by_matrix(loop, gain) : spectrum_by_lines(loop, gain);
}

std::vector<Complex> roots(const DelayedLoop& loop, double gain)
{
    return delayed_spectrum(loop, gain).roots;
}

std::optional<Complex> rightmost_root(const DelayedLoop& loop, double gain)
{
    if (!loop.A.allFinite()) return std::nullopt;
    const OpenedLoop open(loop);
    if (loses_all_digits(loop, open)) return std::nullopt;
    // counting confirms it, so that few starts are enough to begin with
    constexpr std::size_t few = 4;
    if (const auto edge = RootSearch(open, gain, few).edge_from(rough_roots(loop, gain))) return edge;
    constexpr double cheap = 50;  // places, of which nothing is to be looked at twice
    if (open.cost() > hopeless) return std::nullopt;
    if (open.cost() > cheap) return RootSearch(open, gain).edge();
    if (const auto edge = RootSearch(open, gain, few).edge_of_steepest()) return edge;
    return RootSearch(open, gain).edge();
}

double delayed_growth(const DelayedLoop& loop, double gain)
{
    if (has_matrix(loop)) return spectrum_by_matrix(loop, gain).growth;
    const auto edge = rightmost_root(loop, gain);
    return edge ? cleared(edge->real(), std::abs(*edge)) : not_set;
}

double delayed_side(const DelayedLoop& loop, double gain)
{
    if (!loop.A.allFinite()) return not_set;
    const OpenedLoop open(loop);
    // to either side of what rounding leaves of integrators and of roots on the axis
    constexpr double near = 1e-6;
    const double aside = near * open.turns_in();
    if (std::isfinite(aside)) {
        // a root that grows needs no count
        constexpr double costly = 10;  // of a place: a count takes as long as ten roots there
        if (open.cost() > costly && grows(loop, open, gain, aside)) return 1;
        if (open.cost() > hopeless) return not_set;
        if (roots_right_of(open, gain, -aside, aside) == 0) return -1;
        const auto right = roots_right_of(open, gain, aside, aside);
        if (right && *right > 0) return 1;
    }
    return delayed_growth(loop, gain);
}

}  // namespace stickslip
