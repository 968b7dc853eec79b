#include "analysis/diagnosis/verdict/causes.h"

#include "analysis/diagnosis/verdict/quality.h"
#include "analysis/diagnosis/verdict/sheet_values.h"

#include <algorithm>
#include <iterator>

namespace stickslip::gap {
Cause cause_of(const Prepared& p, const Attribution& a, double probability, std::size_t corrections)
{
    Cause c;
    for (const auto& f : p.audit.findings)
        if (std::find(c.names.begin(), c.names.end(), f.effect) == c.names.end()) c.names.push_back(f.effect);
    const Units units = units_of(p.documented[0]);
    if (!c.names.empty())
        for (const auto& f : p.audit.findings)
            c.parameters.push_back({f.parameter, f.value, f.stderr_, std::string(unit_of(f.quantity, units))});
    c.values = sheet_values_of_findings(p);
    c.probability = probability;
    c.misfit = a.score;
    for (const auto& name : c.names)
        if (effect_named(name)) c.signatures.push_back(name);
    c.signature = !c.names.empty();
    if (a.candidate.effects.size() <= corrections) return c;
    const auto quality = quality_of(p.cases, a, p.scales);
    c.signature = quality.signature;
    c.plausible = quality.plausible;
    std::ranges::move(sheet_values(p, a, quality, corrections), std::back_inserter(c.values));
    const auto si = in_si(a.candidate, a.x[1], p.scales);
    std::size_t i = 0;
    for (std::size_t n = 0; n < a.candidate.effects.size(); ++n) {
        const Effect& e = *a.candidate.effects[n];
        if (n < corrections) {
            i += a.candidate.count_of(*a.candidate.forms[n]);
            continue;
        }
        if (std::find(c.names.begin(), c.names.end(), e.name) == c.names.end()) c.names.emplace_back(e.name);
        c.signatures.emplace_back(e.name);
        if (!a.candidate.forms[n]->name.empty())
            c.form += (c.form.empty() ? "" : " + ") + std::string(a.candidate.forms[n]->name);
        const EffectForm& form = *a.candidate.forms[n];
        const std::size_t shared = form.parameters.size() - form.own;
        for (std::size_t k = 0; k < a.candidate.count_of(form); ++k, ++i) {
            const auto& parameter = a.candidate.parameter_of(form, k);
            std::string name = std::string(e.name) + "." + std::string(parameter.name);
            if (k >= shared) name += " in " + p.cases[(k - shared) / form.own].ticks.name;
            c.parameters.push_back(
                {name, si[i], quality.standard_error[i], std::string(unit_of(parameter.quantity, units))});
        }
    }
    return c;
}

std::vector<std::string> with_findings(const Prepared& p, const std::vector<std::string>& causes)
{
    std::vector<std::string> names;
    for (const auto& f : p.audit.findings)
        if (std::ranges::count(names, f.effect) == 0) names.push_back(f.effect);
    for (const auto& name : causes)
        if (std::ranges::count(names, name) == 0) names.push_back(name);
    return names;
}

}  // namespace stickslip::gap
