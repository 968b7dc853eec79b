#include "sweep/report/figures/ladder_drawing.h"

#include "analysis/base/field.h"
#include "sweep/words/diagnosis_tables.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

constexpr double drawing_width = 760, left = 176, length = 480, right = 720;
constexpr double bar_height = 12, row_height = 28;

class Waterfall {
  public:
    LineDrawing drawing;

    void line(double x1, double y1, double x2, double y2) { drawing.lines.push_back({{x1, y1}, {x2, y2}}); }
    static double at(double share) { return left + length * std::clamp(share, 0.0, 1.0); }

    /// A bar between two levels of what is left of the gap; the interval of the lower one as a whisker below it.
    void step(const std::string& name, double from, double to, const ConfidenceInterval& interval)
    {
        drawing.labels.push_back({left - 10, y_ + bar_height - 1, name, LineDrawing::Anchor::right});
        drawing.labels.push_back({right, y_ + bar_height - 1, whole_percent(from - to), LineDrawing::Anchor::right});
        if (from > to) drawing.bars.push_back({at(to), y_, at(from) - at(to), bar_height});
        line(at(to), y_ - 2, at(to), y_ + row_height + bar_height);  // leads on to the next step
        if (std::isfinite(interval.low) && std::isfinite(interval.high)) {
            const double low = at(from - interval.high), high = at(from - interval.low), below = y_ + bar_height + 4;
            line(low, below, high, below);
            for (double x : {low, high}) line(x, below - 3, x, below + 3);
        }
        y_ += row_height;
    }
    void ceiling(double share)
    {
        const double x = at(1 - share);
        for (double y = 4; y < y_; y += 6) line(x, y, x, std::min(y + 3, y_));
        const bool near_right_end = share < 0.5;
        drawing.labels.push_back({near_right_end ? x - 4 : x + 4, y_ + 14, "not explainable left of this line",
                                  near_right_end ? LineDrawing::Anchor::right : LineDrawing::Anchor::left});
        y_ += 20;
    }
    void finish() { drawing.height = y_ + 6; }

  private:
    double y_ = 12;
};

}  // namespace

Figure ladder_figure(const Diagnosis& d)
{
    Waterfall w;
    w.drawing.title = "The ladder of causes";
    w.drawing.width = drawing_width;
    double left_over = 1;
    std::string finding = "Shares of the gap:";
    const auto step = [&](const std::string& name, double share, const ConfidenceInterval& interval) {
        const double next = std::clamp(left_over - share, 0.0, 1.0);
        w.step(name, left_over, next, interval);
        finding += " " + name + " " + whole_percent(left_over - next) + ",";
        left_over = next;
    };
    constexpr double worth_a_bar = 0.005;
    if (d.corrected_share > worth_a_bar) step("corrections", d.corrected_share, {});
    for (const auto& rung : d.ladder) step(together(rung.names), rung.share, rung.interval);
    w.step("remainder", left_over, 0, {});
    finding += " remainder " + whole_percent(left_over) + ".";
    if (is_set(d.ceiling.share)) w.ceiling(d.ceiling.share);
    w.finish();
    std::string depends;
    for (const auto& signal : d.remainder.structure) depends += (depends.empty() ? "" : ", ") + signal;
    const auto has_ends = [](const LadderRung& r) { return is_set(r.interval.low) && is_set(r.interval.high); };
    std::string caption = "Shares of the squared gap beyond the noise, on held-out data";
    caption += std::ranges::any_of(d.ladder, has_ends) ? "; whiskers are 95 % intervals." : ".";
    // a rig has no numbers of its own to correct, and no flexible model to hold a cause against
    if (is_set(d.ceiling.share))
        caption += " Inertia, friction and load are corrected within their uncertainty in every comparison.";
    if (!depends.empty()) caption += " What remains still depends on: " + depends + ".";
    return {"ladder", w.drawing, caption, finding};
}

}  // namespace stickslip
