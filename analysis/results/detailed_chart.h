// A line chart that says more than its lines do.
#pragma once
#include "analysis/results/stability_map.h"

#include <optional>

namespace stickslip {

/// A line chart with more than lines: marks alone, broad lines, what a curve was drawn over, a second panel over the
/// same axis below, an axis that rare spikes do not stretch, a record that the page can play.
struct DetailedChart {
    struct Line {
        enum class Look {
            line,    ///< marks, where there are any, stand on samples
            points,  ///< every sample is a mark, and nothing lies between them
            rule     ///< what the other lines are held against: thin, in the ink of the axes, without marks
        };
        std::string name;
        std::vector<double> x, y;
        bool dashed = false;
        Look look = Look::line;
        bool wide = false;         ///< broad and pale, so that what follows it closely is seen on it
        bool see_through = false;  ///< paler than what is drawn over it, in grey as well
        std::optional<std::size_t> place =
            {};                          ///< drawn as the line in this place: one thing has one pen; none: its own
        std::vector<double> along = {};  ///< what a curve in the plane was drawn over; empty, or one for each sample
    };
    std::string title, fixed;
    AxisName x_label, y_label;
    bool x_log = false, y_log = false;
    std::vector<Line> lines;
    std::vector<std::pair<std::string, double>> x_marks;  ///< vertical marks with a label
    AxisName along_label = {};                            ///< of Line::along; its name is empty where there is none
    double shown_share = 1;     ///< of each line's values, that the y axis must span: one spike would flatten all else
    AxisName below_label = {};  ///< y axis of the panel below
    std::vector<Line> below = {};
    bool played = false;  ///< lines are positions of one joint in time, those below are efforts: the page can play them
    bool turns = false;   ///< played: of a revolute joint
};

/// The same chart with nothing added.
inline DetailedChart detailed(const LineChart& plain)
{
    DetailedChart chart;
    chart.title = plain.title, chart.fixed = plain.fixed;
    chart.x_label = plain.x_label, chart.y_label = plain.y_label;
    chart.x_log = plain.x_log, chart.y_log = plain.y_log;
    chart.x_marks = plain.x_marks;
    for (const auto& line : plain.lines) chart.lines.push_back({line.name, line.x, line.y, line.dashed});
    return chart;
}

}  // namespace stickslip
