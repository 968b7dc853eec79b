#include "sweep/report/pages/compare_report.h"

#include "analysis/joint/parameters.h"
#include "analysis/results/text.h"
#include "sweep/report/figures/compare_maps.h"
#include "sweep/report/pages/first_screen.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

using Tone = Headline::Tone;

/// "+3.2 %", "unchanged", "−".
std::string relative_change(double before, double after)
{
    if (before == after || (std::isnan(before) && std::isnan(after))) return "unchanged";
    if (!std::isfinite(before) || !std::isfinite(after) || before == 0) return "–";
    const double change = (after - before) / std::abs(before);
    if (std::abs(change) < 1e-9) return "< 10^{−9}";
    return (change < 0 ? "−" : "+") + plain_number(100 * std::abs(change)) + " %";
}

struct ComparedNumber {
    std::string name;
    double before, after;
    Quantity quantity;
};

/// A rate may change its sign, and a share of it would mislead: its difference is said.
std::string change_words(const ComparedNumber& n, Units units)
{
    if (n.quantity != Quantity::rate || n.before == n.after) return relative_change(n.before, n.after);
    return std::string(n.after > n.before ? "+" : "") + with_unit(n.after - n.before, n.quantity, units);
}

Table table_of(std::string title, const std::vector<ComparedNumber>& numbers, Units units)
{
    Table table;
    table.title = std::move(title);
    table.columns = {"quantity", "before", "after", "change"};
    for (const auto& n : numbers)
        table.rows.push_back({n.name, with_unit(n.before, n.quantity, units, 6),
                              with_unit(n.after, n.quantity, units, 6), change_words(n, units)});
    return table;
}

std::vector<ComparedNumber> design_numbers(const LinearVerdict& a, const LinearVerdict& b)
{
    return {{"commanded velocity V_{0}", a.steady.velocity, b.steady.velocity, Quantity::velocity},
            {"friction of steady sliding f_{ss}(V_{0})", a.steady.friction, b.steady.friction, Quantity::effort},
            {"least k_{v} of the velocity-only model", a.velocity_only.k_v_min, b.velocity_only.k_v_min,
             Quantity::velocity_gain},
            {"critical position gain k_{cr}", a.state_variable.k_cr, b.state_variable.k_cr, Quantity::position_gain},
            {"spectral abscissa max Re s", a.state_variable.spectral_abscissa, b.state_variable.spectral_abscissa,
             Quantity::rate}};
}

/// Numbers of the joints that differ, by path.
std::vector<ComparedNumber> changed_parameters(Joint a, Joint b)
{
    std::vector<ComparedNumber> changed;
    const auto after = parameters(b);
    for (const auto& p : parameters(a)) {
        const auto same = std::find_if(after.begin(), after.end(), [&](const auto& q) { return q.path == p.path; });
        const double then = *p.value, now = same == after.end() ? missing : *same->value;
        if (then == now || (std::isnan(then) && std::isnan(now))) continue;
        changed.push_back({p.path, then, now, p.quantity});
    }
    return changed;
}

std::vector<ComparedNumber> boundary_numbers(const SweepComparison& c)
{
    std::vector<ComparedNumber> numbers;
    const auto& axes = c.before.spec.axes;
    for (std::size_t i = 0; i < axes.size(); ++i) {
        const auto &then = c.was.margins[i], &now = c.is.margins[i];
        numbers.push_back({"nearest boundary along " + axes[i].name + " " + axes[i].symbol,
                           then.found ? then.boundary : missing, now.found ? now.boundary : missing, axes[i].quantity});
    }
    return numbers;
}

/// How well off a design is, the worst first: the tone of a comparison follows whether that rises or falls.
enum class Standing { rest, stick_slip, undecided, neutral, bistable, stable };

Standing standing(const ComparedDesign& design)
{
    switch (design.region) {
        case Region::stable:
        case Region::memory_only:
            return Standing::stable;
        case Region::bistable:
            return Standing::bistable;
        case Region::velocity_only:
        case Region::unstable:
            return design.rests ? Standing::rest : Standing::stick_slip;
        case Region::neutral:
            return Standing::neutral;
        case Region::undecided:
            break;
    }
    return Standing::undecided;
}

/// `simulated`: large disturbances were followed, too.
std::string verdict_words(Standing standing, bool simulated)
{
    switch (standing) {
        case Standing::stable:
            return simulated ? "stable" : "stable under small disturbances";
        case Standing::bistable:
            return "bistable (stable under small disturbances only)";
        case Standing::stick_slip:
            return "in stick-slip";
        case Standing::rest:
            return "at rest for good";
        case Standing::neutral:
            return "neutral (small disturbances neither decay nor grow)";
        case Standing::undecided:
            break;
    }
    return "undecided";
}

/// The largest relative move of a boundary that both runs have.
const ComparedNumber* largest_move(const std::vector<ComparedNumber>& numbers)
{
    const ComparedNumber* found = nullptr;
    const auto move = [](const ComparedNumber& n) { return std::abs(n.after / n.before - 1); };
    for (const auto& n : numbers)
        if (std::isfinite(move(n)) && (!found || move(n) > move(*found))) found = &n;
    return found;
}

bool nothing_changed(const std::vector<ComparedNumber>& numbers)
{
    return std::all_of(numbers.begin(), numbers.end(), [](const ComparedNumber& n) {
        return n.before == n.after || (std::isnan(n.before) && std::isnan(n.after));
    });
}

void add_verdict(Report& report, Standing was, Standing is, bool nothing, bool simulated)
{
    report.verdict = nothing     ? "No change: boundaries, regions and numbers are equal."
                     : was != is ? "The design was " + verdict_words(was, simulated) + " and is " +
                                       verdict_words(is, simulated) + " now."
                                 : "The design is " + verdict_words(is, simulated) + ", as before.";
    report.tone = nothing || is == Standing::stable ? Tone::good
                  : is < was                        ? Tone::bad
                  : was == is                       ? Tone::neutral
                                                    : Tone::warning;
}

}  // namespace

Report compare_report(const SweepComparison& c)
{
    const auto &before = c.before, &after = c.after;
    const Joint &a = c.was.joint, &b = c.is.joint;
    const Units units = units_of(b);
    const auto boundaries = boundary_numbers(c);
    const auto numbers = design_numbers(c.was.verdict, c.is.verdict);

    Report report;
    report.title = "What changed";
    report.subtitle = "before: " + before.name + " · after: " + after.name;
    const bool same_maps = c.comparable && c.maps.empty();
    Section maps{"maps", "Maps of the difference", "", {}, {}};
    std::array<double, changes> shares{};
    const bool charts = c.comparable && !before.summary.slices.empty() && !after.summary.slices.empty();
    if (charts) shares = change_shares(before.summary.slices[0], after.summary.slices[0]);
    for (const auto& map : c.maps)
        for (auto& figure : change_figures(c, map)) maps.figures.push_back(std::move(figure));

    const bool simulated = before.spec.nonlinear.enabled && after.spec.nonlinear.enabled;
    const bool nothing = same_maps && nothing_changed(numbers) && nothing_changed(boundaries);
    add_verdict(report, standing(c.was), standing(c.is), nothing, simulated);
    if (const auto* moved = largest_move(boundaries); moved && moved->before != moved->after) {
        report.verdict += " The " + moved->name + " moved by " + relative_change(moved->before, moved->after) +
                          ", to " + with_unit(moved->after, moved->quantity, units, 4) + ".";
        report.headlines.push_back({Tone::neutral, relative_change(moved->before, moved->after),
                                    "largest move of a boundary: " + moved->name + ", " +
                                        range_text(moved->before, moved->after, moved->quantity, units, from_to, 4)});
    }
    if (c.comparable && !before.summary.slices.empty()) {
        const auto share = [&](Change change) { return shares[static_cast<std::size_t>(change)]; };
        report.headlines.push_back({share(Change::became_smooth) > 0 ? Tone::good : Tone::neutral,
                                    percent(share(Change::became_smooth)), "of the first chart became smooth"});
        report.headlines.push_back({share(Change::became_stick_slip) > 0 ? Tone::bad : Tone::neutral,
                                    percent(share(Change::became_stick_slip)), "of the first chart became stick-slip"});
    }
    if (!c.comparable)
        report.alerts.push_back(
            {Tone::warning, "The two sweeps have different axes: only their designs are compared."});
    if (!maps.figures.empty()) report.sections.push_back(std::move(maps));

    Section tables{"numbers", "Values of the design", "", {}, {}};
    tables.tables.push_back(table_of("Linear theory at the design point", numbers, units));
    if (!boundaries.empty()) tables.tables.push_back(table_of("Nearest boundaries", boundaries, units));
    if (const auto changed = changed_parameters(a, b); !changed.empty())
        tables.tables.push_back(table_of("What differs between the two joints", changed, units));
    report.sections.push_back(std::move(tables));
    report.not_checked = {"Whether a change matters: set a tolerance with stickslip check.",
                          "Changes between the points of the grid that no located boundary shows."};
    if (!simulated)
        report.not_checked.push_back(
            "Large disturbances: at least one of the runs was judged by the linear theory alone.");
    for (const auto* run : {&before, &after})
        for (const auto& [name, value] : run->summary.provenance)
            report.provenance.emplace_back((run == &before ? "before, " : "after, ") + name, value);
    return report;
}

}  // namespace stickslip
