// In one file: one loop behind dead time: its matrix, its roots and the crossings that prove them complete.
#include "analysis/loop/late_loop.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <numbers>
#include <numeric>
#include <optional>

#include "analysis/base/work_limits.h"
#include "analysis/loop/resolvent.h"
#include "analysis/numerics/balance.h"
#include "analysis/numerics/root.h"

namespace stickslip {
namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

/// The loop opened at its command, at many s.
class Opened {
  public:
    explicit Opened(const LateLoop& loop) : delay_(loop.delay), responses_(loop.A, loop.input, both(loop)) {}

    /// output (s − A)⁻¹ input and held (s − A)⁻¹ input, without dead time.
    std::pair<Complex, Complex> prompt(Complex s) const
    {
        std::array<Complex, 2> r;
        responses_.at(s, r.data());
        return {r[0], r[1]};
    }
    Complex late(Complex s) const { return std::exp(-s * delay_); }
    /// 1 + L(s) and its derivative, all gains closed.
    Response closing(double gain, Complex s) const
    {
        std::array<Response, 2> r;
        responses_.at(s, r.data());
        const Complex value = gain * r[0].value - r[1].value, slope = gain * r[0].slope - r[1].slope;
        return {1.0 + value * late(s), (slope - delay_ * value) * late(s)};
    }

  private:
    static Eigen::MatrixXd both(const LateLoop& loop)
    {
        Eigen::MatrixXd rows(2, loop.A.cols());
        rows << loop.output, loop.held;
        return rows;
    }
    double delay_;
    Resolvent responses_;
};

Eigen::VectorXcd eigenvalues_of(Eigen::MatrixXd matrix)
{
    if (!matrix.allFinite()) return {};
    balance(matrix);
    return matrix.eigenvalues();
}

/// The eigenvalues of A: integrators, states that no rate depends on, are at 0 to the last digit.
std::vector<Complex> poles_of(const Eigen::MatrixXd& A)
{
    std::vector<Eigen::Index> kept(static_cast<std::size_t>(A.rows()));
    std::iota(kept.begin(), kept.end(), 0);
    std::vector<Complex> poles;
    for (bool found = true; found;) {
        found = false;
        for (std::size_t i = 0; i < kept.size(); ++i) {
            const auto asks = [&](Eigen::Index k) { return A(k, kept[i]) != 0; };
            if (std::any_of(kept.begin(), kept.end(), asks)) continue;
            poles.push_back(0);
            kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(i));
            found = true;
            break;
        }
    }
    if (kept.empty()) return poles;
    const auto others = eigenvalues_of(A(kept, kept));
    poles.insert(poles.end(), others.begin(), others.end());
    return poles;
}

/// The line Re s = σ upwards from the real axis, around integrators by an arc, and the loop along it.
class Line {
  public:
    Line(const LateLoop& loop, const Opened& open, double gain, double sigma, double radius)
        : open_(open), gain_(gain), sigma_(sigma), radius_(radius), grown_(std::exp(-sigma * loop.delay))
    {
    }

    struct Look {
        Complex prompt, closed;  // L without dead time, 1 + L
    };
    double arc() const { return radius_ * pi / 2; }
    Look at(double way) const
    {
        const Complex s = way < arc() ? std::polar(radius_, way / radius_) : Complex(sigma_, radius_ + way - arc());
        const auto r = open_.prompt(s);
        const Complex L = gain_ * r.first - r.second;
        return Look{L, 1.0 + L * open_.late(s)};
    }
    double size(const Look& look) const { return std::abs(look.prompt) * grown_; }

  private:
    const Opened& open_;
    double gain_, sigma_, radius_, grown_;
};

/// By how much 1 + L turns from the start of the line to where L has died out; nothing where a root lies on the line or
/// in the arc around integrators, within which |L| has to be large.
std::optional<double> turning(const Line& line, double size, double delay, bool integrates, double nearest)
{
    constexpr double far = 1e-3, small = 0.5, most_turned = 0.3, most_bent = 0.1, large = 10;
    const auto is_small = [&](const Line::Look& look) { return line.size(look) < small; };
    const auto is_far = [&](double omega) { return line.size(line.at(omega)) < far; };
    const auto smooth = [&](Complex a, Complex b, Complex c) {
        const double first = std::arg(b / a), second = std::arg(c / b);
        return std::abs(first) < most_turned && std::abs(second) < most_turned && std::abs(first - second) < most_bent;
    };
    double end = 10 * size + 1;
    while (!is_far(end) || !is_far(1.7 * end))
        if ((end *= 2) > 1e12 * (1 + size)) return std::nullopt;
    const double widest = delay > 0 ? most_turned / delay : end;
    // whatever turns beside the start is as far from it as the nearest root
    double turned = 0, omega = 0, step = std::min(1e-5 * end, nearest);
    Line::Look here = line.at(0);
    if (integrates && !(std::abs(here.prompt) > large && std::abs(line.at(line.arc()).prompt) > large))
        return std::nullopt;
    constexpr int most = 400'000;
    for (int used = 0; omega < end; ++used) {
        if (used > most || !std::isfinite(std::abs(here.closed))) return std::nullopt;
        double next = std::min(end, omega + step);
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
        step = 1.6 * (next - omega);
        omega = next, here = there;
    }
    return turned - std::arg(here.closed);
}

/// How many roots lie right of Re s = σ: those of A and the turns of 1 + L. Nothing where a root lies on the line. The
/// imaginary axis is left by an arc around the integrators at s = 0, several of which rounding moves to either side; no
/// root of 1 + L lies within the arc where |L| is large on it.
std::optional<int> roots_right_of(const LateLoop& loop, const Opened& open, double gain, double sigma,
                                  double nearest = infinity)
{
    constexpr double integrators = 1e-5, around = 1e-4;
    int right = 0;
    double size = 0;
    const auto poles = poles_of(loop.A);
    for (const Complex& s : poles) size = std::max(size, std::abs(s));
    bool integrates = false;
    for (const Complex& s : poles) {
        const bool beside = sigma == 0 && std::abs(s) < integrators * size;
        integrates |= beside;
        right += !beside && s.real() > sigma;
    }
    const Line line(loop, open, gain, sigma, integrates ? around * size : 0);
    const auto turned = turning(line, size, loop.delay, integrates, nearest);
    if (!turned) return std::nullopt;
    return right - static_cast<int>(std::lround(*turned / pi));
}

}  // namespace

Eigen::MatrixXd late_matrix(const LateLoop& loop, double gain, int nodes)
{
    const auto n = loop.A.rows();
    const Eigen::RowVectorXd command = loop.held - gain * loop.output;
    if (loop.delay == 0) return loop.A + loop.input * command;
    // differentiation on x_j = cos(jπ/N), here from −delay to 0
    const auto x = [&](int j) { return std::cos(j * pi / nodes); };
    const auto c = [&](int j) { return (j == 0 || j == nodes ? 2.0 : 1.0) * (j % 2 ? -1 : 1); };
    Eigen::MatrixXd D = Eigen::MatrixXd::Zero(nodes + 1, nodes + 1);
    for (int i = 0; i <= nodes; ++i)
        for (int j = 0; j <= nodes; ++j)
            if (i != j) D(i, j) = c(i) / c(j) / (x(i) - x(j));
    for (int i = 0; i <= nodes; ++i) D(i, i) = -D.row(i).sum();
    D *= 2 / loop.delay;
    Eigen::MatrixXd M = Eigen::MatrixXd::Zero(n + nodes, n + nodes);
    M.topLeftCorner(n, n) = loop.A;
    M.col(n + nodes - 1).head(n) = loop.input;
    M.bottomRightCorner(nodes, nodes) = D.bottomRightCorner(nodes, nodes);
    M.bottomLeftCorner(nodes, n) = D.col(0).tail(nodes) * command;
    return M;
}

LateLoop late_loop(const LoopPlant& plant, double delay, double tau, const LoopGains& base, const LoopGains& turned)
{
    const int n = static_cast<int>(plant.A.rows());
    const bool filter = tau > 0 && (base.estimates() || turned.estimates());
    const bool integrates = base.integral != 0 || turned.integral != 0;
    const int size = n + filter + integrates;
    const auto wide = [&](const Eigen::RowVectorXd& row) {
        Eigen::RowVectorXd all = Eigen::RowVectorXd::Zero(size);
        all.head(n) = row;
        return all;
    };
    LateLoop loop;
    loop.delay = delay;
    loop.A = Eigen::MatrixXd::Zero(size, size);
    loop.A.topLeftCorner(n, n) = plant.A;
    loop.input = Eigen::VectorXd::Zero(size);
    loop.input.head(n) = plant.B;
    const Eigen::RowVectorXd reading = wide(plant.C);
    Eigen::RowVectorXd velocity = wide(plant.C_v), travelled = reading, sum = Eigen::RowVectorXd::Zero(size);
    if (filter) {
        travelled = Eigen::RowVectorXd::Unit(size, n);
        velocity = (reading - travelled) / tau;
        loop.A.row(n) = velocity;
    }
    if (integrates) {
        sum = Eigen::RowVectorXd::Unit(size, n + filter);
        loop.A.row(n + filter) = reading;
    }
    const auto feedback = [&](const LoopGains& g) {
        return Eigen::RowVectorXd(g.position * reading + g.velocity * velocity + g.integral * sum +
                                  g.travelled * travelled);
    };
    loop.held = -feedback(base);
    loop.output = feedback(turned);
    return loop;
}

namespace {

/// Newton's method from `s`; nothing where it does not settle. A step of `rounding` is none, nor is one that no longer
/// shrinks beside a root: of slow roots of fast loops rounding takes the last digits.
std::optional<Complex> polished(const Opened& open, double gain, Complex s, double rounding)
{
    double last = infinity;
    for (int i = 0; i < 16; ++i) {
        const auto F = open.closing(gain, s);
        const Complex step = F.value / F.slope;
        const double size = std::abs(step);
        if (!std::isfinite(size)) return std::nullopt;
        s -= step;
        if (size <= std::max(1e-14 * std::abs(s), rounding)) return s;
        if (size > 0.5 * last && size < 1e-6 * std::abs(s)) return s;
        last = size;
    }
    return std::nullopt;
}

}  // namespace

std::vector<Complex> roots(const LateLoop& loop, double gain)
{
    constexpr int nodes = 32;
    // where dead time is short, its nodes lose the digits of slow roots, and without dead time these are near
    Eigen::VectorXcd starts = eigenvalues_of(loop.A + loop.input * (loop.held - gain * loop.output));
    std::vector<Complex> raw(starts.begin(), starts.end()), found;
    if (raw.empty()) return found;
    const Opened open(loop);
    double size = 0;
    for (const Complex& s : raw) size = std::max(size, std::abs(s));
    if (loop.delay == 0) {
        for (const Complex start : raw) {
            const auto s = polished(open, gain, start, 0);
            found.push_back(s && std::abs(*s - start) < 1e-6 * std::abs(start) ? *s : start);
        }
    } else {
        starts = eigenvalues_of(late_matrix(loop, gain, nodes));
        raw.insert(raw.end(), starts.begin(), starts.end());
        for (const Complex start : raw) {
            const auto s = polished(open, gain, start, 1e-15 * size);
            const auto same = [&](Complex other) {
                return std::abs(other - *s) < 1e-9 * (1e-6 + std::abs(*s)) + 1e-14 * size;
            };
            if (s && std::none_of(found.begin(), found.end(), same)) found.push_back(*s);
        }
    }
    std::sort(found.begin(), found.end(),
              [](Complex a, Complex b) { return a.real() != b.real() ? a.real() > b.real() : a.imag() > b.imag(); });
    return found;
}

namespace {

/// Whether no root lies further right than this one of the size |s|, by more than what the count resolves: beside slow
/// roots of fast loops rounding takes its digits.
bool is_rightmost(const LateLoop& loop, double gain, double real, double size)
{
    const Opened open(loop);
    for (const double share : {1e-7, 1e-5, 1e-3}) {
        const double nearest = share * (std::abs(real) + 1e-3 * size);
        if (const auto right = roots_right_of(loop, open, gain, real + nearest, nearest)) return *right == 0;
    }
    return false;
}

}  // namespace

double late_growth(const LateLoop& loop, double gain)
{
    const auto all = roots(loop, gain);
    if (all.empty()) return not_set;
    double size = 0;
    for (const auto& s : all) size = std::max(size, std::abs(s));
    double most = all.front().real();
    if (loop.delay > 0 && !is_rightmost(loop, gain, most, std::abs(all.front()))) return not_set;
    constexpr double rounding = 1e-14;
    return std::abs(most) < rounding * (loop.delay > 0 ? std::abs(all.front()) : size) ? 0 : most;
}

namespace {

/// −T of the turned gain, the base closed: a positive real number where a positive gain puts a root at s.
Complex towards(const Opened& open, Complex s)
{
    const Complex late = open.late(s);
    const auto [out, held] = open.prompt(s);
    return -out * late / (1.0 - held * late);
}

Complex towards_axis(const Opened& open, double omega)
{
    return towards(open, Complex(0, omega));
}

/// The gain that puts a real root at 0, where −T is flat and not nothing from there to `beside`: an integrator, which
/// rounding may leave beside 0, is not.
std::optional<Crossing> crossing_at_rest(const Opened& open, double beside)
{
    constexpr double flat = 0.1;
    const double still = towards(open, 0).real();
    if (!(still > 0 && std::abs(towards_axis(open, beside) - still) < flat * still)) return std::nullopt;
    const double left = towards(open, -beside).real(), right = towards(open, beside).real();
    return Crossing{1 / still, 0, right < left ? 1 : -1};
}

struct Reach {
    double from, to;
    double rounding;  ///< below it a pole may be an integrator
};
Reach features(const LateLoop& loop)
{
    double low = infinity, high = 0;
    const Eigen::MatrixXd closed = loop.A + loop.input * loop.held;
    for (const auto& matrix : {loop.A, closed})
        for (const Complex& s : eigenvalues_of(matrix)) {
            high = std::max(high, std::abs(s));
            if (std::abs(s) > 0) low = std::min(low, std::abs(s));
        }
    for (const Complex& s : eigenvalues_of(closed))
        if (std::abs(s) < 1e-9 * high) low = std::min(low, 1e-6 * high);
    if (loop.delay > 0) low = std::min(low, 1 / loop.delay);
    constexpr double turns = 50 * pi, far = 1e4, above = 30, integrator = 1e-9;
    return {1e-4 * low, loop.delay > 0 ? std::max(turns / loop.delay, above * high) : far * high, integrator * high};
}

}  // namespace

AxisCrossings axis_crossings(const LateLoop& loop)
{
    AxisCrossings found;
    if (!loop.A.allFinite()) return found;
    const Reach reach = features(loop);
    const Opened open(loop);
    const auto phase = [&](double omega) { return std::arg(towards_axis(open, omega)); };
    const double widest = loop.delay > 0 ? 0.3 / loop.delay : reach.to;
    if (const auto still = crossing_at_rest(open, std::max(reach.from, reach.rounding)))
        found.crossings.push_back(*still);
    double omega = reach.from, at = phase(omega), step = 0.1 * omega;
    const auto turn = [](double from, double to) { return std::remainder(to - from, 2 * pi); };
    for (long steps = 0; omega < reach.to; ++steps) {
        if (steps == work::crossing_steps) {
            found.doubtful.push_back({omega, reach.to});
            break;
        }
        const double next = std::min(reach.to, omega + std::min(step, widest));
        const double middle = phase(0.5 * (omega + next)), there = phase(next);
        const double first = turn(at, middle), second = turn(middle, there);
        const bool coarse = std::abs(first) > 0.3 || std::abs(second) > 0.3 || std::abs(first - second) > 0.1;
        if (coarse && next - omega > 1e-12 * next) {
            step = (next - omega) / 2;
            continue;
        }
        if (coarse) found.doubtful.push_back({omega, next});
        if (!coarse && std::signbit(at) != std::signbit(there) && std::abs(at) < 1) {
            const double root = bracketed_root(phase, omega, at, next, there, 1e-15).value;
            const double gain = 1 / towards_axis(open, root).real();
            if (gain > 0) found.crossings.push_back({gain, root, there < at ? 1 : -1});
        }
        omega = next, at = there;
        step *= 1.6;
    }
    // further up each turn of the dead time asks for more gain still; a search that was cut short excludes no gain
    if (omega < reach.to)
        found.searched_to = 0;
    else if (loop.delay > 0)
        found.searched_to = 0.5 / std::abs(towards_axis(open, reach.to));
    std::erase_if(found.crossings, [&](const Crossing& c) { return c.k_p > found.searched_to; });
    std::sort(found.crossings.begin(), found.crossings.end(),
              [](const Crossing& a, const Crossing& b) { return a.k_p < b.k_p; });
    return found;
}

namespace {

/// Growth somewhere between two neighbouring crossings, at the own gain where that lies there, so that no window
/// contradicts the verdict. Where it cannot be confirmed at one gain, another has the same sign.
double growth_between(const LateLoop& loop, double low, double high, double own)
{
    if (own > low && own < high) {
        const double growth = late_growth(loop, own);
        if (std::isfinite(growth)) return growth;
    }
    const double from = low > 0 ? low : high < infinity ? 1e-6 * high : 1, to = high < infinity ? high : 1e6 * from;
    for (const double share : {0.5, 0.25, 0.75, 0.1, 0.9}) {
        const double growth = late_growth(loop, from * std::pow(to / from, share));
        if (std::isfinite(growth)) return growth;
    }
    return not_set;
}

}  // namespace

std::vector<Interval> stable_gains(const LateLoop& loop, AxisCrossings& all, double own)
{
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

CommandMargins command_margins(const LateLoop& loop)
{
    double size = 0;
    for (const auto& s : roots(loop, 1)) size = std::max(size, std::abs(s));
    constexpr double below = 1e-7, above = 1e2;
    const Opened open(loop);
    const auto L = [&](double omega) {
        const Complex s(0, omega);
        return open.prompt(s).first * open.late(s);
    };
    return command_margins(late_growth(loop, 1) < 0, axis_crossings(loop).crossings, L, below * size, above * size);
}

}  // namespace stickslip
