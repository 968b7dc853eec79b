#include "sweep/report/outcome_report.h"

#include "analysis/gap/outcomes/side.h"
#include "analysis/joint/parameters.h"
#include "analysis/results/text.h"
#include "analysis/stability/verdict.h"
#include "sweep/report/line_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace stickslip {
namespace {

using gap::LawFit;
using gap::OutcomeAnswer;
using Tone = Headline::Tone;

const char* const k_p_path = "control.k_p";
const char* const v0_path = "control.V0";

std::string key_of(const std::string& path)
{
    return path.substr(path.rfind('.') + 1);
}

/// A line's pieces, NaN between them.
void add_piece(FieldMap::Line& line, std::initializer_list<std::pair<double, double>> points)
{
    for (const auto& [x, y] : points) line.x.push_back(x), line.y.push_back(y);
    line.x.push_back(not_set), line.y.push_back(not_set);
}

/// Where a law changes side along the stiffness, neighbours joined while they are as many.
FieldMap::Line boundary_line(const Joint& at, const LawFit& fit, const std::vector<double>& velocities,
                             const std::vector<double>& stiffnesses, std::string name, bool dashed)
{
    FieldMap::Line line{std::move(name), {}, {}, dashed};
    const auto side = [&](double V, double k) {
        Joint joint = fit.rival ? gap::with_law(at, fit.law) : at;
        joint.control.V0 = V, joint.control.k_p = k;
        return gap::distance_to_stick_slip(joint);
    };
    std::vector<double> before;
    double V_before = 0;
    for (const double V : velocities) {
        std::vector<double> crossings;
        double last = side(V, stiffnesses.front());
        for (std::size_t i = 1; i < stiffnesses.size(); ++i) {
            const double here = side(V, stiffnesses[i]);
            if ((last > 0) != (here > 0)) {
                double low = stiffnesses[i - 1], high = stiffnesses[i];
                constexpr int halvings = 10;
                for (int n = 0; n < halvings; ++n) {
                    const double middle = std::sqrt(low * high);
                    ((side(V, middle) > 0) == (last > 0) ? low : high) = middle;
                }
                crossings.push_back(std::sqrt(low * high));
            }
            last = here;
        }
        if (crossings.size() == before.size())
            for (std::size_t i = 0; i < crossings.size(); ++i)
                add_piece(line, {{V_before, before[i]}, {V, crossings[i]}});
        before = crossings, V_before = V;
    }
    return line;
}

/// The rows with one k_v on a chart of velocity and stiffness, with the boundary of every law that is in the running.
Figure map_of(const OutcomeAnswer& a, const Joint& nominal, double k_v, int number)
{
    const auto motion = nominal.mechanism.motion;
    const auto& o = a.outcomes;
    double low_V = infinity, high_V = 0, low_k = infinity, high_k = 0;
    for (const auto& j : o.joints) {
        low_V = std::min(low_V, j.control.V0), high_V = std::max(high_V, j.control.V0);
        low_k = std::min(low_k, j.control.k_p), high_k = std::max(high_k, j.control.k_p);
    }
    constexpr double room = 1.6;
    constexpr int nodes = 41;
    FieldMap map;
    map.title = "Measured rows and the boundary of each law";
    map.fixed = "k_{v} = " + with_unit(k_v, Quantity::damping, motion);
    map.motion = motion;
    map.x = {v0_path,
             "V_{0}",
             "commanded velocity",
             Quantity::velocity,
             true,
             log_steps(low_V / room, high_V * room, nodes)};
    map.y = {
        k_p_path, "k_{p}", "position gain", Quantity::stiffness, true, log_steps(low_k / room, high_k * room, nodes)};
    const LawFit& best = a.laws.front();
    Joint at = nominal;
    at.control.k_v = k_v;
    at.control.force_rate = not_set;
    map.classes = {std::string(best.rival->law) + ": slides", std::string(best.rival->law) + ": sticks and slips"};
    for (const double k : map.y.values)
        for (const double V : map.x.values) {
            Joint joint = gap::with_law(at, best.law);
            joint.control.k_p = k, joint.control.V0 = V;
            map.values.push_back(gap::distance_to_stick_slip(joint) > 0 ? 1 : 0);
        }
    FieldMap::Line sticks{"measured: stick-slip (×)", {}, {}, false}, slides{"measured: slides (◇)", {}, {}, false};
    const double dx = std::pow(map.x.values.back() / map.x.values.front(), 0.009);
    const double dy = std::pow(map.y.values.back() / map.y.values.front(), 0.013);
    int rows = 0;
    for (std::size_t i = 0; i < o.size(); ++i) {
        const auto& c = o.joints[i].control;
        if (c.k_v != k_v) continue;
        ++rows;
        const double x = c.V0, y = c.k_p;
        if (o.table.rows[i].stick_slip) {
            add_piece(sticks, {{x / dx, y / dy}, {x * dx, y * dy}});
            add_piece(sticks, {{x / dx, y * dy}, {x * dx, y / dy}});
        } else {
            add_piece(slides, {{x, y / dy}, {x * dx, y}, {x, y * dy}, {x / dx, y}, {x, y / dy}});
        }
    }
    map.lines = {sticks, slides};
    map.lines.push_back(
        boundary_line(at, best, map.x.values, map.y.values, "boundary: " + std::string(best.rival->law), false));
    const auto rival = std::find_if(a.laws.begin() + 1, a.laws.end(),
                                    [&](const auto& f) { return f.rival->memory != best.rival->memory; });
    if (rival != a.laws.end())
        map.lines.push_back(
            boundary_line(at, *rival, map.x.values, map.y.values, "boundary: " + std::string(rival->rival->law), true));
    map.statement = fmt::format("{} rows; {} misjudges {} of all {} when it has not seen them.", rows, best.rival->law,
                                best.misjudged, o.size());
    Figure figure;
    figure.id = "rows-" + std::to_string(number);
    figure.caption =
        "Crosses stuck and slipped, diamonds slid. Shaded: what the best law says. Solid: its boundary; dashed: that "
        "of the best law of the other kind" +
        (rival != a.laws.end() ? std::string(" (") + std::string(rival->rival->law) + ")." : std::string("."));
    figure.finding = map.statement;
    figure.picture = std::move(map);
    return figure;
}

Table laws_table(const OutcomeAnswer& a)
{
    Table t{"Friction laws, most probable first",
            {"law", "effect", "probability", "rows misjudged, held out", "log-likelihood, held out", "of amplitudes",
             "width of the boundary"},
            {}};
    const auto row = [&](const LawFit& f, const std::string& name, const std::string& effect, const std::string& p) {
        t.rows.push_back({name, effect, p, fmt::format("{} of {}", f.misjudged, a.outcomes.size()),
                          fmt::format("{:.1f}", f.held_out),
                          f.amplitude_held_out != 0 ? fmt::format("{:.1f}", f.amplitude_held_out) : "–",
                          percent(f.softness)});
    };
    for (const auto& f : a.laws)
        row(f, std::string(f.rival->law), std::string(f.rival->effect), fmt::format("{:.3f}", f.posterior));
    row(a.nominal, "the nominal joint, not fitted", "–", "–");
    return t;
}

Table numbers_table(const OutcomeAnswer& a)
{
    Table t{"Numbers of the best law", {"number", "value", "standard error", "unit"}, {}};
    const LawFit& f = a.laws.front();
    for (std::size_t i = 0; i < f.values.size(); ++i) {
        const bool determined = f.standard_error[i] < 2 * std::abs(f.values[i]);
        t.rows.push_back({std::string(f.rival->numbers[i].name), fmt::format("{:.4g}", f.values[i]),
                          determined ? fmt::format("{:.2g}", f.standard_error[i]) : "not determined by these rows",
                          std::string(unit_of(f.rival->numbers[i].quantity, a.diagnosis.motion))});
    }
    return t;
}

Table rows_table(const OutcomeAnswer& a)
{
    Table t{"Every row", {"line"}, {}};
    for (const auto& path : a.outcomes.table.paths) t.columns.push_back(key_of(path));
    for (const char* c :
         {"measured", "amplitude", "probability of stick-slip", "amplitude by the law", "nominal joint says"})
        t.columns.emplace_back(c);
    const LawFit& best = a.laws.front();
    const auto number = [](double v) { return std::isfinite(v) ? fmt::format("{:.4g}", v) : std::string("–"); };
    for (std::size_t i = 0; i < a.outcomes.size(); ++i) {
        const auto& r = a.outcomes.table.rows[i];
        std::vector<std::string> cells{std::to_string(r.line)};
        for (double s : r.settings) cells.push_back(number(s));
        cells.insert(cells.end(), {r.stick_slip ? "stick-slip" : "slides", number(r.amplitude),
                                   fmt::format("{:.2f}", best.probability[i]), number(best.amplitude[i]),
                                   a.nominal.distance[i] > 0 ? "stick-slip" : "slides"});
        t.rows.push_back(std::move(cells));
    }
    return t;
}

Table boundary_table(const OutcomeAnswer& a, const Joint& nominal)
{
    Table t{"Critical position gain k_{cr} at the rows' usual velocity",
            {"", "nominal joint", "with the law that explains the rows"},
            {}};
    const auto gain = [&](Joint joint) {
        joint.control.V0 = a.diagnosis.usual_speed, joint.control.force_rate = not_set;
        const auto v = linear_verdict(joint).state_variable;
        if (std::isfinite(v.k_cr)) return with_unit(v.k_cr, Quantity::stiffness, a.diagnosis.motion);
        return std::string(v.stable ? "none: small disturbances always decay" : "none: they always grow");
    };
    t.rows.push_back({"V_{0} = " + with_unit(a.diagnosis.usual_speed, Quantity::velocity, a.diagnosis.motion),
                      gain(nominal), gain(a.after)});
    return t;
}

}  // namespace

std::string outcome_sentence(const OutcomeAnswer& a)
{
    const auto& d = a.diagnosis;
    const auto n = a.outcomes.size();
    switch (d.verdict) {
        case Verdict::gap: {
            const LawFit& best = a.laws.front();
            std::string text = fmt::format(
                "The measured boundary is that of {} friction (law {}): it misjudges {} of {} rows that it had not "
                "seen, the nominal joint {}",
                best.rival->effect, best.rival->law, best.misjudged, n, a.nominal.misjudged);
            std::vector<std::string> others;
            for (const auto& f : a.laws) {
                if (&f == &best) continue;
                for (const auto& names : d.ambiguous_with)
                    if (names[0] == f.rival->effect && f.total() > best.total() - 3) {
                        others.emplace_back(f.rival->law);
                        break;
                    }
            }
            if (!others.empty()) text += fmt::format("; these rows cannot tell it from {}", fmt::join(others, ", "));
            return text + ".";
        }
        case Verdict::no_gap:
            return fmt::format("No gap: the nominal joint explains the {} measured outcomes.", n);
        case Verdict::unknown:
            return "The nominal joint does not explain the measured outcomes, and no friction law does.";
        default:
            return "These rows do not decide which friction law is at work.";
    }
}

std::string next_outcome_text(const OutcomeAnswer& a)
{
    if (a.next.settings.empty() || a.diagnosis.next_experiment.separates.empty()) return "";
    const auto& [one, two] = a.diagnosis.next_experiment.separates[0];
    std::string place;
    Joint joint = a.after;
    for (std::size_t k = 0; k < a.next.settings.size(); ++k) {
        const auto& path = a.outcomes.table.paths[k];
        for (const auto& p : parameters(joint))
            if (p.path == path)
                place += (place.empty() ? "" : ", ") + key_of(path) + " = " +
                         with_unit(a.next.settings[k], p.quantity, a.diagnosis.motion);
    }
    return fmt::format("start from rest at {}: {} expects stick-slip with probability {:.2f}, {} with {:.2f}", place,
                       one, a.next.one, two, a.next.two);
}

Report outcome_report(const OutcomeAnswer& a, const Joint& nominal,
                      std::vector<std::pair<std::string, std::string>> provenance)
{
    const auto& d = a.diagnosis;
    Report r;
    r.title = "Which friction law explains the measured outcomes";
    r.subtitle = fmt::format("{} rows of {}", a.outcomes.size(), a.outcomes.table.name);
    r.verdict = outcome_sentence(a);
    r.tone = d.verdict == Verdict::no_gap ? Tone::good : d.verdict == Verdict::gap ? Tone::warning : Tone::bad;
    for (const auto& reason : d.reasons) r.alerts.push_back({Tone::warning, reason});
    r.not_checked = d.notes;
    r.not_checked.emplace_back(
        "laws left out: kernel (its numbers are a measured table), maxwell-slip (slides like coulomb-viscous), "
        "rate-and-state-regularised (equals rate-and-state away from rest)");
    r.not_checked.emplace_back(
        "laws with memory are fitted by their linear boundary; the motion from rest is followed for those near the "
        "best");
    r.provenance = std::move(provenance);
    if (a.laws.empty()) return r;
    const LawFit& best = a.laws.front();
    if (d.verdict == Verdict::gap) {
        r.headlines.push_back({Tone::warning, std::string(best.rival->law),
                               "what: the law that explains the rows (" + std::string(best.rival->effect) + ")"});
        r.headlines.push_back(
            {Tone::neutral, fmt::format("{:.0f} %", 100 * best.posterior), "how sure: its probability"});
    }
    r.headlines.push_back(
        {Tone::neutral, fmt::format("{} → {} of {}", a.nominal.misjudged, best.misjudged, a.outcomes.size()),
         "how much: rows misjudged by the nominal joint → by " + std::string(best.rival->law) + " where held out"});
    const Share* worst = nullptr;
    for (const auto& s : d.regimes)
        if (!worst || s.share > worst->share) worst = &s;
    if (worst)
        r.headlines.push_back(
            {Tone::neutral, worst->name,
             fmt::format("where: {:.0f} % of what the nominal joint gets wrong", 100 * worst->share)});

    Section map{"map", "The rows on the map", "", {}, {}};
    std::map<double, int> dampings;
    for (const auto& j : a.outcomes.joints) ++dampings[j.control.k_v];
    std::vector<std::pair<int, double>> fullest;
    for (const auto& [k_v, rows] : dampings) fullest.emplace_back(-rows, k_v);
    std::sort(fullest.begin(), fullest.end());
    constexpr std::size_t most_maps = 4;
    for (std::size_t i = 0; i < std::min(most_maps, fullest.size()); ++i)
        map.figures.push_back(map_of(a, nominal, fullest[i].second, static_cast<int>(i) + 1));
    if (fullest.size() > most_maps)
        map.text = fmt::format("The {} fullest of {} values of k_{{v}}.", most_maps, fullest.size());
    r.sections.push_back(std::move(map));

    Section what{"what",
                 "Which law",
                 d.effects.empty() ? "" : "Tell-tale of the best: " + d.effects[0].tell_tale + ".",
                 {},
                 {laws_table(a), numbers_table(a)}};
    Section where{"where", "Where the nominal joint is wrong", "", {}, {}};
    Table regimes{"By settings", {"where", "share of the gap", "95 % interval", "rows misjudged there"}, {}};
    for (const auto& s : d.regimes)
        regimes.rows.push_back(
            {s.name, percent(s.share), percent(s.interval.low) + " … " + percent(s.interval.high), percent(s.rms)});
    where.tables.push_back(std::move(regimes));
    const auto text = next_outcome_text(a);
    Section next{"next",
                 "What to measure next",
                 text.empty() ? "No setting near these rows tells the best laws of two kinds apart any better."
                              : "Next: " + text + ".",
                 {},
                 {}};
    r.sections.insert(r.sections.end(), {std::move(what), std::move(where), std::move(next)});
    r.sections.push_back({"boundary", "What it does to the stability map", "", {}, {boundary_table(a, nominal)}});
    r.sections.push_back({"rows", "The data behind it", "", {}, {rows_table(a)}});
    return r;
}

}  // namespace stickslip
