#include "sweep/report/pages/load_section.h"

#include "analysis/results/text.h"
#include "sweep/report/figures/line_figure.h"

#include <cmath>

namespace stickslip {
namespace {

LineChart over_load(const char* title)
{
    LineChart chart;
    chart.title = title;
    chart.x_label = {"normal load σ_{n} per the nominal one"};
    return chart;
}

Figure growth_figure(const LoadStudy& study, Units units)
{
    auto chart = over_load("Growth rate over the normal load");
    chart.y_label = axis_label("max Re s", Quantity::rate, units);
    LineChart::Line memory{"with memory", {}, {}}, simple{"velocity-only model", {}, {}, true},
        zero{"no growth", {}, {}};
    for (const auto& v : study.at) {
        for (auto* line : {&memory, &simple, &zero}) line->x.push_back(v.load);
        memory.y.push_back(v.state_variable);
        simple.y.push_back(v.velocity_only);
        zero.y.push_back(0);
    }
    chart.lines = {std::move(memory), std::move(simple), std::move(zero)};
    return line_figure(
        "load-growth", std::move(chart),
        "Sliding is stable at the loads of " + percent(study.stable_state_variable) +
            " of the record with memory, of " + percent(study.stable_velocity_only) + " in the velocity-only model.",
        "σ_{n} of (1) multiplies the friction; below zero a small disturbance decays. Each load is taken "
        "as held long enough for sliding to become steady.");
}

Figure gain_figure(const Joint& joint, const LoadStudy& study, Units units)
{
    auto chart = over_load("Critical position gain over the normal load");
    chart.y_label = axis_label("position gain k_{p}", Quantity::position_gain, units);
    LineChart::Line critical{"k_{cr} with memory", {}, {}}, own{"the joint's k_{p}", {}, {}, true};
    for (const auto& v : study.at) {
        critical.x.push_back(v.load), own.x.push_back(v.load);
        critical.y.push_back(std::isfinite(v.k_cr) ? v.k_cr : missing);
        own.y.push_back(joint.control.k_p);
    }
    chart.lines = {std::move(critical), std::move(own)};
    return line_figure("load-gain", std::move(chart),
                       "The largest gain is required at a load of " + plain_number(study.hardest_load, 4) + ": " +
                           with_unit(study.hardest_k_cr, Quantity::position_gain, units, 4) + ".",
                       "A position gain above the curve keeps sliding stable at that load.");
}

}  // namespace

Table load_table(const Joint& joint, const LoadStudy& study)
{
    const Units units = units_of(joint);
    double k_v = 0;
    for (const auto& v : study.at) k_v = std::max(k_v, v.k_v_min);
    const std::string where =
        std::isnan(study.hardest_k_cr) ? "" : " (at load " + plain_number(study.hardest_load, 4) + ")";
    Table table;
    table.title = "Over the normal loads of the record";
    table.columns = {"quantity", "value"};
    table.rows = {
        {"normal loads", span_text(study.low, study.high, Quantity::number, units, low_to_high, 4)},
        {"stable share of the record, with memory", percent(study.stable_state_variable)},
        {"stable share of the record, velocity-only model", percent(study.stable_velocity_only)},
        {"largest critical position gain k_{cr}",
         std::isnan(study.hardest_k_cr) ? "none"
                                        : with_unit(study.hardest_k_cr, Quantity::position_gain, units, 4) + where},
        {"largest velocity gain required by the velocity-only model",
         with_unit(k_v, Quantity::velocity_gain, units, 4)}};
    return table;
}

Section load_section(const Joint& joint, const LoadStudy& study)
{
    const Units units = units_of(joint);
    Section section{"normal-load", "Normal load", "", {}, {}};
    section.tables.push_back(load_table(joint, study));
    if (study.at.size() < 2) return section;
    section.figures.push_back(growth_figure(study, units));
    if (!std::isnan(study.hardest_k_cr)) section.figures.push_back(gain_figure(joint, study, units));
    return section;
}

}  // namespace stickslip
