#include "sweep/report/pages/reduction_section.h"

#include "analysis/joint/parameters.h"
#include "analysis/results/text.h"
#include "sweep/report/figures/line_figure.h"
#include "sweep/words/study_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

/// A number of a joint as charts name it.
struct Named {
    std::string symbol;
    Quantity quantity = Quantity::number;
    double value = missing;
};

Named named(Joint joint, const std::string& path)
{
    for (const auto& p : parameters(joint))
        if (p.path == path) {
            if (path == "control.k_p") return {"k_{p}", p.quantity, *p.value};
            if (path == "joint.transmission.stiffness") return {"k_{tr}", p.quantity, *p.value};
            if (path == "joint.motor_transmission.stiffness") return {"k_{m-tr}", p.quantity, *p.value};
            if (path == "joint.transmission_link.stiffness") return {"k_{tr-l}", p.quantity, *p.value};
            return {p.path, p.quantity, *p.value};
        }
    return {path};
}

std::string boundaries_text(const std::vector<double>& values, Quantity quantity, Units units)
{
    std::string text;
    for (const double v : values) text += (text.empty() ? "" : ", ") + with_unit(v, quantity, units, 4);
    return text.empty() ? "none" : text;
}

/// The i-th boundary of every value, missing where there are fewer.
std::vector<double> boundary_line(const ReductionStudy& study, std::vector<double> ReductionError::*side, std::size_t i)
{
    std::vector<double> line;
    for (const auto& at : study.at) line.push_back(i < (at.*side).size() ? (at.*side)[i] : missing);
    return line;
}

std::string good_text(const ReductionStudy& study, const Named& number, Units units)
{
    const auto from = [&](double v) {
        return std::isnan(v) ? std::string("nowhere") : number.symbol + " ≥ " + with_unit(v, number.quantity, units);
    };
    return "within 1 %: " + from(study.good_from) + "; within 10 %: " + from(study.fair_from);
}

Figure boundary_figure(const Joint& joint, const ReductionStudy& study, const std::string& id)
{
    const Units units = units_of(joint);
    const auto moved = named(joint, study.assumption_path), boundary = named(joint, study.boundary_path);
    LineChart chart;
    chart.title = "Boundary of the full joint and of " + study.model;
    chart.fixed = "assumed: " + study.assumption;
    chart.x_label = axis_label(moved.symbol, moved.quantity, units);
    chart.y_label = axis_label(boundary.symbol + " at the boundary", boundary.quantity, units);
    chart.x_log = chart.y_log = true;
    std::size_t most_full = 0, most_reduced = 0;
    for (const auto& at : study.at) {
        most_full = std::max(most_full, at.full.size());
        most_reduced = std::max(most_reduced, at.reduced.size());
    }
    for (std::size_t i = 0; i < most_full; ++i)
        chart.lines.push_back({most_full > 1 ? "full joint, boundary " + std::to_string(i + 1) : "full joint",
                               study.values, boundary_line(study, &ReductionError::full, i)});
    for (std::size_t i = 0; i < most_reduced; ++i)
        chart.lines.push_back({most_reduced > 1 ? "reduced, boundary " + std::to_string(i + 1) : "reduced",
                               study.values, boundary_line(study, &ReductionError::reduced, i), true});
    chart.x_marks.emplace_back("here", moved.value);
    return line_figure(id, std::move(chart),
                       std::isfinite(study.own.error)
                           ? "The reduction to " + study.model + " moves the boundary of this joint by " +
                                 reduction_error_text(study.own.error) + "."
                           : "The reduction to " + study.model +
                                 " at this joint's own values: " + reduction_error_text(study.own.error) + ".",
                       "Solid: the full joint. Dashed: the reduced one. A boundary is where stability changes along " +
                           boundary.symbol + "; a line ends where there is none " +
                           range_text(study.searched_low, study.searched_high, boundary.quantity, units) + ".");
}

Figure error_figure(const Joint& joint, const ReductionStudy& study, const std::string& id)
{
    const Units units = units_of(joint);
    const auto moved = named(joint, study.assumption_path);
    LineChart chart;
    chart.title = "Error of the boundary of " + study.model;
    chart.fixed = "assumed: " + study.assumption;
    chart.x_label = axis_label(moved.symbol, moved.quantity, units);
    chart.y_label = {"relative error of the boundary", "1"};
    chart.x_log = chart.y_log = true;
    constexpr double least = 1e-12;  // what the located boundaries themselves are good for
    LineChart::Line line{"error", study.values, {}};
    for (const auto& at : study.at) line.y.push_back(std::isinf(at.error) ? missing : std::max(at.error, least));
    chart.lines = {std::move(line),
                   {"1 %", {study.values.front(), study.values.back()}, {0.01, 0.01}, true},
                   {"10 %", {study.values.front(), study.values.back()}, {0.1, 0.1}, true}};
    chart.x_marks.emplace_back("here", moved.value);
    return line_figure(
        id, std::move(chart), "Good " + good_text(study, moved, units) + ".",
        "Largest relative distance between corresponding boundaries. No line: the full and the reduced "
        "joint have different numbers of boundaries, the reduction is wrong in kind, or neither has any.");
}

void add_once(std::vector<std::string>& list, const std::string& entry)
{
    if (std::find(list.begin(), list.end(), entry) == list.end()) list.push_back(entry);
}

}  // namespace

Section reduction_section(const Joint& joint, const std::vector<ReductionStudy>& studies)
{
    const Units units = units_of(joint);
    Section section{"reductions",
                    "Accuracy of the paper's reductions",
                    "Each step from the full joint to a single mass (Figs. 4 to 7) neglects something. For each, the "
                    "boundary of stability is located in the full joint and in the reduced one.",
                    {},
                    {}};
    Table table;
    table.title = "Reductions of this joint";
    table.columns = {"reduction", "assumes", "boundary, full", "boundary, reduced", "error here", "good"};
    std::vector<std::string> neglected;
    std::vector<std::pair<std::string, std::vector<std::string>>> refused;  // why, and which
    std::size_t number = 0;
    for (const auto& study : studies) {
        ++number;
        if (!study.compared()) {
            const auto why = refused_text(study);
            const auto same =
                std::find_if(refused.begin(), refused.end(), [&](const auto& entry) { return entry.first == why; });
            if (same == refused.end())
                refused.push_back({why, {study.name}});
            else
                add_once(same->second, study.name);
            continue;
        }
        const auto boundary = named(joint, study.boundary_path);
        for (const auto& what : study.neglected) add_once(neglected, what);
        table.rows.push_back(
            {study.name, study.assumption,
             boundary.symbol + " = " + boundaries_text(study.own.full, boundary.quantity, units),
             boundary.symbol + " = " + boundaries_text(study.own.reduced, boundary.quantity, units),
             reduction_error_text(study.own.error),
             study.values.empty() ? "exact" : good_text(study, named(joint, study.assumption_path), units)});
        const bool drawn = std::any_of(study.at.begin(), study.at.end(),
                                       [](const auto& at) { return !at.full.empty() || !at.reduced.empty(); });
        if (!drawn) continue;
        section.figures.push_back(boundary_figure(joint, study, "reduction-" + std::to_string(number)));
        const bool measured = std::any_of(study.at.begin(), study.at.end(),
                                          [](const auto& at) { return !std::isinf(at.error) && !at.full.empty(); });
        if (measured)
            section.figures.push_back(error_figure(joint, study, "reduction-error-" + std::to_string(number)));
    }
    if (!neglected.empty()) section.text += fmt::format(" Neglected: {}.", fmt::join(neglected, "; "));
    for (const auto& [why, which] : refused)
        section.text += fmt::format(" Not applicable ({}): {}.", fmt::join(which, ", "), why);
    if (!table.rows.empty()) section.tables.push_back(std::move(table));
    return section;
}

}  // namespace stickslip
