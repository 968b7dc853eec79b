// Lines and words that the charts of a record share. Internal to sweep/report/figures.
#pragma once
#include "analysis/results/diagnosis.h"
#include "analysis/results/report.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace stickslip {

/// Share of a line that its axis must show: a start-up spike would flatten the rest.
inline constexpr double usual_share = 0.995;

inline std::vector<double> difference(const std::vector<double>& a, const std::vector<double>& b)
{
    std::vector<double> r;
    for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k) r.push_back(a[k] - b[k]);
    return r;
}

/// Of the finite values; 0 of none.
inline double rms_of(const std::vector<double>& values)
{
    double sum = 0, n = 0;
    for (double v : values)
        if (std::isfinite(v)) sum += v * v, n += 1;
    return n > 0 ? std::sqrt(sum / n) : 0;
}

inline std::string effort_name(DiagnosedTrace::Effort effort)
{
    switch (effort) {
        case DiagnosedTrace::Effort::measured:
            return "measured effort";
        case DiagnosedTrace::Effort::command:
            return "command";
        case DiagnosedTrace::Effort::friction_of_rig:
            break;
    }
    return "friction";
}

/// "simulated", or "predicted" where no loop could be simulated.
inline std::string made(const DiagnosedTrace& trace)
{
    return trace.predicted ? "predicted" : "simulated";
}

inline DetailedChart::Line measured_line(std::vector<double> time, std::vector<double> values)
{
    DetailedChart::Line line{"measured", std::move(time), std::move(values), false};
    line.wide = true;  // a simulation that follows it is seen on it, not under it
    return line;
}

}  // namespace stickslip
