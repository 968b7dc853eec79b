#include "sweep/report/margins_report.h"

#include "analysis/joint/parameters.h"
#include "analysis/results/text.h"
#include "sweep/files/symbols.h"
#include "sweep/report/boundary_report.h"
#include "sweep/report/nearest_text.h"
#include "sweep/report/verdict_text.h"

#include <fmt/format.h>

#include <cmath>

namespace stickslip {
namespace {

std::string name_text(const std::string& path, const std::string& less, Motion motion)
{
    return symbol_of(path, motion) + (less.empty() ? "" : " − " + symbol_of(less, motion));
}

std::string signed_percent(double share)
{
    return (share < 0 ? "−" : "+") + plain_number(100 * std::abs(share), 3) + " %";
}

Quantity quantity_of(const Joint& given, const std::string& path)
{
    Joint joint = given;
    const double* number = find_parameter(joint, path);
    for (const auto& leaf : parameters(joint))
        if (leaf.value == number) return leaf.quantity;
    return Quantity::number;
}

std::string worst_text(const MarginsAnswer& a)
{
    if (!a.worst) return "";
    std::string within;
    for (std::size_t i = 0; i < a.uncertainty.share.size(); ++i)
        within +=
            (i ? ", " : "") +
            name_text(a.uncertainty.coordinates[i].path, a.uncertainty.coordinates[i].less, a.joint.mechanism.motion) +
            " ± " + plain_number(100 * a.uncertainty.share[i]) + " %";
    std::string at;
    for (std::size_t i = 0; i < a.worst->deviations.size(); ++i)
        at +=
            (i ? ", " : "") +
            name_text(a.uncertainty.coordinates[i].path, a.uncertainty.coordinates[i].less, a.joint.mechanism.motion) +
            " " + signed_percent(a.worst->deviations[i]);
    const bool box = a.uncertainty.shape == UncertaintyShape::box;
    const double growth = a.worst->instability;
    return " Within the " + std::string(box ? "box " : "ellipsoid ") + within +
           (growth < 0 ? " it stays stable; least so at " + at + ", where disturbances still decay at "
                       : " it can turn unstable: at " + at + " disturbances grow at ") +
           plain_number(std::abs(growth)) + " 1/s.";
}

LineChart::Line line_of(const char* name, const FollowedBoundary& boundary, bool dashed)
{
    auto curve = curve_of(boundary);
    return {name, std::move(curve.x), std::move(curve.y), dashed};
}

Figure robust_figure(const MarginsAnswer& a)
{
    const auto& b = *a.robust;
    const auto motion = a.joint.mechanism.motion;
    const auto label = [&](const Axis& axis) {
        return axis.name + " " + axis.symbol + " [" + std::string(unit_of(axis.quantity, motion)) + "]";
    };
    LineChart chart;
    chart.title = "Robustly stable set over (" + b.x.symbol + ", " + b.y.symbol + ")";
    chart.x_label = label(b.x), chart.y_label = label(b.y);
    chart.x_log = b.x.log, chart.y_log = b.y.log;
    if (!b.pieces.empty()) chart.lines.push_back(line_of("worst case", b, false));
    if (a.nominal && !a.nominal->pieces.empty()) chart.lines.push_back(line_of("nominal", *a.nominal, true));
    Figure figure;
    figure.id = "robust-set";
    figure.caption =
        "Dashed: the boundary of the joint as described. Solid: where the worst case within the uncertainty turns "
        "unstable; on its stable side every joint of the uncertainty slides. Could be missed: " +
        could_be_missed(b) + ".";
    figure.finding = chart.title;
    figure.picture = std::move(chart);
    return figure;
}

}  // namespace

MarginsAnswer margins_of(const Joint& joint)
{
    MarginsAnswer answer;
    answer.joint = joint;
    auto coordinates = natural_coordinates(joint);
    answer.nearest = nearest_boundary(joint, coordinates, affordable_search(joint));
    for (const char* gain : {"control.k_v", "control.k_p"})
        if (!std::isnan(value_of(joint, {gain, ""}))) coordinates.insert(coordinates.begin(), Coordinate{gain, ""});
    for (const auto& c : coordinates) {
        answer.alone_of.push_back(c);
        answer.alone.push_back(nearest_boundary(joint, {c}, affordable_search(joint)));
    }
    return answer;
}

Table alone_table(const MarginsAnswer& a)
{
    const auto motion = a.joint.mechanism.motion;
    Table table;
    table.title = "One parameter at a time, within a factor of ten";
    table.columns = {"parameter", "value", "boundary", "change"};
    for (std::size_t i = 0; i < a.alone.size(); ++i) {
        const auto& c = a.alone_of[i];
        const auto quantity = quantity_of(a.joint, c.path);
        const auto& n = a.alone[i];
        table.rows.push_back({name_text(c.path, c.less, motion), with_unit(value_of(a.joint, c), quantity, motion, 5),
                              n.found ? with_unit(n.moves[0].to, quantity, motion, 8) : "none",
                              n.found ? signed_percent(n.moves[0].to / n.moves[0].from - 1) : "–"});
    }
    return table;
}

std::string margins_text(const MarginsAnswer& a)
{
    std::string text = nearest_text(a.nearest, a.joint.mechanism.motion);
    if (a.nearest.found)
        text += " That is a distance of " + plain_number(a.nearest.distance) + " in logarithms of the parameters.";
    return text + worst_text(a);
}

Report margins_report(const MarginsAnswer& a)
{
    Report report;
    report.title = a.title.empty() ? "Margins of the joint" : a.title;
    report.subtitle = "margins of the design point";
    report.verdict = margins_text(a);
    const bool doubtful = a.worst && a.worst->instability >= 0;
    report.tone = !a.nearest.decided || (a.nearest.stable && doubtful) ? Headline::Tone::warning
                  : a.nearest.stable                                   ? Headline::Tone::good
                                                                       : Headline::Tone::bad;
    Section section{"margins", "Margins", "", {}, {alone_table(a)}};
    if (a.robust) section.figures.push_back(robust_figure(a));
    report.sections.push_back(std::move(section));
    report.not_checked = {
        "Large disturbances: margins are those of the linear theory.",
        "A boundary beyond a factor of ten, or a stable pocket narrower than the steps along a direction."};
    report.provenance = {{"command", a.command}};
    return report;
}

nlohmann::ordered_json margins_json(const MarginsAnswer& a)
{
    nlohmann::ordered_json json = {{"format", "stickslip margins 1"}, {"title", a.title}};
    json["answer"] = plain_text(margins_text(a));
    json["nearest"] = nearest_json(a.nearest);
    json["alone"] = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < a.alone.size(); ++i) {
        const auto& c = a.alone_of[i];
        const auto& n = a.alone[i];
        nlohmann::ordered_json row = {{"path", c.less.empty() ? c.path : c.path + " - " + c.less},
                                      {"value", value_of(a.joint, c)},
                                      {"found", n.found}};
        row["boundary"] = n.found ? nlohmann::ordered_json(n.moves[0].to) : nlohmann::ordered_json(nullptr);
        json["alone"].push_back(std::move(row));
    }
    if (a.worst) {
        json["worst_case"] = {{"shape", a.uncertainty.shape == UncertaintyShape::box ? "box" : "ellipsoid"},
                              {"stable", a.worst->instability < 0},
                              {"spectral_abscissa", a.worst->instability},
                              {"deviations", a.worst->deviations},
                              {"evaluations", a.worst->evaluations}};
    }
    if (a.robust) {
        auto& points = json["robust_boundary"] = nlohmann::ordered_json::array();
        for (const auto& piece : a.robust->pieces) {
            auto one = nlohmann::ordered_json::array();
            for (const auto& p : piece.points)
                one.push_back({{"x", p.x}, {"y", p.y}, {"low", p.at.low}, {"high", p.at.high}});
            points.push_back(std::move(one));
        }
    }
    return json;
}

}  // namespace stickslip
