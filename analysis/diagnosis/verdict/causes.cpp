#include "analysis/diagnosis/verdict/causes.h"

#include <algorithm>
#include <cmath>

namespace stickslip::gap {
namespace {

/// A contestant as a cause: its refitted own numbers are the joint's, not the cause's.
Cause cause_of(const Prepared& p, const Contestant& one, std::size_t own_numbers, double probability)
{
    Cause c = cause_of(p, one.fit, probability);
    std::size_t own = 0;
    for (std::size_t i = 0; i < own_numbers; ++i) own += one.fit.candidate.count_of(*one.fit.candidate.forms[i]);
    c.names = {std::string(one.fit.candidate.effects.back()->name)};
    c.parameters.erase(c.parameters.begin(), c.parameters.begin() + static_cast<std::ptrdiff_t>(own));
    c.tell_tale = one.fit.candidate.effects.back()->signature;
    c.form = one.fit.candidate.forms.back()->name;
    c.misfit = std::log1p(-std::min(one.gain, 0.999));
    c.heldout_gain = one.gain;
    c.heldout_gain_interval = one.spread;
    c.force_gain = one.force_gain;
    c.force_gain_interval = one.force_spread;
    return c;
}

/// Which of the contestants it is: their held-out log RMS against each other, and the chance that it is none of them.
std::vector<double> probabilities(const Contest& contest)
{
    constexpr double width = 0.07;  // of log RMS: what is left is model error, not noise
    constexpr double none_of_these = 0.2;
    std::vector<double> chances;
    double sum = 0;
    for (const auto& one : contest.ranked)
        sum += chances.emplace_back(std::pow((1 - contest.ranked[0].gain) / (1 - one.gain), 1 / width));
    for (double& x : chances) x *= (1 - none_of_these) / sum;
    return chances;
}

}  // namespace

Cause cause_of(const Prepared& p, const Attribution& a, double probability)
{
    Cause c;
    for (const auto& f : p.audit.findings)
        if (std::find(c.names.begin(), c.names.end(), f.effect) == c.names.end()) c.names.push_back(f.effect);
    const Motion motion = p.documented[0].mechanism.motion;
    if (!c.names.empty())
        for (const auto& f : p.audit.findings)
            c.parameters.push_back({f.parameter, f.value, f.stderr_, std::string(unit_of(f.quantity, motion))});
    c.probability = probability;
    c.misfit = a.score;
    for (const auto& name : c.names)
        if (const Effect* e = effect_named(name))
            c.tell_tale += (c.tell_tale.empty() ? "" : "; ") + std::string(e->signature);
    c.signature = !c.names.empty();
    if (a.candidate.effects.empty()) return c;
    const auto quality = quality_of(p.cases, a, p.scales);
    c.signature = quality.signature;
    c.plausible = quality.plausible;
    const auto si = in_si(a.candidate, a.x[1], p.scales);
    std::size_t i = 0;
    for (std::size_t n = 0; n < a.candidate.effects.size(); ++n) {
        const Effect& e = *a.candidate.effects[n];
        if (std::find(c.names.begin(), c.names.end(), e.name) == c.names.end()) c.names.emplace_back(e.name);
        c.tell_tale += (c.tell_tale.empty() ? "" : "; ") + std::string(e.signature);
        if (!a.candidate.forms[n]->name.empty())
            c.form += (c.form.empty() ? "" : " + ") + std::string(a.candidate.forms[n]->name);
        const EffectForm& form = *a.candidate.forms[n];
        const std::size_t shared = form.parameters.size() - form.own;
        for (std::size_t k = 0; k < a.candidate.count_of(form); ++k, ++i) {
            const auto& parameter = a.candidate.parameter_of(form, k);
            std::string name = std::string(e.name) + "." + std::string(parameter.name);
            if (k >= shared) name += " in " + p.cases[(k - shared) / form.own].ticks.name;
            c.parameters.push_back(
                {name, si[i], quality.standard_error[i], std::string(unit_of(parameter.quantity, motion))});
        }
    }
    return c;
}

std::vector<Cause> causes_of(const Prepared& prepared, const Contest& contest)
{
    const auto chances = probabilities(contest);
    std::vector<Cause> causes;
    for (std::size_t i = 0; i < contest.ranked.size(); ++i)
        causes.push_back(cause_of(prepared, contest.ranked[i], contest.own_numbers, chances[i]));
    return causes;
}

}  // namespace stickslip::gap
