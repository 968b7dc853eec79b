#include "sweep/files/records/impossible_signals.h"

#include "analysis/diagnosis/audit/audit.h"
#include "analysis/diagnosis/records/ticks.h"
#include "analysis/diagnosis/rig/rig.h"

#include <algorithm>
#include <cmath>

namespace stickslip::files {
namespace {

struct Extremes {
    double low = infinity, high = -infinity;
    double largest() const { return std::max(std::abs(low), std::abs(high)); }
};

Extremes extremes_of(const std::vector<double>& values)
{
    Extremes e;
    for (const double v : values) {
        if (v < e.low) e.low = v;
        if (v > e.high) e.high = v;
    }
    return e;
}

/// Where a signal goes beyond a limit that holds for it by definition or by the document.
void beyond_limits(const Record& r, const Joint& joint, std::vector<Note>& found)
{
    constexpr double rounding = 1.01;  // of a log of two or three digits
    const bool duty = joint.actuator.kind == ActuatorKind::dc_motor && joint.actuator.signal == DriveSignal::duty;
    if (duty && !r.drive.empty())
        if (const double most = extremes_of(r.drive).largest(); most > rounding)
            found.push_back({.code = Note::Code::duty_above_one, .values = {most}});
    const auto& commanded = r.effort_command.empty() ? r.drive : r.effort_command;
    const double limit = joint.control.effort_limit;
    if (commanded.empty() || !std::isfinite(limit) || (duty && limit <= 1)) return;
    if (const double most = extremes_of(commanded).largest(); most > rounding * limit)
        found.push_back({.code = Note::Code::command_beyond_limit, .values = {most, limit}});
}

/// Counts of 2^n whose upper half is what negative numbers look like when their sign was lost: two heaps, one from 0
/// upwards, one from 2^n downwards, and nothing between.
void two_s_complement(const char* name, const std::vector<double>& values, std::vector<Note>& found)
{
    constexpr std::size_t few = 20;  // rows: fewer leave such gaps by chance
    if (values.size() < few) return;
    std::vector<double> sorted;
    for (const double v : values)
        if (std::isfinite(v)) sorted.push_back(v);
    std::sort(sorted.begin(), sorted.end());
    if (sorted.size() < few || sorted.front() < 0) return;
    const double step = gap::grid_of(sorted);
    if (!(step > 0)) return;
    const auto jump = std::adjacent_find(sorted.begin(), sorted.end(), [&](double a, double b) {
        constexpr double nothing_between = 0.5;  // of all that there is: a motion never leaves half its range out
        return b - a > nothing_between * sorted.back();
    });
    if (jump == sorted.end()) return;
    const double below = *jump / step, above = *std::next(jump) / step, most = sorted.back() / step;
    for (const int bits : {8, 10, 12, 16, 24, 32}) {
        const double whole = std::exp2(bits);
        constexpr double near_top = 0.02;  // small negative numbers end there; a range that ends so by chance is rare
        if (most > whole || whole - most > near_top * whole || above < 0.5 * whole || below > 0.5 * whole) continue;
        found.push_back({.code = Note::Code::unsigned_numbers,
                         .names = {name},
                         .values = {*jump, *std::next(jump), sorted.back(), static_cast<double>(bits), whole * step}});
        return;
    }
}

/// An effort that is never negative although what asks for it is, and follows its size.
void magnitude_only(const Record& r, std::vector<Note>& found)
{
    const auto& asked = r.effort_command.empty() ? r.drive : r.effort_command;
    const auto& effort = r.effort_measured.empty() ? r.current : r.effort_measured;
    if (asked.size() != effort.size() || effort.empty()) return;
    const Extremes given = extremes_of(asked), got = extremes_of(effort);
    constexpr double both_ways = 0.2;  // of the larger way: an effort that follows it would be negative, too
    if (got.low < 0 || got.high <= 0 || std::min(-given.low, given.high) < both_ways * given.largest()) return;
    double size = 0, sign = 0, squares = 0, asked_squares = 0;
    for (std::size_t k = 0; k < effort.size(); ++k) {
        if (!std::isfinite(asked[k]) || !std::isfinite(effort[k])) continue;
        size += std::abs(asked[k]) * effort[k], sign += asked[k] * effort[k];
        squares += effort[k] * effort[k], asked_squares += asked[k] * asked[k];
    }
    const double whole = std::sqrt(squares * asked_squares);
    // cosines: delay, lag and noise leave more than the first; a command that goes mostly one way reaches the second
    constexpr double follows = 0.8, does_not = 0.6;
    if (!(whole > 0) || size < follows * whole || std::abs(sign) > does_not * whole) return;
    found.push_back(
        {.code = Note::Code::magnitude_only, .names = {r.effort_measured.empty() ? "current" : "effort_measured"}});
}

/// Without control.period nothing says how fast the loop is; but no log of a joint has a row every half second.
void slow_clock(const Record& r, const Joint& joint, bool time_unit_named, std::vector<Note>& found)
{
    constexpr double too_slow = 0.5;  // s: a joint's motion is over in as long
    if (is_set(joint.control.period) || time_unit_named || r.rows() < 3 || gap::is_rig(r)) return;
    const double step = gap::median_step(r.time);
    if (step < too_slow) return;
    found.push_back({.code = Note::Code::slow_clock, .values = {step}});
}

}  // namespace

std::vector<Note> impossible_signals(const Record& record, const Joint& joint, bool time_unit_named)
{
    std::vector<Note> found;
    slow_clock(record, joint, time_unit_named, found);
    beyond_limits(record, joint, found);
    two_s_complement("effort_measured", record.effort_measured, found);
    two_s_complement("effort_command", record.effort_command, found);
    two_s_complement("drive", record.drive, found);
    two_s_complement("current", record.current, found);
    two_s_complement("position", record.position, found);
    magnitude_only(record, found);
    return found;
}

}  // namespace stickslip::files
