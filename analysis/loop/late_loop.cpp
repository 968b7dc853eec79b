// In one file: one loop behind dead time: its matrix, its rightmost roots and the count that confirms them.
#include "analysis/loop/late_loop.h"

#include <Eigen/Dense>
#include <algorithm>
#include <numbers>

#include "analysis/loop/late_count.h"
#include "analysis/numerics/balance.h"

namespace stickslip {
namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

Eigen::VectorXcd eigenvalues_of(Eigen::MatrixXd matrix)
{
    if (!matrix.allFinite()) return {};
    balance(matrix);
    return matrix.eigenvalues();
}

/// The same row over more states.
Eigen::RowVectorXd widened(const Eigen::RowVectorXd& row, Eigen::Index size)
{
    Eigen::RowVectorXd all = Eigen::RowVectorXd::Zero(size);
    all.head(row.size()) = row;
    return all;
}

/// In s: of the actuator's lag and of the integral.
std::vector<double> poles_around(double lag, bool integrates)
{
    std::vector<double> poles;
    if (lag > 0) poles.push_back(-1 / lag);
    if (integrates) poles.push_back(0);
    return poles;
}

}  // namespace

Eigen::MatrixXd late_matrix(const LateLoop& loop, double gain, int nodes)
{
    const auto n = loop.A.rows();
    /// Something that acts a while after it arose.
    struct Line {
        Eigen::VectorXd input;
        Eigen::RowVectorXd row;
        double delay;
    };
    Eigen::MatrixXd A = loop.A;
    std::vector<Line> lines{{loop.input, loop.held - gain * loop.output, loop.delay}};
    for (const auto& f : loop.friction)
        for (const auto& d : f.delays) lines.push_back({d.weight * f.push, f.speed, d.time});
    std::erase_if(lines, [&](const Line& line) {
        if (line.delay > 0) return false;
        A += line.input * line.row;
        return true;
    });
    // differentiation on x_j = cos(jπ/N)
    const auto x = [&](int j) { return std::cos(j * pi / nodes); };
    const auto c = [&](int j) { return (j == 0 || j == nodes ? 2.0 : 1.0) * (j % 2 ? -1 : 1); };
    Eigen::MatrixXd D = Eigen::MatrixXd::Zero(nodes + 1, nodes + 1);
    for (int i = 0; i <= nodes; ++i)
        for (int j = 0; j <= nodes; ++j)
            if (i != j) D(i, j) = c(i) / c(j) / (x(i) - x(j));
    for (int i = 0; i <= nodes; ++i) D(i, i) = -D.row(i).sum();
    const auto size = n + nodes * static_cast<Eigen::Index>(lines.size());
    Eigen::MatrixXd M = Eigen::MatrixXd::Zero(size, size);
    M.topLeftCorner(n, n) = A;
    auto at = n;
    for (const auto& line : lines) {  // from −delay to 0
        const Eigen::MatrixXd own = 2 / line.delay * D;
        M.col(at + nodes - 1).head(n) = line.input;
        M.block(at, at, nodes, nodes) = own.bottomRightCorner(nodes, nodes);
        M.block(at, 0, nodes, n) = own.col(0).tail(nodes) * line.row;
        at += nodes;
    }
    return M;
}

LateLoop late_loop(const LatePlant& late, double delay, double tau, double lag, const LoopGains& base,
                   const LoopGains& turned)
{
    const auto& plant = late.prompt;
    const auto n = plant.A.rows();
    const bool filter = tau > 0 && (base.estimates() || turned.estimates());
    const bool integrates = base.integral != 0 || turned.integral != 0;
    const Eigen::Index size = n + filter + integrates;
    LateLoop loop;
    loop.delay = delay;
    loop.A = Eigen::MatrixXd::Zero(size, size);
    loop.A.topLeftCorner(n, n) = plant.A;
    loop.input = Eigen::VectorXd::Zero(size);
    loop.input.head(n) = plant.B;
    const Eigen::RowVectorXd reading = widened(plant.C, size);
    Eigen::RowVectorXd velocity = widened(plant.C_v, size), travelled = reading, sum = Eigen::RowVectorXd::Zero(size);
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
    if (late.friction.empty()) return loop;
    for (auto f : late.friction) {
        f.push.conservativeResizeLike(Eigen::VectorXd::Zero(size));
        f.speed = widened(f.speed, size);
        loop.friction.push_back(std::move(f));
    }
    loop.mechanism_right_of = late.roots_right_of;
    loop.other_poles = poles_around(lag, integrates);
    if (filter) loop.other_poles.push_back(-1 / tau);
    return loop;
}

std::optional<LateLoop> late_sampled_loop(const LatePlant& late, const LoopTiming& timing, double lag,
                                          const LoopGains& base, const LoopGains& turned)
{
    const auto parts = loop_without_whole_ticks(late.prompt, timing, base, turned);
    if (!parts) return std::nullopt;
    LateLoop loop;
    loop.A = parts->loop.difference;
    loop.input = parts->loop.input;
    loop.output = parts->loop.output;
    loop.held = parts->held;
    loop.period = timing.period;
    loop.delay = parts->whole_ticks * timing.period;
    if (late.friction.empty()) return loop;
    loop.friction = late.friction;
    loop.mechanism_right_of = late.roots_right_of;
    const bool sums = base.integral != 0 || turned.integral != 0;
    const bool travels = timing.exact && (base.travelled != 0 || turned.travelled != 0);
    loop.other_poles = poles_around(lag, sums || travels);
    if (!timing.exact && timing.tau > 0 && (base.estimates() || turned.estimates()))
        loop.other_poles.push_back(std::log(timing.tau / (timing.tau + timing.period)) / timing.period);
    loop.ticked = std::make_shared<const TickedFriction>(TickedFriction{late.prompt, timing, base, turned});
    return loop;
}

namespace {

/// Newton's method from `s`; nothing where it does not settle. A step of `rounding` is none, nor is one that no longer
/// shrinks beside a root: of slow roots of fast loops rounding takes the last digits.
std::optional<Complex> polished(const OpenedLoop& open, double gain, Complex s, double rounding)
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

/// The roots of a loop that is no matrix, found from lines along which it turns fastest where a root is near.
class LineSearch {
  public:
    LineSearch(const OpenedLoop& open, double gain) : open_(open), gain_(gain), unit_(open.turns_in())
    {
        constexpr double integrator = 1e-9;  // of the fastest pole
        double fastest = 0;
        for (const Complex& p : open.poles()) fastest = std::max(fastest, std::abs(p));
        for (const Complex& p : open.poles())
            if (std::abs(p) > integrator * fastest) unit_ = std::min(unit_, std::abs(p));
    }

    /// Roots from the steepest places of a line. How many lie right of it, where that can be counted.
    std::optional<int> look(double sigma, double nearest = infinity)
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
        constexpr std::size_t most = 24;
        for (std::size_t i = 0; i < std::min(most, peaks.size()); ++i) take({sigma, peaks[i].omega});
        return count;
    }
    /// The imaginary axis and lines left of it, by what dead time turns in.
    void look_around()
    {
        for (const double share : {1e-3, -0.3, -1.0, -2.0}) look(share * unit_);
    }
    /// The rightmost root, right of which counting finds none; nothing where it is not found.
    std::optional<Complex> edge()
    {
        look(1e-3 * unit_);
        if (roots_.empty())
            if (const auto pole = edge_at_pole()) return pole;
        const auto found = edge_by_newton();
        return found ? found : edge_at_pole();
    }
    /// With their conjugates, by falling real part.
    std::vector<Complex> all() const
    {
        std::vector<Complex> both;
        for (const Complex& s : roots_) {
            both.push_back(s);
            if (s.imag() != 0 && s.imag() < open_.end() * (1 - 1e-9)) both.push_back(std::conj(s));
        }
        return both;
    }

  private:
    std::optional<Complex> edge_by_newton()
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
            if (!right) return std::nullopt;
            if (*right == 0) return s;
            const Complex now = *std::max_element(roots_.begin(), roots_.end(), further_left);
            if (now.real() > s.real() + nearest) continue;
            // none of those that were counted is near that line: half a step at a time to the right
            double sigma = s.real() + nearest, wide = unit_;
            for (int k = 0; k<most&& * right> 0; ++k, wide *= 2) {
                right = look(sigma + wide);
                if (!right) return std::nullopt;
                const Complex found = *std::max_element(roots_.begin(), roots_.end(), further_left);
                if (found.real() > s.real() + nearest) break;
            }
        }
        return std::nullopt;
    }
    /// A pole that the loop does not reach through its dead time: the root beside it differs by less than rounding.
    std::optional<Complex> edge_at_pole() const
    {
        constexpr double beside = 1e-9;
        for (const Complex& p : open_.exact_poles()) {
            const double width = beside * std::abs(p);
            if (!(width > 0) || !std::isfinite(width)) continue;
            const auto right = roots_right_of(open_, gain_, p.real() + width, width),
                       with = roots_right_of(open_, gain_, p.real() - width, width);
            if (right && with && *right == 0 && *with > 0) return Complex(p.real(), std::abs(p.imag()));
        }
        return std::nullopt;
    }
    static bool further_left(Complex a, Complex b) { return a.real() < b.real(); }
    /// Newton's method without the poles of the loop, which would catch it, and the roots that are known; nothing where
    /// it does not come near one.
    std::optional<Complex> near_root(Complex s) const
    {
        constexpr int most = 50;
        constexpr double close = 1e-6;
        for (int i = 0; i < most; ++i) {
            const auto F = open_.closing(gain_, s);
            Complex slope = F.slope / F.value;
            for (const Complex& p : open_.exact_poles())
                if (std::isfinite(p.real())) slope += 1.0 / (s - p);
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
    void take(Complex start)
    {
        const auto near = near_root(start);
        if (!near) return;
        const auto found = polished(open_, gain_, *near, 0);
        if (!found || std::abs(*found - *near) > 1e-3 * std::abs(*near)) return;
        Complex s(found->real(), std::abs(found->imag()));
        if (s.imag() < 1e-9 * std::abs(s)) s.imag(0);
        if (s.imag() > open_.end() * (1 + 1e-9)) return;
        const auto same = [&](Complex other) { return std::abs(other - s) < 1e-8 * (std::abs(s) + 1e-6 * unit_); };
        if (std::none_of(roots_.begin(), roots_.end(), same)) roots_.push_back(s);
    }

    const OpenedLoop& open_;
    double gain_, unit_;
    std::vector<Complex> roots_;
};

bool has_matrix(const LateLoop& loop)
{
    return loop.period == 0 && loop.friction.empty();
}

void sort_by_real_part(std::vector<Complex>& roots)
{
    std::sort(roots.begin(), roots.end(),
              [](Complex a, Complex b) { return a.real() != b.real() ? a.real() > b.real() : a.imag() > b.imag(); });
}

}  // namespace

std::vector<Complex> roots(const LateLoop& loop, double gain)
{
    if (!has_matrix(loop)) {
        if (!loop.A.allFinite()) return {};
        const OpenedLoop open(loop);
        LineSearch search(open, gain);
        search.look_around();
        auto found = search.all();
        sort_by_real_part(found);
        return found;
    }
    constexpr int nodes = 32;
    // where dead time is short, its nodes lose the digits of slow roots, and without dead time these are near
    Eigen::VectorXcd starts = eigenvalues_of(loop.A + loop.input * (loop.held - gain * loop.output));
    std::vector<Complex> raw(starts.begin(), starts.end()), found;
    if (raw.empty()) return found;
    const OpenedLoop open(loop);
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
    sort_by_real_part(found);
    return found;
}

namespace {

/// Whether no root lies further right than this one of the size |s|, by more than what the count resolves: beside slow
/// roots of fast loops rounding takes its digits.
bool is_rightmost(const LateLoop& loop, double gain, double real, double size)
{
    const OpenedLoop open(loop);
    for (const double share : {1e-7, 1e-5, 1e-3}) {
        const double nearest = share * (std::abs(real) + 1e-3 * size);
        if (const auto right = roots_right_of(open, gain, real + nearest, nearest)) return *right == 0;
    }
    return false;
}

}  // namespace

std::optional<Complex> rightmost_root(const LateLoop& loop, double gain)
{
    if (!loop.A.allFinite()) return std::nullopt;
    const OpenedLoop open(loop);
    return LineSearch(open, gain).edge();
}

double late_growth(const LateLoop& loop, double gain)
{
    constexpr double rounding = 1e-14;
    if (!has_matrix(loop)) {
        const auto edge = rightmost_root(loop, gain);
        if (!edge) return not_set;
        return std::abs(edge->real()) < rounding * std::abs(*edge) ? 0 : edge->real();
    }
    const auto all = roots(loop, gain);
    if (all.empty()) return not_set;
    double size = 0;
    for (const auto& s : all) size = std::max(size, std::abs(s));
    Complex most = all.front();
    if (loop.delay > 0 && !is_rightmost(loop, gain, most.real(), std::abs(most))) {
        // Chebyshev nodes over a long dead time miss the fast roots of a stiff mechanism
        const auto edge = rightmost_root(loop, gain);
        if (!edge) return not_set;
        most = *edge;
    }
    return std::abs(most.real()) < rounding * (loop.delay > 0 ? std::abs(most) : size) ? 0 : most.real();
}

}  // namespace stickslip
