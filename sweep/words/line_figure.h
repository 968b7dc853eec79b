// Line charts with their labels and words: what every chart of the linear theory is made with.
#pragma once
#include "analysis/results/report.h"
#include "analysis/stability/verdict.h"
#include "sweep/study/samples.h"

#include <string>
#include <string_view>
#include <vector>

namespace stickslip {

/// "velocity V_{0}" and its unit.
AxisName axis_label(std::string_view name, Quantity quantity, Units units);

/// smooth() of sweep/study/samples.h for a line of a chart.
void smooth(LineChart::Line& line, const std::function<double(double)>& y, double most = 0.15, int rounds = 6);

/// A chart with its words; the finding is what a screen reader says and stands first in the caption.
Figure line_figure(std::string id, Picture chart, std::string finding, std::string reading);

/// The intervals whose ends read differently in words: of differences between two sets, slivers remain where their ends
/// nearly coincide.
std::vector<Interval> that_read_apart(std::vector<Interval> list, Quantity quantity, Units units);

/// "above 55 kN/m", "from 5 kN/m to 8 kN/m, …" of open intervals; "none" of none.
std::string intervals_text(const std::vector<Interval>& list, Quantity quantity, Units units);

/// What a theory asks of k_v, given the set with which it calls sliding stable: "k_{v} > 500 N·s/m", "729 N·s/m <
/// k_{v} < 4.12 kN·s/m" where too much is unstable, too.
std::string demanded_text(const std::vector<Interval>& stable_k_v, Units units);

}  // namespace stickslip
