#include "sweep/report/pages/outcome_tables.h"

#include "analysis/results/text.h"
#include "sweep/words/diagnosis_tables.h"
#include "sweep/words/outcome_text.h"

#include <fmt/format.h>

#include <cmath>

namespace stickslip {

using gap::LawFit;
using gap::OutcomeAnswer;

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
    Table t{"Parameters of the best law", {"parameter", "value", "standard error", "unit"}, {}};
    const LawFit& f = a.laws.front();
    for (std::size_t i = 0; i < f.values.size(); ++i) {
        const bool determined = f.standard_error[i] < 2 * std::abs(f.values[i]);
        t.rows.push_back({std::string(f.rival->numbers[i].name), fmt::format("{:.4g}", f.values[i]),
                          determined ? fmt::format("{:.2g}", f.standard_error[i]) : "not determined by these rows",
                          std::string(unit_of(f.rival->numbers[i].quantity, Units(a.diagnosis.motion)))});
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

Table settings_table(const OutcomeAnswer& a)
{
    Table t{"By settings", {"where", "share of the gap", "95 % interval", "rows misjudged there"}, {}};
    t.bar_column = 1;
    for (const auto& s : a.diagnosis.regimes) {
        t.rows.push_back(
            {s.name, percent(s.share), percent(s.interval.low) + " … " + percent(s.interval.high), percent(s.rms)});
        t.bars.push_back({s.share, s.interval.low, s.interval.high});
    }
    return t;
}

}  // namespace stickslip
