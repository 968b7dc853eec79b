#include "sweep/report/diagnosis_report.h"

#include "analysis/stability/verdict.h"

#include <fmt/format.h>

#include <cmath>

namespace stickslip {
namespace {

std::string together(const std::vector<std::string>& names)
{
    return fmt::format("{}", fmt::join(names, " with "));
}

std::string percent(double part)
{
    return std::isfinite(part) ? fmt::format("{:.0f} %", 100 * part) : "–";
}
std::string number(double value)
{
    return std::isfinite(value) ? fmt::format("{:.4g}", value) : "–";
}

const Share* largest(const std::vector<Share>& shares)
{
    const Share* best = nullptr;
    for (const auto& s : shares)
        if (!best || s.share > best->share) best = &s;
    return best;
}

Table causes_table(const Diagnosis& d)
{
    Table t{
        "Causes, most probable first",
        {"cause", "form", "probability", "held-out gain", "its tell-tale is there", "plausible", "misfit (0 is noise)"},
        {}};
    for (const auto& c : d.effects)
        t.rows.push_back({together(c.names), c.form.empty() ? "–" : c.form, fmt::format("{:.3f}", c.probability),
                          c.heldout_gain != 0
                              ? fmt::format("{} ({} … {})", percent(c.heldout_gain),
                                            percent(c.heldout_gain_interval.low), percent(c.heldout_gain_interval.high))
                              : "not held out",
                          c.signature ? "yes" : "no", c.plausible ? "yes" : "no", number(c.misfit)});
    return t;
}

Table parameters_table(const Diagnosis& d)
{
    Table t{"Parameters of the named cause", {"parameter", "value", "standard error", "unit"}, {}};
    if (!d.effects.empty())
        for (const auto& p : d.effects[0].parameters)
            t.rows.push_back({p.name, number(p.value), number(p.standard_error), p.unit});
    return t;
}

Table shares_table(const char* title, const std::vector<Share>& shares)
{
    Table t{title, {"where", "share of the gap", "95 % interval", "RMS", "noise floor", "unit"}, {}};
    for (const auto& s : shares)
        t.rows.push_back({s.name, percent(s.share), percent(s.interval.low) + " … " + percent(s.interval.high),
                          number(s.rms), number(s.floor), s.unit});
    return t;
}

Table gap_table(const Diagnosis& d)
{
    Table t{"Measured against simulated, held-out data",
            {"signal", "before", "after", "noise floor", "explained", "unit"},
            {}};
    for (const auto& g : d.gap)
        t.rows.push_back({g.signal, number(g.before), number(g.after), number(g.floor), percent(g.explained), g.unit});
    t.rows.push_back({"overall", number(d.overall.before), number(d.overall.after), number(d.overall.floor),
                      percent(d.overall.explained), "floors"});
    return t;
}

Table boundary_table(const Diagnosis& d, const Joint& before, const Joint& after)
{
    Table t{"Stability boundary", {"", "nominal joint", "with the cause"}, {}};
    const auto verdict = [&](Joint joint) {
        if (!is_set(joint.control.V0) && !is_set(joint.control.force_rate)) joint.control.V0 = 0.1 * d.usual_speed;
        return linear_verdict(joint);
    };
    const auto one = verdict(before), two = verdict(after);
    const auto gain = [](double k) { return std::isfinite(k) ? number(k) : std::string("none"); };
    t.rows.push_back({"critical position gain k_{cr}", gain(one.state_variable.k_cr), gain(two.state_variable.k_cr)});
    t.rows.push_back({"least velocity gain (velocity-only theory)", number(one.velocity_only.k_v_min),
                      number(two.velocity_only.k_v_min)});
    t.rows.push_back({"spectral abscissa [1/s]", number(one.state_variable.spectral_abscissa),
                      number(two.state_variable.spectral_abscissa)});
    return t;
}

void add_traces(const Diagnosis& d, Section& section)
{
    const std::string position(unit_of(Quantity::position, d.motion)), effort(unit_of(Quantity::effort, d.motion));
    int n = 0;
    for (const auto& trace : d.traces) {
        const std::string id = "record-" + std::to_string(++n);
        const auto residual = [](const std::vector<double>& a, const std::vector<double>& b) {
            std::vector<double> r;
            for (std::size_t k = 0; k < a.size(); ++k) r.push_back(a[k] - b[k]);
            return r;
        };
        LineChart motion;
        motion.title = "What the simulation gets wrong in position: " + trace.file;
        motion.x_label = "time [s]";
        motion.y_label = "measured minus simulated [" + position + "]";
        motion.lines = {{"before", trace.time, residual(trace.measured, trace.before), true},
                        {"after", trace.time, residual(trace.measured, trace.after), false}};
        section.figures.push_back({id + "-position", motion,
                                   "Each curve is measured minus one noisy closed-loop simulation.",
                                   "Position residual over time before and after the cause is added"});
        if (trace.effort_measured.empty()) continue;
        LineChart force;
        force.title = "Effort: " + trace.file;
        force.x_label = "time [s]";
        force.y_label = "effort [" + effort + "]";
        force.lines = {{"measured", trace.time, trace.effort_measured, false},
                       {"simulated before", trace.time, trace.effort_before, true},
                       {"simulated after", trace.time, trace.effort_after, true}};
        section.figures.push_back({id + "-effort", force,
                                   "Measured effort, or the command where no effort was measured.",
                                   "Effort over time, measured and simulated before and after"});
        constexpr int most_records = 3;
        if (n >= most_records) break;
    }
}

}  // namespace

std::string diagnosis_sentence(const Diagnosis& d)
{
    switch (d.verdict) {
        case Verdict::gap: {
            std::string text = fmt::format("The gap comes from {}", together(d.effects[0].names));
            if (d.overall.before > 0)
                text += fmt::format(": on held-out data it shrinks from {:.2f} to {:.2f} noise floors",
                                    d.overall.before, d.overall.after);
            if (!d.ambiguous_with.empty()) {
                text += "; these records cannot tell it from ";
                for (std::size_t i = 0; i < d.ambiguous_with.size(); ++i)
                    text += (i ? ", " : "") + together(d.ambiguous_with[i]);
            }
            return text + ".";
        }
        case Verdict::no_gap:
            return "No gap: the nominal joint predicts the records to the noise.";
        case Verdict::unknown:
            return "There is a gap, and nothing in the catalogue explains it.";
        default:
            return "These records do not hold enough to conclude anything.";
    }
}

Report diagnosis_report(const Diagnosis& d, const Joint& before, const Joint& after,
                        std::vector<std::pair<std::string, std::string>> provenance)
{
    Report r;
    r.title = "Sim-to-real gap of one joint";
    r.subtitle = fmt::format("{} record(s), every effect of the catalogue fitted", d.records.size());
    r.verdict = diagnosis_sentence(d);
    r.tone = d.verdict == Verdict::no_gap ? Headline::Tone::good
             : d.verdict == Verdict::gap  ? Headline::Tone::warning
                                          : Headline::Tone::bad;
    if (!d.effects.empty() && d.verdict == Verdict::gap) {
        r.headlines.push_back({Headline::Tone::warning, together(d.effects[0].names), "what: the most probable cause"});
        r.headlines.push_back(
            {Headline::Tone::neutral, percent(d.effects[0].probability), "how sure: its probability"});
    }
    if (const Share* s = largest(d.signals))
        r.headlines.push_back(
            {Headline::Tone::neutral, s->name, "where: the stage that holds " + percent(s->share) + " of the gap"});
    if (d.overall.before > 0)
        r.headlines.push_back({Headline::Tone::neutral,
                               fmt::format("{:.2f} → {:.2f}", d.overall.before, d.overall.after),
                               "how much: held-out gap in noise floors, before → after"});
    for (const auto& reason : d.reasons) r.alerts.push_back({Headline::Tone::warning, reason});

    Section where{"where",
                  "Where the gap lies",
                  "Each stage is fed with the measured signals before it; shares of efforts.",
                  {},
                  {}};
    where.tables = {shares_table("By stage of the chain", d.signals),
                    shares_table("By regime of the motion", d.regimes)};
    Section what{"what", "What causes it", "", {}, {causes_table(d), parameters_table(d)}};
    for (const auto& c : d.effects) {
        if (d.verdict != Verdict::gap) break;
        what.text = "Tell-tale: " + c.tell_tale + ".";
        break;
    }
    Section much{
        "how-much", "How far it shrinks", "Every number is from data that the fit has not seen.", {}, {gap_table(d)}};
    add_traces(d, much);
    Section next{"next",
                 "What to measure next",
                 d.next_experiment.description.empty() ? "Nothing is left to tell apart." : "",
                 {},
                 {}};
    if (!d.next_experiment.description.empty()) {
        next.text = fmt::format("Move along {}: there {} and {} differ by {:.1f} noise standard deviations.",
                                d.next_experiment.description, d.next_experiment.separates[0].first,
                                d.next_experiment.separates[0].second, d.next_experiment.distance);
        LineChart motion;
        motion.title = "Next experiment";
        motion.x_label = "time [s]";
        motion.y_label = "reference [" + std::string(unit_of(Quantity::position, d.motion)) + "]";
        motion.lines = {{"reference", d.next_experiment.time, d.next_experiment.reference, false}};
        next.figures.push_back({"next-experiment", motion, "The reference is beside the page as next-experiment.csv.",
                                "Reference of the next experiment over time"});
    }
    Section boundary{"boundary",
                     "What it does to the stability map",
                     "Friction, inertia and gains move the boundary; delays and sampling are not in this theory.",
                     {},
                     {}};
    boundary.tables.push_back(boundary_table(d, before, after));
    r.sections = {where, what, much, next, boundary};
    r.not_checked = d.notes;
    r.provenance = std::move(provenance);
    return r;
}

}  // namespace stickslip
