// In one file: one proof: the edge of the spectrum, found and confirmed by counting.
#include "analysis/stability/delay_spectrum.h"

#include <algorithm>
#include <optional>

#include "analysis/stability/characteristic.h"
#include "analysis/stability/frequency_search.h"
#include "analysis/stability/neutral.h"
#include "analysis/stability/winding.h"

namespace stickslip {
namespace {

constexpr double same_root = 1e-8;  // of |s|: closer are one root

/// Roots that are known, a pair as the one with Im s ≥ 0.
using Known = std::vector<Complex>;

int counted(const Known& roots)
{
    int sum = 0;
    for (const Complex& s : roots) sum += s.imag() == 0 ? 1 : 2;
    return sum;
}

/// Newton's method from `s`, the known roots divided out; then once more with nothing divided out.
std::optional<Complex> newton(const LinearJoint& j, Complex s, const Known& known)
{
    constexpr int most = 60;
    constexpr double close = 1e-6, exact = 4e-15;
    bool near = false;
    for (int i = 0; i < most && !near; ++i) {
        Complex slope = drift(j, s);
        for (const Complex& r : known) {
            slope -= 1.0 / (s - r);
            if (r.imag() != 0) slope -= 1.0 / (s - std::conj(r));
        }
        const Complex step = 1.0 / slope;
        if (!std::isfinite(std::abs(step))) return std::nullopt;
        s -= step;
        near = std::abs(step) < close * std::abs(s);
    }
    if (!near) return std::nullopt;
    const Complex before = s;
    for (int i = 0; i < 10; ++i) {
        if (closed_loop(j, s).value == 0.0) break;
        const Complex step = 1.0 / drift(j, s);
        if (std::isnan(std::abs(step))) break;  // on a pole, where a state decays that the motion does not notice
        if (!(std::abs(step) < 10 * close * std::abs(s))) return std::nullopt;
        s -= step;
        if (std::abs(step) < exact * std::abs(s)) break;
    }
    if (!(std::abs(s - before) < 10 * close * std::abs(s))) return std::nullopt;
    if (std::abs(s.imag()) < same_root * std::abs(s)) s = s.real();
    s = {s.real(), std::abs(s.imag())};
    for (const Complex& r : known)
        if (std::abs(r - s) < same_root * std::abs(s)) return std::nullopt;
    return s;
}

/// The `most` frequencies of a line from which a root is nearest: the phase turns fastest there.
std::vector<double> steepest_of(const LineCount& line, std::size_t most)
{
    const auto& nodes = line.nodes;
    std::vector<LineCount::Node> peaks;
    for (std::size_t i = 0; i < nodes.size(); ++i)
        if ((i == 0 || nodes[i].steepness >= nodes[i - 1].steepness) &&
            (i + 1 == nodes.size() || nodes[i].steepness >= nodes[i + 1].steepness))
            peaks.push_back(nodes[i]);
    std::sort(peaks.begin(), peaks.end(), [](const auto& a, const auto& b) { return a.steepness > b.steepness; });
    std::vector<double> starts;
    for (std::size_t i = 0; i < std::min(most, peaks.size()); ++i) starts.push_back(peaks[i].omega);
    return starts;
}

/// Those and, where they do not suffice, others evenly from the whole line.
std::vector<double> starts_of(const LineCount& line, std::size_t most)
{
    auto starts = steepest_of(line, most);
    const std::size_t stride = line.nodes.size() / most + 1;
    for (std::size_t i = 0; i < line.nodes.size(); i += stride) starts.push_back(line.nodes[i].omega);
    return starts;
}

/// The search for the right edge of the spectrum.
class Edge {
  public:
    explicit Edge(const LinearJoint& joint) : joint_(joint), scale_(frequency_bound(joint, std::abs(joint.k_p)))
    {
        double longest = 0;
        for (int i = 0; i < joint.bodies; ++i) {
            const auto& f = joint.friction[i];
            for (const auto& d : f.delays) longest = std::max(longest, d.time);
            if (f.table) longest = std::max(longest, f.table->duration());
        }
        reach_ = 1 / longest;
    }

    double abscissa()
    {
        if (!std::isfinite(scale_) || !begin()) return missing;
        while (roots_.empty() && high_ - low_ > 1e-10 * (std::abs(low_) + std::abs(high_))) {
            if (const auto root = rightmost_between()) {
                if (!take(*root)) return missing;
                continue;
            }
            const double middle = low_ == 0 ? 1e-2 * high_ : (low_ + high_) / 2;
            const auto there = look(middle);
            if (!there) break;
            if (there->roots == 0)
                high_ = middle;
            else
                low_ = middle, at_low_ = *there;
        }
        return roots_.empty() ? high_ : side_of_axis(joint_, roots_.front());
    }

    /// All roots right of some line on which between `wanted` and `most` of them are counted.
    Known roots()
    {
        const double edge = abscissa();
        if (std::isnan(edge)) return {};
        LineCount line = at_low_;
        double sigma = line.sigma;
        far_enough(edge, sigma, line);
        const Known first = roots_;
        gather(sigma, edge, line);
        std::sort(roots_.begin(), roots_.end(), [](Complex a, Complex b) { return a.real() > b.real(); });
        const Known sure = line.roots == counted(roots_) ? roots_ : confirmed();
        return sure.empty() ? first : sure;
    }

  private:
    /// The count at σ, or, where a root lies on the line within rounding, just beside it.
    std::optional<LineCount> look(double sigma) const
    {
        constexpr int most = 60'000;
        for (const double aside : {0.0, 1e-12}) {
            auto count = count_right_of(joint_, sigma + aside * scale_, most);
            if (count) return count;
        }
        return std::nullopt;
    }

    /// The root is the rightmost one if counting finds none beyond it; else the search goes on right of it.
    bool take(Complex root)
    {
        const double beyond = root.real() + 1e-9 * std::abs(root);
        const auto count = look(beyond);
        if (!count) return false;
        if (count->roots == 0)
            roots_ = {root};
        else
            low_ = beyond, at_low_ = *count;
        return true;
    }

    /// [low, high] with roots right of low and none right of high, or the rightmost root at once.
    bool begin()
    {
        const auto axis = look(0);
        if (!axis) return false;
        at_low_ = *axis;
        if (axis->roots > 0) {
            high_ = 1.01 * scale_;
            return true;
        }
        low_ = -scale_;
        // where the phase turns fastest the rightmost root is near, as a rule, and a count tells
        auto near = rightmost_of(steepest_of(at_low_, 4));
        if (!near) near = rightmost_between();
        if (near && take(*near)) return true;
        return further_left();
    }

    /// Steps left until roots are counted.
    bool further_left()
    {
        bool blocked = false;
        high_ = 0, low_ = -1e-9 * scale_;
        for (int tries = 0, lost = 0; tries < 80 && lost < 4; ++tries) {
            const auto here = look(low_);
            lost += !here;
            if (here && here->roots > 0) {
                at_low_ = *here;
                return true;
            }
            // further left, or back to where what is delayed has not outgrown all numbers
            if (here)
                high_ = low_, low_ = blocked ? 1.2 * low_ : std::max(8 * low_, low_ - 2 * reach_);
            else
                blocked = true, low_ = (low_ + high_) / 2;
        }
        return false;
    }

    /// The rightmost root that Newton's method finds between low and high, from where the phase turns fastest on the
    /// line that was counted last.
    std::optional<Complex> rightmost_between() const
    {
        constexpr std::size_t starts = 24;
        return rightmost_of(starts_of(at_low_, starts));
    }

    std::optional<Complex> rightmost_of(const std::vector<double>& starts) const
    {
        std::optional<Complex> best;
        Known found;
        for (const double omega : starts) {
            const auto root = newton(joint_, {at_low_.sigma, omega}, found);
            if (!root) continue;
            found.push_back(*root);
            const double near = 1e-9 * std::abs(*root);
            const bool between = root->real() > low_ && root->real() <= high_ + near;  // left of low all are known
            if (between && (!best || root->real() > best->real())) best = root;
            if (at_low_.roots > 0 && counted(found) >= at_low_.roots && best) break;
        }
        return best;
    }

    /// Moves the line left until enough roots lie right of it.
    void far_enough(double edge, double& sigma, LineCount& line) const
    {
        constexpr int wanted = 20, most = 40, most_tries = 16;
        double near = edge, step = std::max(1e-3 * std::abs(edge), 1e-9 * scale_);
        if (line.roots >= wanted && line.roots <= most) return;
        for (int tries = 0, lost = 0; tries < most_tries && lost < 3; ++tries) {
            // left of the axis what is delayed grows by e a reach: no further at a time
            const double at = std::max(near - step, std::min(near, 0.0) - reach_);
            const auto there = look(at);
            lost += !there;
            if (!there || there->roots > most) {
                step /= 2;
                if (step < 1e-9 * std::abs(edge)) return;
                continue;
            }
            near = sigma = at, line = *there;
            if (line.roots >= wanted) return;
            step *= 2;
        }
    }

    /// Newton's method from the nodes of the line and from lines right of it until all that were counted are found.
    void gather(double sigma, double edge, const LineCount& line)
    {
        std::erase_if(roots_, [&](Complex s) { return s.real() < sigma; });
        const auto starts = starts_of(line, 100);
        Known all = roots_;  // those left of the line are divided out, too
        for (const double share : {0.0, 0.5, 0.25, 0.75, 1.0}) {
            for (const double omega : starts) {
                if (counted(roots_) >= line.roots) return;
                const auto root = newton(joint_, {sigma + share * (edge - sigma), omega}, all);
                if (!root) continue;
                all.push_back(*root);
                if (root->real() > sigma) roots_.push_back(*root);
            }
        }
    }

    /// The longest beginning of the list that counting confirms.
    Known confirmed() const
    {
        Known sure;
        for (std::size_t k = 0; k < roots_.size(); ++k) {
            const bool last = k + 1 == roots_.size();
            const double here = roots_[k].real(),
                         next = last ? here - 1e-6 * std::abs(roots_[k]) : roots_[k + 1].real();
            if (here - next < 1e-12 * scale_ && !last) continue;
            const auto count = look((here + next) / 2);
            const Known first(roots_.begin(), roots_.begin() + static_cast<std::ptrdiff_t>(k) + 1);
            if (!count || count->roots != counted(first)) break;
            sure = first;
        }
        return sure;
    }

    const LinearJoint& joint_;
    double scale_, low_ = 0, high_ = 0;
    double reach_ = 0;  ///< over which what is delayed longest grows by e
    LineCount at_low_;
    Known roots_;
};

}  // namespace

double delayed_abscissa(const LinearJoint& joint)
{
    return Edge(joint).abscissa();
}

std::vector<Complex> roots_near(const LinearJoint& joint, const LineCount& line, std::size_t most,
                                const std::vector<Complex>& expected)
{
    Known found;
    const auto take = [&](Complex start) {
        if (const auto root = newton(joint, start, found)) found.push_back(*root);
    };
    for (const Complex& s : expected) take(s);
    for (const double omega : steepest_of(line, most)) take({line.sigma, omega});
    return found;
}

std::vector<Complex> rightmost_roots(const LinearJoint& joint)
{
    std::vector<Complex> all;
    for (Complex s : Edge(joint).roots()) {
        s.real(side_of_axis(joint, s));
        all.push_back(s);
        if (s.imag() != 0) all.push_back(std::conj(s));
    }
    return all;
}

}  // namespace stickslip
