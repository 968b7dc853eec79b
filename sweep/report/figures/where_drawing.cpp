#include "sweep/report/figures/where_drawing.h"

#include "sweep/words/diagnosis_tables.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

constexpr double drawing_width = 760, width = 720, box_width = 122, box_height = 28, box_left = 2, arrow_length = 16;
constexpr double bar_height = 12, bars_left = 136, bars_width = 520;
constexpr const char* stages[] = {"command", "effort", "motion"};

class Drawing {
  public:
    LineDrawing drawing;

    void line(double x1, double y1, double x2, double y2) { drawing.lines.push_back({{x1, y1}, {x2, y2}}); }
    void text(double x, double y, std::string words, LineDrawing::Anchor anchor = LineDrawing::Anchor::middle)
    {
        drawing.labels.push_back({x, y, std::move(words), anchor});
    }
    void arrow_down(double x, double from, double to)
    {
        line(x, from, x, to);
        drawing.lines.push_back({{x - 4, to - 7}, {x, to}, {x + 4, to - 7}});
    }
    /// A solid bar from 0 to 1 with its number at the end of the row, and the interval as a whisker below it.
    void bar(double y, const Share& s)
    {
        constexpr double left = bars_left, length = bars_width;
        const double end = left + length * std::clamp(s.share, 0.0, 1.0);
        if (end > left) drawing.bars.push_back({left, y, end - left, bar_height});
        line(left, y - 2, left, y + bar_height + 7);
        text(width, y + bar_height - 1, whole_percent(s.share), LineDrawing::Anchor::right);
        if (!std::isfinite(s.interval.low) || !std::isfinite(s.interval.high)) return;
        const double low = left + length * std::clamp(s.interval.low, 0.0, 1.0),
                     high = left + length * std::clamp(s.interval.high, 0.0, 1.0), below = y + bar_height + 4;
        line(low, below, high, below);
        for (double x : {low, high}) line(x, below - 3, x, below + 3);
    }
};

const Share* named(const std::vector<Share>& shares, const char* name)
{
    const auto at = std::find_if(shares.begin(), shares.end(), [&](const Share& s) { return s.name == name; });
    return at == shares.end() ? nullptr : &*at;
}

}  // namespace

Figure where_figure(const Diagnosis& d)
{
    Drawing w;
    w.drawing.title = "Where the gap lies";
    w.drawing.width = drawing_width;
    const double middle = box_left + box_width / 2;
    w.text(middle, 14, "reference");
    double y = 20;
    std::string finding = "Shares of the gap along the chain:";
    for (const char* stage : stages) {
        w.arrow_down(middle, y, y + arrow_length);
        y += arrow_length;
        w.drawing.boxes.push_back({box_left, y, box_width, box_height});
        w.text(middle, y + box_height / 2 + 4, stage);
        if (const Share* s = named(d.signals, stage)) {
            w.bar(y + (box_height - bar_height) / 2 - 2, *s);
            finding += " " + s->name + " " + whole_percent(s->share) + ",";
        } else {
            w.text(bars_left, y + box_height / 2 + 4, "not judged", LineDrawing::Anchor::left);
        }
        y += box_height;
    }
    finding.back() = '.';
    w.drawing.height = y + 12;
    return {"where-drawn", w.drawing,
            "The input of every stage is the measured signal before it, so that shares do not add errors of other "
            "stages. Bars: shares; whiskers: 95 % intervals.",
            finding};
}

}  // namespace stickslip
