#include "sweep/report/pages/design_report.h"

#include "analysis/joint/parameters.h"
#include "analysis/loop/loop_use.h"
#include "analysis/results/text.h"
#include "sweep/report/figures/map_figures.h"
#include "sweep/words/nearest_text.h"
#include "sweep/words/verdict_text.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

using Tone = Headline::Tone;

struct Units {
    Motion motion;
    std::string stiffness(double v) const { return with_unit(v, Quantity::stiffness, motion, 4); }
    std::string damping(double v) const { return with_unit(v, Quantity::damping, motion, 4); }
    std::string position(double v) const { return with_unit(v, Quantity::position, motion); }
    std::string effort(double v) const { return with_unit(v, Quantity::effort, motion, 4); }
    std::string velocity(double v) const { return with_unit(v, Quantity::velocity, motion); }
};

std::string gains_text(const GainChoice& c, const Units& u)
{
    return "k_{p} = " + u.stiffness(c.k_p) + ", k_{v} = " + u.damping(c.k_v);
}

std::string demand_name(const std::string& name)
{
    return name == "margin" ? "margin" : name == "effort_limit" ? "peak effort" : "least stable velocity";
}

/// A margin as large as was looked for is at least that large.
std::string margin_text(double margin, const GainDesign& d)
{
    return (margin >= d.margin_reach ? "> " : "") + plain_number(margin, 3);
}

std::string demand_value(const DemandReport& d, double value, const DesignAnswer& a, const Units& u)
{
    if (d.name == "effort_limit") return u.effort(value);
    return d.name == "margin" ? margin_text(value, a.design) : u.velocity(value);
}

std::string infeasible_text(const DesignAnswer& a, const Units& u)
{
    if (!std::isfinite(std::log(a.design.best.cost)) && a.design.best.margin > 0)
        return "No gains: the noise to be made least is no finite number above zero, with any gains of the range "
               "(position noise " +
               u.position(a.requirements.noise.position) + ", sample time " +
               with_unit(a.requirements.noise.period, Quantity::time, u.motion) + ").";
    std::string text = "No gains within the range meet every demand.";
    if (a.requirements.effort_limit <= a.design.steady_effort)
        text += " Steady sliding alone takes " + u.effort(a.design.steady_effort) + ".";
    for (const auto& d : a.design.demands) {
        if (d.met) continue;
        std::string others;
        for (const auto& o : a.design.demands)
            if (o.name != d.name) others += (others.empty() ? "" : " and ") + demand_name(o.name);
        if (d.others_met)
            text += (others.empty() ? " The " : " With " + others + " as demanded, the ") + demand_name(d.name) +
                    " can be " + demand_value(d, d.attainable, a, u) +
                    " (demanded: " + demand_value(d, d.demanded, a, u) + ").";
        else
            text += " No gains give " + others + " as demanded, whatever the " + demand_name(d.name) + ".";
    }
    return text + " Nearest to feasible: " + gains_text(a.design.best, u) + ".";
}

std::string cost_of_simple_thinking(const DesignAnswer& a, const Units& u)
{
    const auto& d = a.design;
    if (!d.velocity_only_found) return "Velocity-only thinking finds no gains that meet the demands.";
    const auto& v = d.velocity_only;
    std::string text = "Velocity-only thinking chooses " + gains_text(v, u);
    if (v.margin < 0) return text + ", which in truth stick-slips.";
    const bool motion = a.requirements.objective == DesignObjective::motion;
    const double ratio = motion ? v.motion_noise / d.best.motion_noise : v.effort_noise / d.best.effort_noise;
    return text + ": " + plain_number(ratio) + " times the " + (motion ? "motion" : "effort") + " noise.";
}

/// An optimum at the end of what was searched is one of the search.
std::vector<std::string> ends_of_range(const DesignAnswer& a, const Units& u)
{
    constexpr double touching = 1e-3;  // relative
    std::vector<std::string> texts;
    const auto at = [](double value, double end) { return std::abs(value - end) <= touching * std::abs(end); };
    const auto check = [&](const char* symbol, double best, const Interval& range, auto words) {
        if (range.low > 0 && at(best, range.low))
            texts.push_back(std::string("The best ") + symbol + " is the least that was searched, " + words(range.low) +
                            ": a smaller one may be better. Lower the range.");
        if (at(best, range.high))
            texts.push_back(std::string("The best ") + symbol + " is the greatest that was searched, " +
                            words(range.high) + ": a greater one may be better. Raise the range.");
    };
    check("k_{p}", a.design.best.k_p, a.range.k_p, [&](double v) { return u.stiffness(v); });
    check("k_{v}", a.design.best.k_v, a.range.k_v, [&](double v) { return u.damping(v); });
    return texts;
}

/// Of the numbers in which its margin is measured.
std::vector<double> scales_of(const DesignAnswer& a)
{
    std::vector<double> scales;
    for (const auto& c : a.requirements.uncertain.empty() ? friction_coordinates(a.joint) : a.requirements.uncertain)
        scales.push_back(c.scale);
    return scales;
}

std::vector<std::string> row_of(const char* name, const GainChoice& c, const GainDesign& d, const Units& u)
{
    return {name,
            u.stiffness(c.k_p),
            u.damping(c.k_v),
            c.margin < 0 ? "unstable" : u.position(c.motion_noise),
            u.effort(c.effort_noise),
            u.effort(c.peak_effort),
            margin_text(c.margin, d),
            c.margin < 0 ? "–" : u.velocity(c.least_velocity)};
}

nlohmann::ordered_json number(double value)
{
    return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

nlohmann::ordered_json choice_json(const GainChoice& c)
{
    return {{"k_p", number(c.k_p)},
            {"k_v", number(c.k_v)},
            {"motion_noise", number(c.motion_noise)},
            {"effort_noise", number(c.effort_noise)},
            {"peak_effort", number(c.peak_effort)},
            {"margin", number(c.margin)},
            {"least_velocity", number(c.least_velocity)},
            {"cost", number(c.cost)}};
}

}  // namespace

std::string design_verdict(const DesignAnswer& a)
{
    const Units u{a.joint.mechanism.motion};
    const auto& d = a.design;
    if (!d.decided) return "No design: the joint has no steady sliding to be kept stable.";
    if (!d.feasible) return infeasible_text(a, u);
    std::string text = "Best gains: " + gains_text(d.best, u) + ". Sensor noise moves the link by " +
                       u.position(d.best.motion_noise) + " rms and the actuator by " + u.effort(d.best.effort_noise) +
                       " rms. ";
    return text + nearest_text(a.nearest, a.joint.mechanism.motion) + " " + cost_of_simple_thinking(a, u);
}

std::string design_text(const DesignAnswer& a)
{
    std::string text = design_verdict(a);
    if (a.design.decided && a.design.feasible)
        for (const auto& end : ends_of_range(a, Units{a.joint.mechanism.motion}))
            text += " On the search limit: " + end;
    return text;
}

std::vector<Table> design_tables(const DesignAnswer& a)
{
    const Units u{a.joint.mechanism.motion};
    const auto& d = a.design;
    if (!d.decided) return {};
    Table choices;
    choices.title = "Choices, all judged with memory";
    choices.columns = {"gains",       "k_{p}",  "k_{v}",         "motion noise, rms", "effort noise, rms",
                       "peak effort", "margin", "stable down to"};
    choices.rows = {row_of(d.feasible ? "best" : "nearest to feasible", d.best, d, u),
                    row_of("velocity-only thinking", d.velocity_only, d, u),
                    row_of("as in the joint", d.as_joint, d, u)};
    Table demands;
    demands.title = "Demands";
    demands.columns = {"demand", "asked", "reached", "attainable, others kept", "outcome"};
    for (const auto& r : d.demands)
        demands.rows.push_back(
            {demand_name(r.name), demand_value(r, r.demanded, a, u), demand_value(r, r.reached, a, u),
             demand_value(r, r.attainable, a, u) + (r.others_met ? "" : " (alone)"), r.met ? "met" : "not met"});
    return {choices, demands};
}

namespace {

/// How the joint slides after the same disturbance, with the gains as given and with the best ones.
Section map_section(const DesignAnswer& a)
{
    const Units u{a.joint.mechanism.motion};
    Figure figure = map_figure(a.joint.mechanism.motion, a.map->slice, a.map->answer);
    figure.caption +=
        " The cross is the best choice; the joint's own gains are k_{p} = " + u.stiffness(a.joint.control.k_p) +
        ", k_{v} = " + u.damping(a.joint.control.k_v) + ".";
    return {"map", "Where the gains lie", "", {std::move(figure)}, {}};
}

Section motion_section(const DesignAnswer& a)
{
    const Motion motion = a.joint.mechanism.motion;
    const auto off = [](const Trajectory& t) {
        std::vector<double> excess;
        for (const double v : t.velocity) excess.push_back(v - t.commanded_velocity);
        return excess;
    };
    LineChart chart;
    chart.title = "Velocity after a small disturbance at V_{0} = " +
                  with_unit(a.motion.commanded_velocity, Quantity::velocity, motion);
    chart.x_label = "time t [s]";
    chart.y_label = "velocity off V_{0} [" + std::string(unit_of(Quantity::velocity, motion)) + "]";
    if (!a.motion_before.time.empty())
        chart.lines.push_back({"gains as in the joint", a.motion_before.time, off(a.motion_before), true});
    chart.lines.push_back({"best gains", a.motion.time, off(a.motion)});
    Figure figure;
    figure.id = "motion";
    figure.caption = "Simulated from the disturbance that simulate takes by default; one motion is one example.";
    figure.finding = chart.title;
    figure.picture = std::move(chart);
    return {"motion-section", "How it moves", "", {std::move(figure)}, {}};
}

}  // namespace

// In one piece: a page from top to bottom: its sections in their order.
Report design_report(const DesignAnswer& a, std::vector<Snippet> snippets)
{
    const Units u{a.joint.mechanism.motion};
    const auto& d = a.design;
    Report report;
    report.title = a.title.empty() ? "Gains for the joint" : a.title;
    report.subtitle = "design of gains";
    report.verdict = design_verdict(a);
    if (a.design.decided && a.design.feasible) name_symbols(report, a.nearest, a.joint.mechanism.motion);
    report.tone = d.feasible ? Tone::good : Tone::bad;
    report.snippets = std::move(snippets);
    if (d.feasible) {
        report.headlines.push_back({Tone::neutral, u.stiffness(d.best.k_p), "position gain k_{p}"});
        report.headlines.push_back({Tone::neutral, u.damping(d.best.k_v), "velocity gain k_{v}"});
        report.headlines.push_back({Tone::neutral, u.position(d.best.motion_noise), "rms motion from sensor noise"});
        for (const auto& r : d.demands)
            report.headlines.push_back(
                {r.met ? Tone::good : Tone::bad, demand_value(r, r.reached, a, u),
                 (r.name == "margin"
                      ? "margin: the " + std::to_string(scales_of(a).size()) + " uncertain parameters may be off by " +
                            all_at_once(r.reached, scales_of(a)) + " at once; required: at least "
                      : demand_name(r.name) + "; required: at most ") +
                     demand_value(r, r.demanded, a, u)});
    }
    for (const auto& text : ends_of_range(a, u)) report.alerts.push_back({Tone::warning, text});
    if (a.map) report.sections.push_back(map_section(a));
    Section front{"pareto", "Noise against margin", "", {}, {}};
    if (d.front.size() > 1) {
        const bool motion = a.requirements.objective == DesignObjective::motion;
        LineChart chart;
        chart.title = std::string("Least ") + (motion ? "motion" : "effort") + " noise for each margin";
        chart.x_label = "margin to the nearest boundary [1]";
        chart.y_label = motion ? "rms motion [" + std::string(unit_of(Quantity::position, u.motion)) + "]"
                               : "rms effort [" + std::string(unit_of(Quantity::effort, u.motion)) + "]";
        const auto noise = [&](const GainChoice& c) { return motion ? c.motion_noise : c.effort_noise; };
        LineChart::Line line{"least noise", {}, {}};
        for (const auto& c : d.front) line.x.push_back(c.margin), line.y.push_back(noise(c));
        chart.lines.push_back(std::move(line));
        chart.x_marks.emplace_back("demanded", a.requirements.margin);
        const auto compared = [&](const char* name, const GainChoice& c) {
            if (c.margin > 0 && std::isfinite(noise(c))) chart.lines.push_back({name, {c.margin}, {noise(c)}});
        };
        compared("best", d.best);
        if (d.velocity_only_found) compared("velocity-only thinking", d.velocity_only);
        compared("as in the joint", d.as_joint);
        double least = infinity, most = 0;
        for (const auto& l : chart.lines)
            for (const double y : l.y) least = std::min(least, y), most = std::max(most, y);
        chart.y_log = most > 10 * least;
        Figure figure;
        figure.id = "noise-against-margin";
        figure.caption =
            "Pareto front: no gains within the range are both quieter and further from the boundary, the other demands "
            "kept. Points: the choices of the table below" +
            std::string(d.velocity_only.margin >= d.margin_reach || d.as_joint.margin >= d.margin_reach
                            ? "; margins are looked for up to " + plain_number(d.margin_reach, 3) + "."
                            : ".");
        if (d.velocity_only_found && d.velocity_only.margin > 0)
            figure.caption += " Velocity-only thinking would choose " + gains_text(d.velocity_only, u) +
                              " with a noise of " +
                              (motion ? u.position(noise(d.velocity_only)) : u.effort(noise(d.velocity_only))) + ".";
        figure.finding = chart.title;
        figure.picture = std::move(chart);
        front.figures.push_back(std::move(figure));
        Table table;
        table.title = "The front";
        table.columns = {"margin", "k_{p}", "k_{v}", "motion noise, rms", "effort noise, rms"};
        for (const auto& c : d.front)
            table.rows.push_back({plain_number(c.margin), u.stiffness(c.k_p), u.damping(c.k_v),
                                  u.position(c.motion_noise), u.effort(c.effort_noise)});
        front.tables.push_back(std::move(table));
        report.sections.push_back(std::move(front));
    }
    if (!a.motion.time.empty()) report.sections.push_back(motion_section(a));
    Section choices{"choices", "Choices", "", {}, design_tables(a)};
    report.sections.push_back(std::move(choices));
    if (loop_kind(a.joint) == LoopKind::ideal)
        report.not_checked.push_back(
            "The joint file describes no sampling, dead time, filter or lag: a loop that has them allows other gains.");
    report.not_checked.push_back("Noise is white from sample to sample; the mechanism filters it linearly.");
    report.not_checked.push_back(
        "The range of gains is searched globally, then locally: an optimum narrower than the grid of the global search "
        "is not excluded.");
    report.provenance = {{"command", a.command}, {"pairs of gains judged", std::to_string(d.evaluations)}};
    return report;
}

nlohmann::ordered_json design_json(const DesignAnswer& a)
{
    const auto& d = a.design;
    nlohmann::ordered_json json = {{"format", "stickslip design 1"}, {"title", a.title}, {"feasible", d.feasible}};
    json["answer"] = plain_text(design_text(a));
    json["objective"] = a.requirements.objective == DesignObjective::motion ? "motion" : "effort";
    json["best"] = choice_json(d.best);
    json["nearest_boundary"] = nearest_json(a.nearest);
    json["demands"] = nlohmann::ordered_json::array();
    for (const auto& r : d.demands)
        json["demands"].push_back({{"name", r.name},
                                   {"demanded", number(r.demanded)},
                                   {"reached", number(r.reached)},
                                   {"attainable", number(r.attainable)},
                                   {"others_met", r.others_met},
                                   {"met", r.met}});
    json["front"] = nlohmann::ordered_json::array();
    for (const auto& c : d.front) json["front"].push_back(choice_json(c));
    json["velocity_only"] = choice_json(d.velocity_only);
    json["velocity_only"]["found"] = d.velocity_only_found;
    json["as_joint"] = choice_json(d.as_joint);
    json["evaluations"] = d.evaluations;
    return json;
}

}  // namespace stickslip
