#include "sweep/words/diagnosis_first_screen.h"

#include "analysis/diagnosis/policy/page_and_plan.h"
#include "analysis/results/point.h"
#include "sweep/words/cause_text.h"
#include "sweep/words/diagnosis_tables.h"
#include "sweep/words/named_cause.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

using Tone = Headline::Tone;

const Share* largest(const std::vector<Share>& shares, std::size_t among)
{
    const Share* best = nullptr;
    for (std::size_t i = 0; i < std::min(among, shares.size()); ++i)
        if (!best || shares[i].share > best->share) best = &shares[i];
    return best;
}

bool judged_by_force(const Diagnosis& d)
{
    return d.verdict == Verdict::gap && d.drive_force.corner > 0 && d.drive_force.after < d.drive_force.before;
}

/// "2.31", "2.4e+04": a gap over the noise floor, which can be anything.
std::string as_multiple(double gap)
{
    if (!(gap >= 1000 && std::isfinite(gap))) return fmt::format("{:.2f}", gap);
    const double unit = std::pow(10, std::floor(std::log10(gap)) - 2);  // three digits, no exponent
    return fmt::format("{:.0f}", std::round(gap / unit) * unit);
}

std::string when_text(const std::string& regime)
{
    return regime == "low speed" ? "at low speed" : "while " + regime;
}

/// Of the gap's held-out squares beyond the noise: the rungs of the causes that are named. What corrections of the
/// document or rungs that are not named take is not theirs. NaN where the named ones are no rungs.
double explained_by_named(const Diagnosis& d)
{
    double share = missing;
    if (d.effects.empty()) return share;
    const auto& named = d.effects[0].names;
    for (const auto& rung : d.ladder)
        if (std::all_of(rung.names.begin(), rung.names.end(),
                        [&](const auto& n) { return std::find(named.begin(), named.end(), n) != named.end(); }))
            share = (std::isnan(share) ? 0 : share) + rung.share;
    return share;
}

bool has_remainder(const Diagnosis& d)
{
    return !d.ladder.empty() && std::isfinite(d.remainder.share);
}

/// A cause that is itself noise cannot bring two simulations closer: it explains why they differ.
bool adds_noise(const Diagnosis& d)
{
    return d.overall.after >= d.overall.before;
}

/// The gap before and after, on held-out data, noise included.
std::string held_out_text(const Diagnosis& d)
{
    if (judged_by_force(d))
        return fmt::format("held-out error of the model's drive force, {:.3g} → {:.3g} {}", d.drive_force.before,
                           d.drive_force.after, d.drive_force.unit);
    return fmt::format("held-out gap, {} → {} × the noise floor", as_multiple(d.overall.before),
                       as_multiple(d.overall.after));
}

}  // namespace

std::string heading_of(const Diagnosis& d, const Joint& before, const Joint& after)
{
    const std::string text = cause_text(d.effects[0], before, after);
    const double sure = probability_of_part(d);
    if (sure >= gap::policy::stated_flatly) return text;
    return fmt::format("{} ({}): {}", sure >= gap::policy::stated_as_probable ? "Probable" : "Likeliest, not certain",
                       whole_percent(sure), text);
}

/// Whether the measured effort drove the joint because no gains of the documented controller make it.
bool another_controller(const Diagnosis& d)
{
    return std::ranges::any_of(d.reasons, [](const Note& n) { return n.code == Note::Code::no_such_controller; });
}

Headline what_card(const Diagnosis& d)
{
    if (d.verdict == Verdict::no_gap)
        return another_controller(d)
                   ? Headline{Tone::warning, "another controller",
                              "cause: the effort is not that of the documented controller; the mechanism has no gap"}
                   : Headline{Tone::good, "none", "cause: the nominal joint predicts the records to within noise"};
    if (d.interrupted) return {Tone::neutral, "not known", "cause: the search was interrupted; no cause is excluded"};
    if (d.verdict == Verdict::unknown || d.effects.empty())
        return {Tone::bad, "not in the catalogue", "cause: no effect of the catalogue explains the gap"};
    if (const auto causes = one_of(d); causes.size() > 1)
        return {Tone::warning, fmt::format("one of {}", fmt::join(causes, ", ")),
                "cause: these records cannot distinguish them; the values above are those of the first"};
    std::string meaning = "cause: the most probable effect of the catalogue; its values are above";
    if (const Cause* wider = wider_cause(d))
        meaning += fmt::format("; {} predicts held-out data better", together(wider->names));
    return {Tone::warning, together(d.effects[0].names), meaning};
}

Headline where_card(const Diagnosis& d)
{
    if (d.verdict == Verdict::no_gap && !another_controller(d))
        return {Tone::good, "none", "location: no stage exceeds its noise"};
    constexpr std::size_t exclusive = 3;  // stuck, low speed, sliding
    const Share* s = largest(d.signals, d.signals.size());
    const Share* r = largest(d.regimes, exclusive);
    std::string meaning = fmt::format("location: the stage with {} of the gap", whole_percent(s->share));
    if (r && r->share > 0)
        meaning += fmt::format("; {} of the motion's error occurs {}", whole_percent(r->share), when_text(r->name));
    return {Tone::neutral, s->name, meaning};
}

Headline how_much_card(const Diagnosis& d)
{
    if (const double share = explained_by_named(d); d.verdict == Verdict::gap && !adds_noise(d) && std::isfinite(share))
        return {
            Tone::neutral, whole_percent(share),
            "how much: part of the gap beyond the noise that it explains; " + held_out_text(d) + ", noise included"};
    if (judged_by_force(d))
        return {Tone::neutral, fmt::format("− {}", whole_percent(1 - d.drive_force.after / d.drive_force.before)),
                "how much: " + held_out_text(d)};
    if (d.verdict == Verdict::gap && adds_noise(d))
        return {
            Tone::neutral, as_multiple(d.overall.after) + " × noise floor",
            fmt::format("how much: the gap on held-out data; simulations with the cause differ by {} among themselves",
                        as_multiple(d.overall.own_floor))};
    if (d.verdict == Verdict::gap)
        return {Tone::neutral, fmt::format("− {}", whole_percent(1 - d.overall.after / d.overall.before)),
                "how much: " + held_out_text(d)};
    return {Tone::neutral, as_multiple(d.overall.before) + " × noise floor",
            "how much: the gap on held-out data; noise alone makes 1"};
}

Headline how_sure_card(const Diagnosis& d)
{
    const Cause* wider = wider_cause(d);
    std::string meaning =
        wider ? "how sure: the probability that it is a part of the cause; " : "how sure: its probability; ";
    if (wider)
        meaning += alone_or_wider(d, *wider);
    else if (!d.ambiguous_with.empty())
        meaning += "these records cannot distinguish it from " + rivals_text(d);
    else if (d.effects.size() > 1)
        meaning += fmt::format("the next candidate is {} with {}", together(d.effects[1].names),
                               whole_percent(d.effects[1].probability));
    else
        meaning += "no other candidate remains";
    if (const double none = probability_of_none(d); none >= gap::policy::stated_none)
        meaning += fmt::format("; {} that the cause is not listed", whole_percent(none));
    return {Tone::neutral, whole_percent(probability_of_part(d)), meaning};
}

std::vector<Headline> remains_card(const Diagnosis& d)
{
    if (!has_remainder(d)) return {};
    std::string meaning = "remainder: part of the gap's held-out squares beyond the noise";
    if (!d.remainder.structure.empty())
        meaning += fmt::format("; it still depends on {}", fmt::join(d.remainder.structure, ", "));
    return {{Tone::neutral, whole_percent(std::max(0.0, d.remainder.share)), meaning}};
}

std::string diagnosis_sentence(const Diagnosis& d)
{
    switch (d.verdict) {
        case Verdict::gap: {
            std::string text = said_by_probability(d);
            if (judged_by_force(d))
                text += fmt::format(
                    ": on held-out data the error of the model's drive force shrinks from {:.3g} "
                    "to {:.3g} {}",
                    d.drive_force.before, d.drive_force.after, d.drive_force.unit);
            else if (d.overall.before > 0 && adds_noise(d))
                text += fmt::format(
                    ": it makes noise, and simulations with it differ by {} times the noise floor among themselves, "
                    "the records from them by {}",
                    as_multiple(d.overall.own_floor), as_multiple(d.overall.after));
            else if (d.overall.before > 0)
                text += fmt::format(": on held-out data it shrinks from {} to {} times the noise floor{}",
                                    as_multiple(d.overall.before), as_multiple(d.overall.after),
                                    wider_cause(d) ? " with " + together(d.effects[0].names) + " alone" : "");
            if (one_of(d).size() == 1 && !d.ambiguous_with.empty())
                text += "; these records cannot distinguish it from " + rivals_text(d);
            return text + ".";
        }
        case Verdict::no_gap:
            if (another_controller(d))
                return "No gap in the mechanism: driven by the measured effort, the nominal joint predicts the records "
                       "to within noise. Another controller than the documented one made that effort.";
            return "No gap: the nominal joint predicts the records to within noise.";
        case Verdict::unknown:
            if (d.interrupted)
                return "Interrupted before the search was done: what causes the gap is not known, and no cause is "
                       "excluded.";
            return "There is a gap, and no effect of the catalogue explains it.";
        default: {
            const bool suspected = std::any_of(d.reasons.begin(), d.reasons.end(), contradicts);
            return suspected ? "No conclusion: records and joint contradict each other."
                             : "These records are not sufficient for a conclusion.";
        }
    }
}

}  // namespace stickslip
