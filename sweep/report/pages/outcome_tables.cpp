#include "sweep/report/pages/outcome_tables.h"

#include "analysis/joint/parameters.h"
#include "analysis/results/text.h"
#include "sweep/words/diagnosis_tables.h"
#include "sweep/words/effect_words.h"
#include "sweep/words/outcome_text.h"
#include "sweep/words/symbols.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace stickslip {

using gap::LawFit;
using gap::OutcomeAnswer;

Table laws_table(const OutcomeAnswer& a)
{
    Table t{"Friction laws, most probable first",
            {"law", "effect", "probability", "rows misjudged, held out", "log-likelihood of outcomes, held out",
             "of amplitudes, held out", "width of the boundary"},
            {}};
    const auto row = [&](const LawFit& f, const std::string& name, const std::string& effect, const std::string& p) {
        t.rows.push_back({name, effect, p, fmt::format("{} of {}", f.misjudged, a.outcomes.size()),
                          fmt::format("{:.1f}", f.held_out),
                          f.amplitude_held_out != 0 ? fmt::format("{:.1f}", f.amplitude_held_out) : "–",
                          percent(f.softness)});
    };
    for (const auto& f : a.laws)
        row(f, std::string(f.rival->law), effect_words(f.rival->effect), fmt::format("{:.3f}", f.posterior));
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
    const Units units = units_of(a.after);
    Joint joint = a.after;
    const auto known = parameters(joint);
    std::vector<Quantity> quantities;
    for (const auto& path : a.outcomes.table.paths) {
        const auto found = std::ranges::find(known, path, &Parameter::path);
        quantities.push_back(found == known.end() ? Quantity::number : found->quantity);
        t.columns.push_back(symbol_of(path, units));
    }
    for (const char* c :
         {"measured", "amplitude", "probability of stick-slip", "amplitude by the law", "nominal joint says"})
        t.columns.emplace_back(c);
    const LawFit& best = a.laws.front();
    const auto number = [&](double v, Quantity quantity) { return with_unit(v, quantity, units, 4); };
    for (std::size_t i = 0; i < a.outcomes.size(); ++i) {
        const auto& r = a.outcomes.table.rows[i];
        std::vector<std::string> cells{std::to_string(r.line)};
        for (std::size_t k = 0; k < r.settings.size(); ++k) cells.push_back(number(r.settings[k], quantities[k]));
        cells.insert(cells.end(),
                     {r.stick_slip ? "stick-slip" : "slides", number(r.amplitude, Quantity::position),
                      fmt::format("{:.2f}", best.probability[i]), number(best.amplitude[i], Quantity::position),
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
        t.rows.push_back({third_text(s.name, a), percent(s.share),
                          percent(s.interval.low) + " … " + percent(s.interval.high), percent(s.rms)});
        t.bars.push_back({s.share, s.interval.low, s.interval.high});
    }
    return t;
}

}  // namespace stickslip
