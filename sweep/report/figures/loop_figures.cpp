#include "sweep/report/figures/loop_figures.h"

#include "analysis/boundary/trace/locate.h"
#include "analysis/results/text.h"
#include "analysis/stability/linear_joint.h"
#include "analysis/stability/loop.h"
#include "analysis/stability/steady.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

constexpr int locus_gains = 400, late_gains = 120;  // where roots have no end, each gain costs a search

std::vector<double> log_steps(double low, double high, int count)
{
    std::vector<double> values;
    for (int i = 0; i < count; ++i) values.push_back(low * std::pow(high / low, i / (count - 1.0)));
    return values;
}

std::string stiffness(double k, Motion motion)
{
    return with_unit(k, Quantity::stiffness, motion);
}

/// Where a root lies that decides stability: those far to the left would squeeze the rest into a line.
double reach(const std::vector<std::vector<std::complex<double>>>& rows)
{
    double size = 0;
    for (const auto& row : rows) {
        const auto slowest =
            *std::max_element(row.begin(), row.end(), [](const auto& a, const auto& b) { return a.real() < b.real(); });
        size = std::max(size, std::abs(slowest));
    }
    return size;
}

// steps of a branch, per |s| of what is drawn: the longest of a smooth line, and what no root goes at once
constexpr double longest = 0.004, longest_late = 0.02, leap = 0.1;

struct Locus {
    std::vector<double> gains;
    std::vector<std::vector<std::complex<double>>> rows;
    double limit;  ///< |s| of what is drawn
};

/// Gains close enough that no visible branch is drawn with corners: where two roots meet they run apart like a square
/// root of the gain.
Locus smooth_locus(const LinearJoint& linear, double low, double high)
{
    const int rounds = linear.rational() ? 10 : 3;
    const double step = linear.rational() ? longest : longest_late;
    Locus locus{log_steps(low, high, linear.rational() ? locus_gains : late_gains), {}, 0};
    for (int round = 0;; ++round) {
        locus.rows = root_locus(linear, locus.gains);
        std::size_t least =
            locus.rows.front().size();  // of roots without end the rightmost are known, now more now less
        for (const auto& row : locus.rows) least = std::min(least, row.size());
        for (auto& row : locus.rows) row.resize(least);
        if (least == 0) return locus;
        if (round == 0) locus.limit = 1.2 * reach(locus.rows);
        std::vector<double> finer{locus.gains.front()};
        for (std::size_t i = 1; i < locus.gains.size(); ++i) {
            bool jumps = false;
            for (std::size_t k = 0; k < locus.rows[i].size(); ++k) {
                const auto a = locus.rows[i - 1][k], b = locus.rows[i][k];
                jumps =
                    jumps || (std::min(std::abs(a), std::abs(b)) < locus.limit && std::abs(a - b) > step * locus.limit);
            }
            if (jumps) finer.push_back(std::sqrt(locus.gains[i - 1] * locus.gains[i]));
            finer.push_back(locus.gains[i]);
        }
        if (round == rounds || finer.size() == locus.gains.size()) return locus;
        locus.gains = std::move(finer);
    }
}

/// All branches in two lines: the roots of the gains at which the joint is stable, and of those at which it is not.
class LocusLines {
  public:
    explicit LocusLines(const Locus& locus) : locus_(locus)
    {
        for (std::size_t branch = 0; branch < locus.rows.front().size(); ++branch) add(branch);
    }

    std::vector<LineChart::Line> drawn() &&
    {
        std::vector<LineChart::Line> lines;
        for (auto* line : {&stable_, &unstable_})
            if (std::any_of(line->x.begin(), line->x.end(), [](double v) { return std::isfinite(v); }))
                lines.push_back(std::move(*line));
        return lines;
    }

  private:
    bool stable_at(std::size_t row) const
    {
        return std::all_of(locus_.rows[row].begin(), locus_.rows[row].end(), [](auto s) { return s.real() < 0; });
    }

    void add(std::size_t branch)
    {
        for (std::size_t i = 1; i < locus_.rows.size(); ++i) {
            const auto a = locus_.rows[i - 1][branch], b = locus_.rows[i][branch];
            // another root has taken the place of one that went out of sight
            const bool leaps = std::abs(b - a) > leap * locus_.limit;
            if (leaps || std::abs(a) > locus_.limit || std::abs(b) > locus_.limit) continue;
            auto& line = stable_at(i) ? stable_ : unstable_;
            const bool goes_on = !line.x.empty() && line.x.back() == a.real() && line.y.back() == a.imag();
            if (!goes_on) append(line, missing, missing), append(line, a.real(), a.imag());
            append(line, b.real(), b.imag());
        }
    }

    static void append(LineChart::Line& line, double x, double y) { line.x.push_back(x), line.y.push_back(y); }

    const Locus& locus_;
    LineChart::Line stable_{"k_{p} at which sliding is stable", {}, {}},
        unstable_{"k_{p} at which it is not", {}, {}, true};
};

Figure root_locus_figure(const Joint& joint, const LinearJoint& linear, double low, double high)
{
    const auto motion = joint.mechanism.motion;
    const auto locus = smooth_locus(linear, low, high);
    const double limit = locus.limit;
    LineChart chart;
    chart.title = "Root locus over k_{p}";
    chart.fixed = "k_{p} from " + stiffness(low, motion) + " to " + stiffness(high, motion) + ", roots with |s| < " +
                  with_unit(limit, Quantity::rate, motion);
    chart.x_label = "Re s [1/s]";
    chart.y_label = "Im s [rad/s]";
    if (!locus.rows.front().empty()) chart.lines = LocusLines(locus).drawn();
    chart.x_marks.emplace_back("boundary Re s = 0", 0);
    if (chart.lines.empty()) return {"root-locus", std::move(chart), "", ""};
    std::string crossing;
    for (const auto& p : locate_on_ray(joint, "control.k_p", low, high, true, Curve::Kind::state_variable))
        crossing += (crossing.empty() ? "" : ", ") + with_unit(p.value, Quantity::stiffness, motion, 4);
    Figure figure;
    figure.id = "root-locus";
    figure.finding =
        "Root locus over the position gain. " + (crossing.empty() ? std::string("No root crosses the imaginary axis.")
                                                                  : "Stability changes at k_{p} = " + crossing + ".");
    figure.caption =
        "How to read it: the lines follow the roots of the design's characteristic equation while k_{p} alone "
        "changes; left of the mark a root decays, and where all of them do, sliding is stable. " +
        std::string(linear.rational() ? "" : "A delay has roots without end; those furthest to the right are drawn. ") +
        figure.finding;
    figure.picture = std::move(chart);
    return figure;
}

}  // namespace

std::vector<Figure> loop_figures(const Joint& joint, double low, double high)
{
    const auto steady = steady_sliding(joint);
    if (steady.reason != Reason::none || !(steady.velocity > 0) || !(low > 0)) return {};
    const LinearJoint linear = linear_joint(joint, steady.velocity);
    Figure figure = root_locus_figure(joint, linear, low, high);
    if (std::get<LineChart>(figure.picture).lines.empty()) return {};
    std::vector<Figure> figures;
    figures.push_back(std::move(figure));
    return figures;
}

}  // namespace stickslip
