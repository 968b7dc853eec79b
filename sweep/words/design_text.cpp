#include "sweep/words/design_text.h"

#include "sweep/words/least_velocity_text.h"

#include "analysis/stability/steady.h"
#include "sweep/words/loop_text.h"
#include "sweep/words/low_limit_text.h"
#include "sweep/words/nearest_text.h"
#include "sweep/words/reason_text.h"

#include <cmath>

namespace stickslip {

std::string gains_text(const GainChoice& c, const DesignUnits& u)
{
    return "k_{p} = " + u.stiffness(c.k_p) + ", k_{v} = " + u.damping(c.k_v);
}

std::string requirement_name(const std::string& name)
{
    return name == "margin" ? "margin" : name == "effort_limit" ? "peak effort" : "least stable velocity";
}

std::string margin_text(double margin, const GainDesign& d)
{
    return (margin >= d.margin_reach ? "> " : "") + plain_number(margin, 3);
}

std::string requirement_value(const RequirementReport& d, double value, const DesignAnswer& a, const DesignUnits& u)
{
    if (d.name == "effort_limit") return u.effort(value);
    return d.name == "margin" ? margin_text(value, a.design) : u.velocity(value);
}

std::vector<std::string> ends_of_range(const DesignAnswer& a, const DesignUnits& u)
{
    constexpr double touching = 1e-3;  // relative
    std::vector<std::string> texts;
    const auto at = [](double value, double end) { return std::abs(value - end) <= touching * std::abs(end); };
    const auto check = [&](const char* symbol, double best, const Interval& range, auto words) {
        if (range.low > 0 && at(best, range.low))
            texts.push_back(std::string("The best ") + symbol + " lies at the lower limit of the search, " +
                            words(range.low) + ": a smaller one may be better. Lower the range.");
        if (at(best, range.high))
            texts.push_back(std::string("The best ") + symbol + " lies at the upper limit of the search, " +
                            words(range.high) + ": a greater one may be better. Raise the range.");
    };
    check("k_{p}", a.design.best.k_p, a.range.k_p, [&](double v) { return u.stiffness(v); });
    check("k_{v}", a.design.best.k_v, a.range.k_v, [&](double v) { return u.damping(v); });
    return texts;
}

namespace {

std::string infeasible_text(const DesignAnswer& a, const DesignUnits& u)
{
    if (!std::isfinite(std::log(a.design.best.cost)) && a.design.best.margin > 0)
        return "No gains: the noise to be minimised is not a finite number above zero for any gains of the range "
               "(position noise " +
               u.position(a.requirements.noise.position) + ", sample time " +
               with_unit(a.requirements.noise.period, Quantity::time, u.units) + ").";
    std::string text = "No gains within the range meet every requirement.";
    if (a.requirements.effort_limit <= a.design.steady_effort)
        text += " Steady sliding alone takes " + u.effort(a.design.steady_effort) + ".";
    for (const auto& d : a.design.requirements) {
        if (d.met) continue;
        std::string others;
        for (const auto& o : a.design.requirements)
            if (o.name != d.name) others += (others.empty() ? "" : " and ") + requirement_name(o.name);
        if (d.others_met)
            text += (others.empty() ? " The " : " With " + others + " as required, the ") + requirement_name(d.name) +
                    " can be " + requirement_value(d, d.attainable, a, u) +
                    " (required: " + requirement_value(d, d.specified, a, u) + ").";
        else
            text += " No gains give " + others + " as required, for any " + requirement_name(d.name) + ".";
    }
    return text + " Nearest to feasible: " + gains_text(a.design.best, u) + ".";
}

std::string cost_of_simple_thinking(const DesignAnswer& a, const DesignUnits& u)
{
    const auto& d = a.design;
    if (!d.velocity_only_found) return "The velocity-only model finds no gains that meet the requirements.";
    const auto& v = d.velocity_only;
    std::string text = "The velocity-only model chooses " + gains_text(v, u);
    if (v.margin < 0) return text + ", which actually stick-slips.";
    const bool motion = a.requirements.objective == DesignObjective::motion;
    const double ratio = motion ? v.motion_noise / d.best.motion_noise : v.effort_noise / d.best.effort_noise;
    const std::string times = plain_number(ratio), noise = motion ? "motion" : "effort";
    return text + (times == plain_number(1) ? ", with as much " + noise + " noise."
                                            : ": " + times + " times the " + noise + " noise.");
}

std::vector<std::string> row_of(const char* name, const GainChoice& c, const DesignAnswer& a, const DesignUnits& u)
{
    const double lowest = lowest_velocity_searched(a.requirements, std::abs(sliding_velocity(a.joint)));
    return {name,
            u.stiffness(c.k_p),
            u.damping(c.k_v),
            c.margin < 0 ? "unstable" : u.position(c.motion_noise),
            u.effort(c.effort_noise),
            u.effort(c.peak_effort),
            u.position(c.steady_deflection),
            margin_text(c.margin, a.design),
            c.margin < 0 ? "–" : least_velocity_text(c.least_velocity, lowest, u.units)};
}

}  // namespace

std::string stage_text(DesignStage stage)
{
    switch (stage) {
        case DesignStage::best:
            return "the best gains under all requirements";
        case DesignStage::requirements:
            return "what each requirement can reach";
        case DesignStage::front:
            return "the Pareto front";
        case DesignStage::velocity_only:
            return "the choice of the velocity-only model";
    }
    return "unknown";
}

std::string design_verdict_text(const DesignAnswer& a)
{
    const DesignUnits u{units_of(a.joint)};
    const auto& d = a.design;
    if (!d.decided && !is_set(sliding_velocity(a.joint))) return "No design: " + reason_text(Reason::no_velocity) + ".";
    if (!d.decided)
        return low_limit(a.joint, sliding_velocity(a.joint)) ? "No design. " + low_limit_text(a.joint)
                                                             : "No design: the joint has no steady sliding.";
    if (!d.feasible) return infeasible_text(a, u) + loop_text(a.loop);
    std::string text = "Best gains: " + gains_text(d.best, u) + ". Steady sliding stays " +
                       u.position(std::abs(d.best.steady_deflection)) +
                       " behind the reference. Sensor noise moves the link by " + u.position(d.best.motion_noise) +
                       " rms and the actuator by " + u.effort(d.best.effort_noise) + " rms. ";
    return text + nearest_text(a.nearest, units_of(a.joint)) + " " + cost_of_simple_thinking(a, u) + loop_text(a.loop);
}

std::string design_text(const DesignAnswer& a)
{
    std::string text = design_verdict_text(a);
    if (a.design.decided && a.design.feasible)
        for (const auto& end : ends_of_range(a, DesignUnits{units_of(a.joint)})) text += " " + end;
    return text;
}

Table front_table(const DesignAnswer& a)
{
    const DesignUnits u{units_of(a.joint)};
    Table table{"Pareto front", {"margin", "k_{p}", "k_{v}", "motion noise, rms", "effort noise, rms"}, {}};
    for (const auto& c : a.design.front)
        table.rows.push_back({plain_number(c.margin), u.stiffness(c.k_p), u.damping(c.k_v), u.position(c.motion_noise),
                              u.effort(c.effort_noise)});
    return table;
}

std::vector<Table> design_tables(const DesignAnswer& a)
{
    const DesignUnits u{units_of(a.joint)};
    const auto& d = a.design;
    if (!d.decided) return {};
    Table choices;
    choices.title = "Choices, all evaluated with memory";
    choices.columns = {"gains",
                       "k_{p}",
                       "k_{v}",
                       "motion noise, rms",
                       "effort noise, rms",
                       "peak effort",
                       "steady deflection",
                       "margin",
                       "stable down to"};
    choices.rows = {row_of(d.feasible ? "best" : "nearest to feasible", d.best, a, u),
                    row_of("velocity-only model", d.velocity_only, a, u), row_of("as in the joint", d.as_joint, a, u)};
    Table requirements;
    requirements.title = "Requirements";
    requirements.columns = {"requirement", "specified", "achieved", "attainable, others kept", "outcome"};
    for (const auto& r : d.requirements)
        requirements.rows.push_back(
            {requirement_name(r.name), requirement_value(r, r.specified, a, u), requirement_value(r, r.achieved, a, u),
             requirement_value(r, r.attainable, a, u) + (r.others_met ? "" : " (alone)"), r.met ? "met" : "not met"});
    return {choices, requirements};
}

}  // namespace stickslip
