#include "sweep/report/stability_report.h"

#include "analysis/boundary/locate.h"
#include "analysis/results/text.h"
#include "analysis/stability/verdict.h"
#include "sweep/evaluate.h"
#include "sweep/report/linear_report.h"
#include "sweep/report/verdict_text.h"

#include <cmath>

namespace stickslip {
namespace {

using Tone = Headline::Tone;

std::string id_of(const Axis& x, const Axis& y, const char* kind)
{
    std::string id = kind;
    for (const auto* axis : {&x, &y}) {
        id += '-';
        for (const char c : axis->path.substr(axis->path.rfind('.') + 1))
            id += std::isalnum(static_cast<unsigned char>(c)) ? static_cast<char>(std::tolower(c)) : '-';
    }
    return id;
}

std::string stiffness(double k, Motion motion)
{
    return with_unit(k, Quantity::stiffness, motion);
}

std::string margin_text(const Margin& m)
{
    if (!m.found || m.value == 0) return "";
    return (m.boundary < m.value ? "÷ " : "× ") +
           plain_number(m.boundary < m.value ? m.value / m.boundary : m.boundary / m.value);
}

Headline margin_headline(const Margin& m, bool stable, Motion motion)
{
    Headline h;
    const auto range = with_unit(m.low, m.axis.quantity, motion) + " … " + with_unit(m.high, m.axis.quantity, motion);
    if (!m.found) {
        h.value = "none";
        h.meaning = "boundary along " + m.axis.symbol + " within " + range;
        return h;
    }
    h.value = m.value > 0 && m.boundary > 0 ? margin_text(m) : with_unit(m.boundary - m.value, m.axis.quantity, motion);
    h.meaning = (stable ? "margin of " : "change needed of ") + m.axis.symbol + ", to the boundary at " +
                with_unit(m.boundary, m.axis.quantity, motion, 4);
    const double ratio = m.boundary / m.value;
    const bool near = ratio > 1 / 1.2 && ratio < 1.2;
    h.tone = !stable ? Tone::bad : near ? Tone::warning : Tone::neutral;
    return h;
}

Table margin_table(const std::vector<Margin>& margins, Motion motion)
{
    Table table;
    table.title = "Margins of the design point, one parameter at a time";
    table.columns = {"parameter", "design value", "nearest boundary", "factor", "searched"};
    for (const auto& m : margins)
        table.rows.push_back(
            {m.axis.name + " " + m.axis.symbol, with_unit(m.value, m.axis.quantity, motion, 4),
             m.found ? with_unit(m.boundary, m.axis.quantity, motion, 6) : "none found", m.found ? margin_text(m) : "–",
             with_unit(m.low, m.axis.quantity, motion) + " … " + with_unit(m.high, m.axis.quantity, motion)});
    return table;
}

Figure map_figure(const Joint& joint, const Slice& slice)
{
    Figure figure;
    auto map = stability_map(joint, slice);
    figure.id = id_of(slice.x, slice.y, "map");
    figure.finding = "Stability map over " + slice.x.name + " and " + slice.y.name + ". The two theories differ on " +
                     percent(map.disagreement) + " of the chart. The design point is " +
                     (map.design.spectral_abscissa < 0 ? "stable." : "unstable.");
    figure.caption =
        "Largest real part of the spectrum, with memory: blue decays, red grows. Solid: boundary with memory "
        "(state-variable "
        "friction). Dashed: boundary if friction depended on velocity alone. Hatched: where the two disagree, " +
        percent(map.disagreement) +
        " of the chart as drawn. Both curves are located to a relative bracket of 10^{−12}, not contoured from the "
        "grid; a closed piece "
        "smaller than one ninety-sixth of an axis could be missed.";
    figure.picture = std::move(map);
    return figure;
}

Figure profile_figure(const Joint& joint, const Profile& profile)
{
    const auto motion = joint.mechanism.motion;
    const auto& axis = profile.axis;
    LineChart chart;
    chart.title = "Decay and growth over " + axis.symbol;
    chart.x_label = axis.name + " " + axis.symbol + " [" + std::string(unit_of(axis.quantity, motion)) + "]";
    chart.y_label = "max Re s [1/s]";
    chart.x_log = axis.log;
    chart.lines.push_back({"with memory", axis.values, profile.abscissa});
    std::string crossings;
    for (const auto& point : locate_on_ray(joint, axis.path, axis.values.front(), axis.values.back(), axis.log,
                                           Curve::Kind::state_variable)) {
        chart.x_marks.emplace_back(with_unit(point.value, axis.quantity, motion, 4), point.value);
        crossings += (crossings.empty() ? "" : ", ") + with_unit(point.value, axis.quantity, motion, 6);
    }
    Figure figure;
    figure.id = id_of(axis, axis, "profile");
    figure.finding =
        crossings.empty() ? "No change of stability along " + axis.name : "Stability changes at " + crossings;
    figure.caption = "Largest real part of the spectrum along " + axis.symbol +
                     "; below zero small disturbances decay. " + figure.finding + ".";
    figure.picture = std::move(chart);
    return figure;
}

Figure surface_figure(const Joint& joint, const Axis& x, const Axis& y)
{
    Figure figure;
    auto surface = critical_gain_surface(joint, x, y);
    double low = infinity, high = -infinity;
    for (const double z : surface.z)
        if (std::isfinite(z)) low = std::min(low, z), high = std::max(high, z);
    const auto motion = joint.mechanism.motion;
    figure.id = id_of(x, y, "surface");
    const std::string range =
        low <= high ? "from " + stiffness(low, motion) + " to " + stiffness(high, motion) : "nowhere on this range";
    figure.finding = "Surface of the critical position gain over " + x.name + " and " + y.name + ", " + range;
    figure.caption = "Least position gain for stable sliding, " + range + "." + where_no_critical_gain(joint, surface);
    figure.picture = std::move(surface);
    return figure;
}

const Axis* axis_of(const Spec& spec, const std::string& path)
{
    for (const auto& axis : spec.axes)
        if (axis.path == path) return &axis;
    return nullptr;
}

}  // namespace

Report stability_report(const Spec& spec, const SweepSummary& summary)
{
    const Joint joint = design_joint(spec);
    const auto motion = joint.mechanism.motion;
    const auto linear = linear_verdict(joint);
    const bool stable = linear.state_variable.stable;

    Report report;
    report.title = spec.report.title.empty() ? spec.title : spec.report.title;
    report.subtitle = std::string(joint.control.kind == ControlKind::position ? "position control" : "force control") +
                      " · " + (motion == Motion::prismatic ? "prismatic" : "revolute") + " joint · " +
                      std::string(info(joint.friction.law).name) + " friction · " + std::to_string(summary.points) +
                      " points";
    report.verdict = verdict_text(joint, linear);
    report.tone = linear.steady.reason != Reason::none ? Tone::warning : stable ? Tone::good : Tone::bad;

    std::vector<Margin> margins;
    for (const auto& axis : spec.axes) margins.push_back(margin_along(joint, axis));
    for (std::size_t i = 0; i < margins.size() && i < 3; ++i)
        report.headlines.push_back(margin_headline(margins[i], stable, motion));

    Section maps{"maps", "Stability maps", "", {}, {}};
    for (const auto& slice : summary.slices) {
        maps.figures.push_back(map_figure(joint, slice));
        const auto& map = std::get<StabilityMap>(maps.figures.back().picture);
        if (&slice == &summary.slices.front())
            report.headlines.push_back({Tone::neutral, percent(map.disagreement),
                                        "of the first chart is judged differently by velocity-only friction"});
        if (!map.design.inside)
            report.alerts.push_back({Tone::warning, "The design point lies outside the chart over " + slice.x.name +
                                                        " and " + slice.y.name + "."});
    }
    report.headlines.push_back(
        {summary.undecided ? Tone::warning : Tone::good,
         percent(summary.points ? static_cast<double>(summary.undecided) / static_cast<double>(summary.points) : 0),
         "of the points are undecided"});
    for (const auto& [reason, count] : summary.reasons)
        report.alerts.push_back({Tone::warning, std::to_string(count) + " points have no verdict: " + reason + "."});
    for (const auto& profile : summary.profiles) maps.figures.push_back(profile_figure(joint, profile));
    if (!maps.figures.empty()) report.sections.push_back(std::move(maps));

    Section surfaces{"critical-gain", "Critical position gain", "", {}, {}};
    for (const auto& [x, y] : spec.report.surfaces)
        if (const Axis* a = axis_of(spec, x), *b = axis_of(spec, y); a && b)
            surfaces.figures.push_back(surface_figure(joint, *a, *b));
    if (!surfaces.figures.empty()) report.sections.push_back(std::move(surfaces));

    Section design{"design", "The design point", "", {}, {}};
    if (!margins.empty()) design.tables.push_back(margin_table(margins, motion));
    if (linear.steady.reason == Reason::none) design.tables.push_back(linear_table(joint, linear));
    if (spec.nonlinear.enabled) {
        auto options = nonlinear_options(spec.nonlinear);
        options.bifurcation = true;
        design.tables.push_back(nonlinear_table(joint, nonlinear_verdict(joint, options)));
    }
    report.sections.push_back(std::move(design));
    if (linear.steady.reason == Reason::none)
        for (auto& section : linear_sections(joint, linear_study(joint))) report.sections.push_back(std::move(section));

    if (!spec.nonlinear.enabled)
        report.not_checked.push_back(
            "Large disturbances: the verdicts are those of the linear theory, and hold for small ones.");
    for (const char* text :
         {"Terms locked to position or time (ripple, cogging, drift, periodic forces) are no part of these verdicts.",
          "Sampling, delay, saturation and quantisation of a digital loop."})
        report.not_checked.push_back(text);
    report.provenance = summary.provenance;
    return report;
}

}  // namespace stickslip
