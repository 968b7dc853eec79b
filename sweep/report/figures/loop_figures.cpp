#include "sweep/report/figures/loop_figures.h"

#include "analysis/results/point.h"
#include "analysis/results/text.h"
#include "sweep/report/figures/line_figure.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

constexpr double leap = 0.1;  ///< what no root goes at once, per |s| of what is drawn

std::string stiffness(double k, Units units)
{
    return with_unit(k, Quantity::position_gain, units);
}

/// All branches in two lines: the roots of the gains at which the joint is stable, and of those at which it is not.
class LocusLines {
  public:
    explicit LocusLines(const RootLocus& locus) : locus_(locus)
    {
        for (std::size_t branch = 0; branch < locus.roots.front().size(); ++branch) add(branch);
    }

    std::vector<DetailedChart::Line> drawn() &&
    {
        std::vector<DetailedChart::Line> lines;
        for (auto* line : {&stable_, &unstable_})
            if (std::any_of(line->x.begin(), line->x.end(), [](double v) { return std::isfinite(v); }))
                lines.push_back(std::move(*line));
        return lines;
    }

  private:
    bool stable_at(std::size_t row) const
    {
        return std::all_of(locus_.roots[row].begin(), locus_.roots[row].end(), [](auto s) { return s.real() < 0; });
    }

    void add(std::size_t branch)
    {
        for (std::size_t i = 1; i < locus_.roots.size(); ++i) {
            const auto a = locus_.roots[i - 1][branch], b = locus_.roots[i][branch];
            // another root has taken the place of one that went out of sight
            const bool leaps = std::abs(b - a) > leap * locus_.limit;
            if (leaps || std::abs(a) > locus_.limit || std::abs(b) > locus_.limit) continue;
            auto& line = stable_at(i) ? stable_ : unstable_;
            const bool goes_on = !line.x.empty() && line.x.back() == a.real() && line.y.back() == a.imag();
            if (!goes_on) append(line, {missing, missing}, missing), append(line, a, locus_.gains[i - 1]);
            append(line, b, locus_.gains[i]);
        }
    }

    static void append(DetailedChart::Line& line, std::complex<double> root, double gain)
    {
        line.x.push_back(root.real()), line.y.push_back(root.imag()), line.along.push_back(gain);
    }

    const RootLocus& locus_;
    DetailedChart::Line stable_{"k_{p} at which sliding is stable", {}, {}},
        unstable_{"k_{p} at which it is not", {}, {}, true};
};

/// A mark at each root of the design's own gain that lies within what is drawn.
void add_own_roots(DetailedChart& chart, const RootLocus& locus, Units units)
{
    double left = infinity, right = -infinity, low = infinity, high = -infinity;
    for (const auto& line : chart.lines)
        for (std::size_t i = 0; i < line.x.size(); ++i) {
            if (std::isnan(line.x[i])) continue;
            left = std::min(left, line.x[i]), right = std::max(right, line.x[i]);
            low = std::min(low, line.y[i]), high = std::max(high, line.y[i]);
        }
    DetailedChart::Line own{"the design, k_{p} = " + stiffness(locus.own_gain, units), {}, {}};
    own.look = DetailedChart::Line::Look::points;
    for (const auto s : locus.own) {
        if (s.real() < left || s.real() > right || s.imag() < low || s.imag() > high) continue;
        own.x.push_back(s.real()), own.y.push_back(s.imag()), own.along.push_back(locus.own_gain);
    }
    if (!own.x.empty()) chart.lines.push_back(std::move(own));
}

Figure root_locus_figure(const RootLocus& locus, Units units)
{
    const double low = locus.gains.front(), high = locus.gains.back(), limit = locus.limit;
    DetailedChart chart;
    chart.title = "Root locus over k_{p}";
    chart.fixed = "k_{p} " + range_text(low, high, Quantity::position_gain, units) + ", roots with |s| < " +
                  with_unit(limit, Quantity::rate, units);
    chart.x_label = {"Re s", "1/s"};
    chart.y_label = {"Im s", "rad/s"};
    chart.along_label = axis_label("k_{p}", Quantity::position_gain, units);
    chart.lines = LocusLines(locus).drawn();
    if (!chart.lines.empty()) add_own_roots(chart, locus, units);
    chart.x_marks.emplace_back("boundary Re s = 0", 0);
    std::string crossing;
    for (const auto& p : locus.crossings)
        crossing += (crossing.empty() ? "" : ", ") + with_unit(p.value, Quantity::position_gain, units, 4);
    Figure figure;
    figure.id = "root-locus";
    figure.finding =
        "Root locus over the position gain. " + (crossing.empty() ? std::string("No root crosses the imaginary axis.")
                                                                  : "Stability changes at k_{p} = " + crossing + ".");
    figure.caption =
        "How to read it: the lines follow the roots of the design's characteristic equation while k_{p} alone "
        "changes, and marks without a line are those of its own k_{p}; reading a point gives its k_{p}. Left of the "
        "mark a root decays, and where all of them do, "
        "sliding is stable. " +
        std::string(locus.rational ? "" : "A delay has infinitely many roots; the rightmost are drawn. ") +
        figure.finding;
    figure.picture = std::move(chart);
    return figure;
}

}  // namespace

std::vector<Figure> loop_figures(const std::optional<RootLocus>& locus, Units units)
{
    if (!locus) return {};
    Figure figure = root_locus_figure(*locus, units);
    if (std::get<DetailedChart>(figure.picture).lines.empty()) return {};
    return {std::move(figure)};
}

}  // namespace stickslip
