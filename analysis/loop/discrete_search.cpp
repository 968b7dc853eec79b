// In one file: one proof: the crossings of the unit circle, band by band.
#include "analysis/loop/discrete_search.h"

#include <Eigen/Dense>
#include <algorithm>
#include <numbers>

#include "analysis/loop/resolvent.h"
#include "analysis/numerics/balance.h"
#include "analysis/numerics/eigenvalues.h"
#include "analysis/numerics/interval.h"
#include "analysis/numerics/root.h"

namespace stickslip {
namespace {

using Complex = std::complex<double>;
using std::numbers::pi;
constexpr double narrowest = 1e-11;  // of an angle: bands that are given up
constexpr int most_bands = 200'000;

/// The same loop in units in which its entries are of one size.
DiscreteLoop balanced(DiscreteLoop loop)
{
    Eigen::VectorXd units = Eigen::VectorXd::Ones(loop.input.size());
    balance(loop.difference, &units);
    loop.input = loop.input.cwiseQuotient(units);
    loop.output = loop.output.cwiseProduct(units.transpose());
    return loop;
}

/// z − 1 at z = e^{iφ}, without what 1 takes from it.
Complex beside_one(double angle)
{
    return Complex(0, 2 * std::sin(angle / 2)) * std::polar(1.0, angle / 2);
}

/// T along the unit circle, and how much its phase can turn.
class Circle {
  public:
    explicit Circle(const DiscreteLoop& loop)
        : loop_(balanced(loop)), responses_(loop_.difference, loop_.input, loop_.output)
    {
        const Eigen::VectorXcd poles = eigenvalues_of(loop_.difference);
        poles_.assign(poles.begin(), poles.end());
        const auto n = loop_.input.size();
        Eigen::MatrixXd a = Eigen::MatrixXd::Zero(n + 1, n + 1), b = a;
        a.topLeftCorner(n, n) = loop_.difference;
        a.topRightCorner(n, 1) = loop_.input;
        a.bottomLeftCorner(1, n) = loop_.output;
        b.topLeftCorner(n, n).setIdentity();
        take_zeros(a, b);
        join_zeros_at_one();
        start_ = pi;
        for (const auto* roots : {&poles_, &zeros_})
            for (const Complex& r : *roots)
                if (std::abs(r) > 1e-10) start_ = std::min(start_, 1e-4 * std::abs(r));
    }

    const DiscreteLoop& loop() const { return loop_; }
    /// Whether poles and zeros are known.
    bool sound() const { return sound_; }
    double start() const { return start_; }
    Complex at(double angle) const
    {
        Complex value;
        responses_.at(beside_one(angle), &value);
        return value;
    }
    /// The same by elimination with pivots, which costs more and keeps its digits where the states of many readings
    /// have next to nothing to do with each other.
    Complex exactly_at(double angle) const
    {
        Eigen::MatrixXcd Z = -loop_.difference.cast<Complex>();
        Z.diagonal().array() += beside_one(angle);
        return (loop_.output.cast<Complex>() * Z.partialPivLu().solve(loop_.input.cast<Complex>()))(0);
    }
    /// arg(−T): zero where a positive gain puts a multiplier there.
    double phase(double angle) const { return std::arg(-at(angle)); }

    /// How far the phase may travel within a band at most.
    double travel(const Band& band) const
    {
        const double half = band.width() / 2;
        double sum = std::abs(static_cast<double>(zeros_.size()) - static_cast<double>(poles_.size())) * half;
        for (const auto* roots : {&poles_, &zeros_})
            for (const Complex& r : *roots) sum += std::abs(turn(r, band) - half);
        return 1.001 * sum + 1e-9;
    }
    /// Bounds of its slope.
    Band slope(const Band& band) const
    {
        Band sum(0.5 * (static_cast<double>(zeros_.size()) - static_cast<double>(poles_.size())));
        for (const Complex& r : zeros_) sum = sum + kernel(r, band);
        for (const Complex& r : poles_) sum = sum - kernel(r, band);
        return sum;
    }

  private:
    /// Where a − z b is singular: by QZ, which does not always settle, else by the eigenvalues of (a − σ b)⁻¹ b.
    void take_zeros(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b)
    {
        constexpr double far = 1e9;
        const Eigen::GeneralizedEigenSolver<Eigen::MatrixXd> solver(a, b, false);
        sound_ = solver.info() == Eigen::Success;
        if (sound_) {
            for (Eigen::Index i = 0; i < a.rows(); ++i)
                if (std::abs(solver.alphas()[i]) < far * std::abs(solver.betas()[i]))
                    zeros_.push_back(solver.alphas()[i] / solver.betas()[i]);
            return;
        }
        constexpr double aside = 0.37;  // from z = 1, far inside: a zero just there has no reason
        const Eigen::VectorXcd inverse = eigenvalues_of((a + aside * b).partialPivLu().solve(b));
        sound_ = inverse.size() > 0 && inverse.allFinite();
        for (Eigen::Index i = 0; sound_ && i < inverse.size(); ++i)
            if (std::abs(inverse[i]) * far > 1) zeros_.push_back(1.0 / inverse[i] - aside);
    }
    /// Under an integral the velocity gain has two zeros at z = 1, which rounding parts to ±√ε: the search would look
    /// for what lies between them, and find no end.
    void join_zeros_at_one()
    {
        constexpr double near = 1e-6, alike = 1e-3;
        Complex sum = 0;
        double sizes = 0;
        for (const Complex& r : zeros_)
            if (std::abs(r) < near) sum += r, sizes += std::abs(r);
        if (!(std::abs(sum) < alike * sizes)) return;
        for (Complex& r : zeros_)
            if (std::abs(r) < near) r = 0;
    }
    /// By how much arg(z − r) grows over a band of at most half the circle, r counted from 1: from nothing to 3π/2
    /// where r lies inside, from −π to half the band outside, so that a turn is missing only far beyond rounding.
    static double turn(const Complex& root, const Band& band)
    {
        constexpr double rounding = 1e-3;
        const Complex r = root + 1.0;
        double change = std::arg((beside_one(band.high) - root) / (beside_one(band.low) - root));
        if (std::abs(r) < 1 && change < -rounding) change += 2 * pi;
        if (std::abs(r) > 1 && change > band.width() / 2 + rounding) change -= 2 * pi;
        return change;
    }
    /// (1 − |r|²)/(2 |z − r|²): its slope but for the half that all roots share.
    static Band kernel(const Complex& root, const Band& band)
    {
        const double off = -2 * root.real() - std::norm(root);  // 1 − |r|²
        const double distance = std::abs(beside_one(band.middle()) - root), half = band.width() / 2;
        const double nearest = std::pow(std::max(0.0, distance - half), 2), farthest = std::pow(distance + half, 2);
        const double a = off / (2 * std::max(nearest, 1e-300)), b = off / (2 * farthest);
        return {std::min(a, b), std::max(a, b)};
    }

    DiscreteLoop loop_;
    Resolvent responses_;
    std::vector<Complex> poles_, zeros_;  ///< counted from z = 1
    double start_;
    bool sound_ = false;
};

/// One more band, joined to the last where it goes on from there.
void doubt(Interval band, std::vector<Interval>& doubtful)
{
    if (!doubtful.empty() && doubtful.back().high >= band.low)
        doubtful.back().high = band.high;
    else
        doubtful.push_back(band);
}

/// Steps of a secant on the exact phase, from the zero of the fast one.
double polished(const Circle& circle, double angle)
{
    constexpr double beside = 1e-7, nothing = 1e-15;
    const auto phase = [&](double at) { return std::arg(-circle.exactly_at(at)); };
    double before = angle * (1 - beside), at = angle, f_before = phase(before), f = phase(at);
    for (int i = 0; i < 5 && std::abs(f) > nothing && f != f_before; ++i) {
        const double next = at - f * (at - before) / (f - f_before);
        if (!(std::abs(next - angle) < 1e-3 * angle)) return angle;
        before = at, f_before = f;
        at = next, f = phase(at);
    }
    return at;
}

void take(const Circle& circle, double angle, int direction, CircleCrossings& found)
{
    const bool real = angle == pi || angle == 0;
    if (!real) angle = polished(circle, angle);
    const double exact = real ? -1 / circle.exactly_at(angle).real() : (-1.0 / circle.exactly_at(angle)).real();
    if (exact > 0 && std::isfinite(exact)) found.crossings.push_back({exact, angle / circle.loop().period, direction});
}

}  // namespace

std::vector<Complex> multipliers(const DiscreteLoop& loop, double gain)
{
    const Eigen::VectorXcd values = eigenvalues_of(loop.closed(gain));
    std::vector<Complex> z;
    for (const Complex& v : values) z.push_back(1.0 + v);
    std::sort(z.begin(), z.end(), [](const Complex& a, const Complex& b) {
        return std::abs(a) != std::abs(b) ? std::abs(a) > std::abs(b) : a.imag() > b.imag();
    });
    return z;
}

double sampled_growth(const DiscreteLoop& loop, double gain)
{
    const auto closed = loop.closed(gain);
    // a finite mechanism whose map over one tick overflows grows by more than any number a tick
    if (!closed.allFinite()) return infinity;
    const Eigen::VectorXcd values = eigenvalues_of(closed);
    if (values.size() == 0) return not_set;
    if (!values.allFinite()) return infinity;
    double most = -infinity;
    // ln|1 + v|² = log1p(2 Re v + |v|²)
    for (const Complex& v : values) most = std::max(most, 0.5 * std::log1p(2 * v.real() + std::norm(v)));
    constexpr double rounding = 4e-15;
    if (std::abs(most) < rounding * static_cast<double>(values.size())) return 0;
    return most / loop.period;
}

CircleCrossings circle_crossings(const DiscreteLoop& loop)
{
    CircleCrossings found;
    const Circle circle(loop);
    found.searched = circle.sound();
    if (!found.searched) {
        found.doubtful.push_back({0, pi / loop.period});
        return found;
    }
    // a real multiplier at 1, unless T is nothing or has no end there
    const double still = circle.at(0).real(), beside = std::abs(circle.at(circle.start()));
    constexpr double alike = 1e-6;
    if (still < 0 && std::abs(still) > alike * beside && std::abs(still) < beside / alike)
        take(circle, 0, circle.slope(Band(0)).high < 0 ? 1 : -1, found);
    std::vector<Band> open;
    const int pieces = 32;
    double high = pi;
    for (int i = 1; i <= pieces; ++i) {
        const double low = i == pieces ? circle.start() : high * std::pow(circle.start() / pi, 1.0 / pieces);
        open.push_back({low, high});
        high = low;
    }
    for (int used = 0; !open.empty(); ++used) {
        const Band band = open.back();
        open.pop_back();
        if (used > most_bands) {
            found.doubtful.push_back({band.low / loop.period, pi / loop.period});
            break;
        }
        const double low = circle.phase(band.low), end = circle.phase(band.high);
        const double travel = circle.travel(band);
        const bool last = band.high == pi;
        if (std::abs(low) + std::abs(end) > travel) continue;
        const Band slope = circle.slope(band);
        if (!slope.contains_zero() && travel < pi) {
            const int direction = slope.high < 0 ? 1 : -1;
            if (last && circle.at(pi).real() < 0) {
                take(circle, pi, direction, found);
            } else if (std::signbit(low) != std::signbit(end)) {
                const auto phase = [&](double angle) { return circle.phase(angle); };
                take(circle, bracketed_root(phase, band.low, low, band.high, end, 1e-15).value, direction, found);
            }
            continue;
        }
        if (band.width() <= narrowest * band.high) {
            doubt({band.low / loop.period, band.high / loop.period}, found.doubtful);
            continue;
        }
        open.push_back({band.middle(), band.high});
        open.push_back({band.low, band.middle()});
    }
    std::sort(found.crossings.begin(), found.crossings.end(),
              [](const Crossing& a, const Crossing& b) { return a.k_p < b.k_p; });
    return found;
}

std::vector<Interval> stable_gains(const DiscreteLoop& loop, const std::vector<Crossing>& crossings, double own)
{
    std::vector<double> bounds{0};
    for (const auto& c : crossings) bounds.push_back(c.k_p);
    bounds.push_back(infinity);
    std::vector<Interval> intervals;
    for (std::size_t i = 0; i + 1 < bounds.size(); ++i) {
        const double low = bounds[i], high = bounds[i + 1];
        // at the own gain, so that no window contradicts the verdict
        const double probe = own > low && own < high ? own
                             : high == infinity      ? (low == 0 ? 1 : 2 * low)
                             : low == 0              ? high / 2
                                                     : std::sqrt(low * high);
        if (!(sampled_growth(loop, probe) < 0)) continue;
        if (!intervals.empty() && intervals.back().high == low)
            intervals.back().high = high;
        else
            intervals.push_back({low, high});
    }
    return intervals;
}

CommandMargins command_margins(const DiscreteLoop& loop)
{
    const Circle circle(loop);
    const bool stable = sampled_growth(loop, 1) < 0;
    const auto crossings = circle_crossings(loop).crossings;
    return command_margins(
        stable, crossings, stable ? std::vector<Interval>{} : stable_gains(loop, crossings, 1),
        [&](double omega) { return circle.at(omega * loop.period); }, circle.start() / loop.period, pi / loop.period);
}

}  // namespace stickslip
