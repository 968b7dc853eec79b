#include "sweep/report/pages/first_screen.h"

#include "analysis/results/text.h"
#include "sweep/words/loop_text.h"
#include "sweep/words/nearest_text.h"
#include "sweep/words/verdict_text.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

using Tone = Headline::Tone;

std::string number_with_unit(double value, const Axis& axis, Units units, int digits = 3)
{
    return with_unit(value, axis.quantity, units, digits);
}

/// How far the boundary is as a factor ≥ 1; infinite where a sign or zero lies between.
double factor(const Margin& m)
{
    if (!m.found || m.value <= 0 || m.boundary <= 0) return infinity;
    return std::max(m.value / m.boundary, m.boundary / m.value);
}

std::string change_words(const Margin& m)
{
    const double change = m.boundary / m.value - 1;
    return std::string(change < 0 ? "−" : "+") +
           (std::abs(change) < 10 ? percent(std::abs(change)) : "1000 % and more");
}

}  // namespace

DesignVerdict design_verdict(const Joint& joint, const LinearVerdict& linear, Region region,
                             const NonlinearVerdict& nonlinear)
{
    const auto taken = taken_out(region == Region::bistable, nonlinear);
    DesignVerdict verdict{region, verdict_text(joint, linear, taken, nonlinear.comes_to_rest()), Tone::good};
    if (linear.steady.reason != Reason::none) {
        verdict.tone = Tone::warning;
    } else if (linear.state_variable.neutral) {
        verdict.tone = Tone::warning;
    } else if (!linear.state_variable.stable) {
        verdict.tone = Tone::bad;
    } else if (region == Region::bistable) {
        verdict.tone = Tone::warning;
    } else if (leaves_out_what_matters(linear.loop)) {
        verdict.tone = Tone::warning;
    }
    return verdict;
}

bool near_boundary(const std::vector<Margin>& margins)
{
    return std::any_of(margins.begin(), margins.end(), [](const Margin& m) { return factor(m) < near_factor; });
}

Headline nearest_boundary_headline(const std::vector<Margin>& margins, bool stable, Units units)
{
    const auto nearest = std::min_element(margins.begin(), margins.end(),
                                          [](const Margin& a, const Margin& b) { return factor(a) < factor(b); });
    Headline h;
    if (nearest == margins.end() || !std::isfinite(factor(*nearest))) {
        h.value = "none found";
        h.meaning = "boundary when one swept parameter changes alone, up to ten times beyond its axis";
        return h;
    }
    const auto& m = *nearest;
    h.value = change_words(m);
    const bool below = m.boundary < m.value;
    h.meaning = m.axis.symbol + ": " + (stable ? "stick-slip " : "smooth sliding ") + (below ? "below " : "above ") +
                number_with_unit(m.boundary, m.axis, units, 4) +
                " (design: " + number_with_unit(m.value, m.axis, units) +
                "); nearest change of one swept parameter alone, " + m.axis.name;
    h.tone = !stable ? Tone::bad : factor(m) < near_factor ? Tone::warning : Tone::good;
    return h;
}

/// The same motion with the velocities counted along the commanded direction.
VelocitySearch as_speeds(VelocitySearch search)
{
    if (!(search.velocity < 0)) return search;
    const auto turn = [](Interval i) { return Interval{-i.high, -i.low}; };
    const Interval range = turn({search.low, search.high});
    search.low = range.low, search.high = range.high;
    search.velocity *= -1;
    auto& found = search.found;
    found.least *= -1, found.all_above *= -1;
    std::ranges::transform(found.intervals, found.intervals.begin(), turn);
    std::ranges::reverse(found.intervals);
    return search;
}

/// Where velocities slide smoothly again above one; NaN: nowhere within the search.
double next_window(const StableVelocities& stable, double velocity)
{
    double next = missing;
    for (const auto& i : stable.intervals)
        if (i.low > velocity && !(i.low > next)) next = i.low;
    return next;
}

/// The intervals of smooth velocities below V_min: "from 1 µm/s (or slower) to 776 µm/s".
std::string windows_text(const VelocitySearch& search, Units units)
{
    std::string text;
    for (const auto& i : search.found.intervals) {
        if (i.low == search.found.all_above) continue;
        const bool open = i.low <= search.low * (1 + 1e-9);
        text += (text.empty() ? " from " : ", from ") +
                range_text(i.low, i.high, Quantity::velocity, units, {"", open ? " or slower to " : " to ", ""});
    }
    return text;
}

std::vector<Headline> velocity_headlines(const VelocitySearch& asked, bool stable, Units units)
{
    const VelocitySearch search = as_speeds(asked);
    const std::string backwards = asked.velocity < 0 ? ", backwards" : "";
    const auto text = [&](double v) { return with_unit(v, Quantity::velocity, units); };
    const double V = search.velocity, low = search.low, high = search.high;
    const auto& stable_set = search.found;
    const std::string searched =
        ", with these gains; searched " + range_text(low, high, Quantity::velocity, units) + backwards;
    if (stable_set.intervals.empty()) return {{Tone::bad, "none", "velocity slides smoothly" + searched}};
    std::vector<Headline> headlines;
    // one V_min everywhere: from here upwards every velocity slides, as in the figure over the gains
    const double from = stable_set.all_above;
    const bool windows = stable_set.least < from || std::isnan(from);
    headlines.push_back({Tone::neutral,
                         std::isnan(from)
                             ? "no V_{min}"
                             : (from <= low * (1 + 1e-9) ? "V_{min} ≤ " : "V_{min} = ") + text(from) + backwards,
                         (std::isnan(from) ? std::string("at the highest velocity the joint does not slide smoothly")
                                           : "every faster velocity slides smoothly") +
                             searched + (windows ? "; smooth" + windows_text(search, units) : "")});
    for (const auto& i : stable_set.intervals) {
        if (!stable || V < i.low || V > i.high || (i.low <= low * (1 + 1e-9) && i.high >= high * (1 - 1e-9))) continue;
        const bool open = i.high >= high * (1 - 1e-9);
        const double next = next_window(stable_set, i.high);
        headlines.push_back({!open && i.high < near_factor * V ? Tone::warning : Tone::neutral,
                             (open ? "≥ " : "") + text(i.high) + backwards,
                             "up to here sliding stays smooth when the design's " + text(V) + " is raised" +
                                 (open || std::isnan(next) ? "" : "; then not, up to " + text(next))});
    }
    return headlines;
}

Table margin_table(const std::vector<Margin>& margins, Units units)
{
    Table table;
    table.title = "Margins of the design point, one parameter at a time";
    table.columns = {"parameter", "design value", "nearest boundary", "change to it", "searched"};
    for (const auto& m : margins)
        table.rows.push_back(
            {m.axis.name + " " + m.axis.symbol, number_with_unit(m.value, m.axis, units, 4),
             m.found ? number_with_unit(m.boundary, m.axis, units, 6) : "none found",
             std::isfinite(factor(m)) ? change_words(m) : "–",
             number_with_unit(m.low, m.axis, units) + " … " + number_with_unit(m.high, m.axis, units)});
    return table;
}

}  // namespace stickslip
