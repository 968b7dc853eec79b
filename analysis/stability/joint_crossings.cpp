// In one file: one question: the gains at which roots cross the axis, and the intervals between them.
#include "analysis/stability/joint_crossings.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <numbers>

#include "analysis/numerics/balance.h"
#include "analysis/numerics/root.h"
#include "analysis/stability/joint_spectrum.h"
#include "analysis/stability/misphase.h"
#include "analysis/stability/neutral.h"
#include "analysis/stability/winding.h"

namespace stickslip {
namespace {

/// By how many the roots right of the axis change at a crossing: a pair, and one alone through 0.
int roots_over(const Crossing& crossing)
{
    return crossing.omega == 0 ? crossing.direction : 2 * crossing.direction;
}

/// The gain that only just holds what pushes the link away from the surface, or lifts its load off: below it a root on
/// the real axis is right of 0.
void add_holding_gain(const LinearJoint& j, double searched_to, std::vector<Crossing>& crossings)
{
    if (std::none_of(j.contact.begin(), j.contact.begin() + j.bodies, [](double w) { return w < 0; })) return;
    const double k_p = gain_at(j, Gain::k_p, 0);
    if (!(k_p > 0 && k_p <= searched_to) || !std::isfinite(k_p)) return;
    const auto behind = std::ranges::upper_bound(crossings, k_p, {}, &Crossing::k_p);
    crossings.insert(behind, {k_p, 0, crossing_direction(j, Gain::k_p, k_p, 0)});
}

/// p(−s)
Polynomial mirrored(Polynomial p)
{
    for (int k = 1; k < p.size; k += 2) p.c[k] = -p.c[k];
    return p;
}

/// Im(a(iω) conj b(iω))/ω as a polynomial in u = ω².
Polynomial misphase_polynomial(const LinearJoint& j, Gain gain)
{
    const auto rational = rational_characteristic(j);
    const auto parts =
        split_by(gain, Characteristic<Polynomial>{rational.a, rational.b}, j.k_p, j.k_v, Polynomial(0, 1));
    const Polynomial product = parts.a * mirrored(parts.b);
    Polynomial q;
    q.size = std::max(1, product.size / 2);
    q.c[0] = 0;
    for (int k = 1; k < product.size; k += 2) q.c[k / 2] = (k / 2) % 2 == 0 ? product.c[k] : -product.c[k];
    return trimmed(q);
}

/// Positive real parts of the roots: each sign change of q at u > 0 lies at one of them or between two.
std::vector<double> separators(Polynomial q)
{
    int zeros = 0;  // roots at u = 0
    while (zeros < q.size && q.c[zeros] == 0) ++zeros;
    const int n = q.degree() - zeros;
    if (n < 1) return {};
    const double* c = q.c.data() + zeros;
    const double unit = std::pow(std::abs(c[0] / c[n]), 1.0 / n);
    if (!(unit > 0) || !std::isfinite(unit)) return {};
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, Polynomial::capacity / 2, Polynomial::capacity / 2>
        companion(n, n);
    companion.setZero();
    if (n > 1) companion.diagonal(-1).setOnes();
    for (int k = 0; k < n; ++k) companion(k, n - 1) = -c[k] / c[n] * std::pow(unit, k - n);
    if (!companion.allFinite()) return {};
    balance(companion);
    std::vector<double> positive;
    const auto roots = companion.eigenvalues();
    for (const auto& root : roots)
        if (root.real() > 0) positive.push_back(root.real() * unit);
    std::sort(positive.begin(), positive.end());
    return positive;
}

/// A k_p that covers what matters of a joint with infinitely many crossings; infinity where crossings are known to end.
struct GainLimit {
    double search, complete_to;
};
GainLimit gain_limit(const LinearJoint& j)
{
    double longest = 0, inertia = 0;
    for (int i = 0; i < j.bodies; ++i) {
        inertia += j.inertia[i];
        for (const auto& d : j.friction[i].delays) longest = std::max(longest, d.time);
        if (j.friction[i].table) longest = std::max(longest, j.friction[i].table->duration());
    }
    const double turns = 16 * std::numbers::pi / longest;
    const double usual = std::max(4 * std::abs(j.k_p), inertia * turns * turns);
    // a single body: |Re G(iω)| ≤ Σ|w| of the delays + (Σ|w| of the states + variation of the table)/ω, so (34) has no
    // solution beyond a last ω where C outweighs the delays
    const auto& f = j.friction[0];
    const double C = j.k_v * j.actuated[0] + f.f_v;
    double delayed = 0, variation = f.table ? std::abs(f.table_scale) * f.table->variation() : 0;
    for (const auto& d : f.delays) delayed += std::abs(d.weight);
    for (int k = 0; k < f.states; ++k) variation += std::abs(f.weight(k));
    if (j.bodies > 1 || !(C > delayed * (1 + 1e-9))) return {usual, usual};
    const double last = variation / (C - delayed);
    const double enough = 2 * (j.inertia[0] * last * last + variation + delayed * last) / j.actuated[0];
    constexpr double most_costly = 100;  // a C that hardly outweighs the delays asks for a search without sensible end
    if (!(enough < most_costly * usual)) return {usual, usual};
    return {std::max(enough, 4 * std::abs(j.k_p)), infinity};
}

/// The roots right of the axis at each probe, one probe in each interval between crossings. A delay can bring thousands
/// of crossings, each of which takes a pair of roots over the axis: where the pairs between two counted probes make up
/// their difference, those between need no count of their own; elsewhere the probe in the middle is counted, too.
class CountedProbes {
  public:
    CountedProbes(const std::vector<LinearJoint>& probes, const std::vector<Crossing>& crossings)
        : probes_(probes), crossings_(crossings), unstable_(probes.size(), false)
    {
        constexpr std::size_t few = 8;
        if (probes.size() <= few || probes.front().rational()) return;
        between(0, count(0), probes.size() - 1, count(probes.size() - 1));
    }
    /// Has roots right of the axis for certain.
    bool unstable(std::size_t probe) const { return unstable_[probe]; }

  private:
    std::optional<int> count(std::size_t probe)
    {
        const auto roots = roots_right_of(probes_[probe], 0);
        unstable_[probe] = roots && *roots > 0;
        return roots;
    }
    void between(std::size_t low, std::optional<int> at_low, std::size_t high, std::optional<int> at_high)
    {
        if (high - low < 2 || (at_low && at_high && stepped(low, *at_low, high, *at_high))) return;
        const std::size_t middle = (low + high) / 2;
        const auto at_middle = count(middle);
        between(low, at_low, middle, at_middle);
        between(middle, at_middle, high, at_high);
    }
    bool stepped(std::size_t low, int at_low, std::size_t high, int at_high)
    {
        std::vector<int> roots{at_low};
        for (std::size_t i = low; i < high; ++i) roots.push_back(roots.back() + roots_over(crossings_[i]));
        if (roots.back() != at_high || *std::min_element(roots.begin(), roots.end()) < 0) return false;
        for (std::size_t i = low; i <= high; ++i) unstable_[i] = roots[i - low] > 0;
        return true;
    }

    const std::vector<LinearJoint>& probes_;
    const std::vector<Crossing>& crossings_;
    std::vector<bool> unstable_;
};

}  // namespace

namespace {

/// How many roots lie right of the axis, where rounding does not decide it.
std::optional<int> roots_right(const LinearJoint& j)
{
    if (!j.rational()) return roots_right_of(j, 0);
    int right = 0;
    for (const Complex& s : spectrum(j)) {
        if (s.real() == 0 || !std::isfinite(s.real())) return std::nullopt;
        right += s.real() > 0;
    }
    return right;
}

/// The stable gains from the number of roots right of the axis at the joint's own gain, and a pair more or less at each
/// crossing: nothing is evaluated where rounding would decide. Nothing where the own gain says nothing, or the numbers
/// contradict a count at the far end.
std::optional<std::vector<Interval>> stable_by_count(const LinearJoint& j, const std::vector<Crossing>& crossings,
                                                     double searched_to, Gain gain)
{
    const double own = gain == Gain::k_p ? j.k_p : j.k_v;
    if (!(own > 0 && own <= searched_to)) return std::nullopt;
    const auto here = roots_right(j);
    if (!here) return std::nullopt;
    std::vector<double> bounds{0};
    std::vector<int> right{*here};
    for (const auto& c : crossings) {
        bounds.push_back(c.k_p);
        right.push_back(right.back() + roots_over(c));
        if (c.k_p < own)
            for (int& n : right) n -= roots_over(c);
    }
    bounds.push_back(std::max(searched_to, bounds.back()));
    if (*std::min_element(right.begin(), right.end()) < 0) return std::nullopt;
    LinearJoint last = j;
    const double end = std::isfinite(searched_to) ? std::sqrt(bounds[bounds.size() - 2] * searched_to)
                                                  : 2 * std::max(own, bounds[bounds.size() - 2]);
    if (end > 0) {
        (gain == Gain::k_p ? last.k_p : last.k_v) = end;
        if (const auto there = roots_right(last); there && *there != right.back()) return std::nullopt;
    }
    std::vector<Interval> stable;
    for (std::size_t i = 0; i < right.size(); ++i) {
        if (right[i] != 0 || !(bounds[i] < bounds[i + 1])) continue;
        if (!stable.empty() && stable.back().high == bounds[i])
            stable.back().high = bounds[i + 1];
        else
            stable.push_back({bounds[i], bounds[i + 1]});
    }
    return stable;
}

}  // namespace

std::vector<Crossing> rational_crossings(const LinearJoint& j, Gain gain)
{
    std::vector<Crossing> found;
    if (gain == Gain::k_p) add_holding_gain(j, infinity, found);
    const auto at = separators(misphase_polynomial(j, gain));
    if (at.empty()) return found;
    std::vector<double> points{std::sqrt(at.front()) / 2};
    for (std::size_t i = 0; i < at.size(); ++i) {
        points.push_back(std::sqrt(at[i]));
        points.push_back(i + 1 < at.size() ? std::pow(at[i] * at[i + 1], 0.25) : 2 * std::sqrt(at[i]));
    }
    const auto phase = [&](double omega) { return certain_misphase(j, gain, omega); };
    double low = points[0], at_low = phase(low);
    for (std::size_t i = 1; i < points.size(); ++i) {
        const double high = points[i], at_high = phase(high);
        if (std::signbit(at_low) != std::signbit(at_high) && high > low) {
            const double omega = bracketed_root(phase, low, at_low, high, at_high, 1e-15).value;
            const double value = gain_at(j, gain, omega);
            // d(misphase)/dω = Re(F' conj b), and the root moves by −b/F' per gain
            if (value > 0) found.push_back({value, omega, at_high > at_low ? -1 : 1});
        }
        low = high, at_low = at_high;
    }
    std::sort(found.begin(), found.end(), [](const Crossing& a, const Crossing& b) { return a.k_p < b.k_p; });
    return found;
}

CrossingSearch crossings(const LinearJoint& j)
{
    if (j.rational()) {
        CrossingSearch all;
        all.crossings = rational_crossings(j, Gain::k_p);
        return all;
    }
    const auto limit = gain_limit(j);
    auto found = search_crossings(j, limit.search);
    add_holding_gain(j, found.searched_to, found.crossings);
    if (found.searched_to == limit.search) found.searched_to = limit.complete_to;
    return found;
}

std::vector<Interval> stable_intervals(const LinearJoint& j, const std::vector<Crossing>& crossings, double searched_to,
                                       Gain gain)
{
    if (const auto counted = stable_by_count(j, crossings, searched_to, gain)) return *counted;
    std::vector<double> bounds{0};
    for (const auto& c : crossings) bounds.push_back(c.k_p);
    if (searched_to > bounds.back()) bounds.push_back(searched_to);
    std::vector<LinearJoint> probes;
    for (std::size_t i = 0; i + 1 < bounds.size(); ++i) {
        const double low = bounds[i], high = bounds[i + 1];
        // next to a crossing at next to nothing rounding decides: hence the own gain where it lies further off
        const double own = gain == Gain::k_p ? j.k_p : j.k_v;
        probes.push_back(j);
        (gain == Gain::k_p ? probes[i].k_p : probes[i].k_v) = low == 0 && high == infinity
                                                                  ? std::max(std::abs(own), 1.0)
                                                              : high == infinity ? std::max(2 * low, own)
                                                              : low == 0         ? high / 2
                                                                                 : std::sqrt(low * high);
    }
    const CountedProbes counted(probes, crossings);
    std::vector<Interval> intervals;
    for (std::size_t i = 0; i < probes.size(); ++i) {
        if (counted.unstable(i) || !is_stable(probes[i])) continue;
        if (!intervals.empty() && intervals.back().high == bounds[i])
            intervals.back().high = bounds[i + 1];
        else
            intervals.push_back({bounds[i], bounds[i + 1]});
    }
    return intervals;
}

std::vector<Interval> velocity_only_gains(const LinearJoint& joint)
{
    const auto curve = velocity_only(joint);
    if (curve.bodies == 1) {
        const double share = curve.actuated[0];
        const LinearMass mass{curve.inertia[0], 0, share * curve.k_p + curve.contact[0], curve.friction[0]};
        if (!(mass.k_p > 0)) return {};
        return {{std::max(0.0, -velocity_only_damping(mass, 0) / share), infinity}};
    }
    return stable_intervals(curve, rational_crossings(curve, Gain::k_v), infinity, Gain::k_v);
}

}  // namespace stickslip
