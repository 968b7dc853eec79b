#include "sweep/report/pages/margins_report.h"

#include "analysis/joint/parameters.h"
#include "analysis/results/text.h"
#include "analysis/stability/verdict.h"
#include "sweep/report/pages/robust_figure.h"
#include "sweep/words/nearest_text.h"
#include "sweep/words/symbols.h"
#include "sweep/words/verdict_text.h"

#include <fmt/format.h>

#include <algorithm>
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

/// max Re s while one coordinate moves away from the joint, up to a little beyond its boundary.
DetailedChart::Line growth_line(const Joint& joint, const Coordinate& coordinate, const std::string& name, double reach,
                                double window)
{
    constexpr int steps = 240;
    MovableJoint movable(joint, {coordinate});
    DetailedChart::Line line{name, {}, {}};
    for (int i = -steps; i <= steps; ++i) {
        const double q = reach * i / steps;
        const double growth = linear_point(movable.at({q / coordinate.scale})).spectral_abscissa;
        line.x.push_back(std::exp(q));
        line.y.push_back(std::abs(growth) <= window ? growth : missing);
    }
    return line;
}

/// How decay turns into growth along each parameter that has a boundary.
Figure growth_figure(const MarginsAnswer& a)
{
    constexpr double beyond = 1.15;  // the logarithm of a change, past the farthest boundary
    constexpr double tall = 4;  // the window, per |max Re s| of the joint: what grows faster would flatten the rest
    const auto motion = a.joint.mechanism.motion;
    const double own = linear_point(a.joint).spectral_abscissa, window = tall * std::abs(own);
    DetailedChart chart;
    chart.title = "Decay and growth while one parameter moves";
    chart.x_label = "parameter, as a multiple of its value";
    chart.y_label = "max Re s [1/s]";
    chart.x_log = true;
    double reach = 0;
    std::string crossings;
    for (const auto& n : a.alone)
        if (n.found) reach = std::max(reach, beyond * std::abs(std::log(n.moves[0].to / n.moves[0].from)));
    for (std::size_t i = 0; i < a.alone.size(); ++i) {
        if (!a.alone[i].found) continue;
        const auto& move = a.alone[i].moves[0];
        const auto name = name_text(a.alone_of[i].path, a.alone_of[i].less, motion);
        chart.lines.push_back(growth_line(a.joint, a.alone_of[i], name, reach, window));
        crossings += (crossings.empty() ? "" : ", ") + name + " at " + plain_number(move.to / move.from) + " times";
    }
    chart.lines.push_back(
        {"boundary", {std::exp(-reach), std::exp(reach)}, {0, 0}, false, DetailedChart::Line::Look::rule});
    chart.x_marks.emplace_back("as given", 1);
    Figure figure;
    figure.id = "growth-by-parameter";
    figure.finding =
        "Largest real part of the spectrum while one parameter moves. It crosses zero for " + crossings + " its value.";
    figure.caption =
        "How to read it: all lines meet at the joint as given, and each follows one parameter; below zero disturbances "
        "decay. Where a line crosses zero lies the boundary, and how steeply it does so says how soon a step beyond "
        "hurts. Lines end where decay or growth exceeds " +
        plain_number(tall) + " times that of the joint.";
    figure.picture = std::move(chart);
    return figure;
}

/// One factor of e each: margins_of measures the nearest boundary in plain logarithms.
std::vector<double> scales_of(const MarginsAnswer& a)
{
    return std::vector<double>(a.nearest.direction.size(), 1);
}

/// The parameter that has the shortest way to its boundary, alone.
const NearestMove* shortest_alone(const MarginsAnswer& a)
{
    const NearestMove* found = nullptr;
    const auto length = [](const NearestMove& m) { return std::abs(std::log(m.to / m.from)); };
    for (const auto& n : a.alone)
        if (n.found && (!found || length(n.moves[0]) < length(*found))) found = &n.moves[0];
    return found;
}

void add_headlines(Report& report, const MarginsAnswer& a)
{
    using Tone = Headline::Tone;
    const auto motion = a.joint.mechanism.motion;
    report.headlines.push_back(nearest_headline(a.nearest, motion));
    name_symbols(report, a.nearest, motion);
    if (const auto* move = shortest_alone(a)) {
        const auto quantity = quantity_of(a.joint, move->path);
        report.headlines.push_back(
            {Tone::neutral, name_text(move->path, move->less, motion) + " " + signed_percent(move->to / move->from - 1),
             "is the shortest way to the boundary for one parameter alone: from " +
                 with_unit(move->from, quantity, motion, 4) + " to " + with_unit(move->to, quantity, motion, 4)});
    }
    if (a.nearest.found)
        report.headlines.push_back({Tone::neutral, all_at_once(a.nearest.distance, scales_of(a)),
                                    "in all " + std::to_string(a.nearest.direction.size()) +
                                        " parameters at once cannot reach the boundary (distance " +
                                        plain_number(a.nearest.distance) + ")"});
    if (a.worst) {
        const double growth = a.worst->instability;
        report.headlines.push_back({growth < 0 ? Tone::good : Tone::bad, with_unit(growth, Quantity::rate, motion),
                                    "max Re s of the worst joint within the stated uncertainty; stable below 0"});
    }
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
        text += " All " + std::to_string(a.nearest.direction.size()) + " parameters may be off by " +
                all_at_once(a.nearest.distance, scales_of(a)) + " at once without reaching it (distance " +
                plain_number(a.nearest.distance) + ").";
    return text + worst_text(a);
}

Report margins_report(const MarginsAnswer& a)
{
    Report report;
    report.title = a.title.empty() ? "Margins of the joint" : a.title;
    report.subtitle = "margins of the design point";
    report.verdict = margins_text(a);
    const bool doubtful = a.worst && a.worst->instability >= 0;
    report.tone = !a.nearest.decided              ? Headline::Tone::warning
                  : a.nearest.stable && !doubtful ? Headline::Tone::good
                                                  : Headline::Tone::bad;
    if (a.nearest.decided) add_headlines(report, a);
    Section section{"margins", "Margins", "", {}, {alone_table(a)}};
    if (a.robust && a.nominal) section.figures.push_back(robust_figure(a));
    if (shortest_alone(a)) section.figures.push_back(growth_figure(a));
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
