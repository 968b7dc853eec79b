#include "analysis/diagnosis/verdict/reject.h"

#include "analysis/diagnosis/policy/ladder_verdict.h"
#include "analysis/diagnosis/policy/verdict.h"

#include <algorithm>
#include <optional>

namespace stickslip::gap {
namespace {

/// The factor by which the causes are less probable now.
double believe_at_most(std::vector<Cause>& causes, double most)
{
    if (causes.empty() || causes[0].probability <= most) return 1;
    const double factor = most / causes[0].probability;
    for (auto& c : causes) c.probability *= factor;
    return factor;
}

/// The named set is doubted, and with it what it rests on: the last rung of a ladder that was climbed, as it takes
/// least, and every rung of a set that was accepted at once. Findings of the audit rest on the command alone.
void doubt(Diagnosis& d, const Standing& standing, double most, Note why)
{
    const double factor = believe_at_most(d.effects, most);
    if (factor == 1) return;
    why.names = d.effects[0].names;
    d.reasons.push_back(std::move(why));
    const std::size_t last = d.ladder.empty() ? 0 : d.ladder.size() - 1;
    for (std::size_t i = std::max(standing.findings, standing.predicted ? last : 0); i < d.ladder.size(); ++i)
        d.ladder[i].probability *= factor;
}

/// Whether simulations of whole records keep a part of the gap that predictions from row to row know nothing of.
bool simulates_too_little(const OverallGap& gap)
{
    return gap.explained < policy::simulated_least && gap.after > policy::more_than_noise * gap.noise();
}

/// Whether one cause, on the only rung of its ladder, is all that is named.
bool alone(const Diagnosis& d, const Standing& standing)
{
    return standing.findings == 0 && d.ladder.size() == 1 && !d.effects.empty() && d.effects[0].names.size() == 1;
}

/// Nothing where the cause may stay.
std::optional<Note> why_rejected(const Diagnosis& d, const Standing& standing)
{
    const OverallGap& gap = d.overall;
    if (gap.worse()) return Note{Note::Code::rejected_worse};
    if (const double none = probability_of_none(d); standing.predicted && alone(d, standing) && none > policy::likelier)
        return Note{.code = Note::Code::rejected_less_likely, .values = {none}};
    if (standing.settled) return std::nullopt;
    if (gap.left() >= policy::mostly_left) return Note{Note::Code::rejected_leaves_most};
    if (!d.effects.empty() && !d.effects[0].plausible) return Note{Note::Code::rejected_implausible};
    if (!standing.noise_documented && gap.after > policy::many_floors * gap.noise())
        return Note{.code = Note::Code::rejected_in_many_floors, .values = {gap.after / gap.noise()}};
    return std::nullopt;
}

}  // namespace

bool reject_if_not_validated(Diagnosis& d, const Standing& standing)
{
    if (d.verdict != Verdict::gap) return false;
    auto why = why_rejected(d, standing);
    if (!why) {
        const OverallGap& gap = d.overall;
        const double floors = gap.after / gap.noise();
        if (!standing.settled && standing.noise_documented && floors > policy::more_than_noise)
            doubt(d, standing, policy::believed_doubted, {.code = Note::Code::doubted_above_noise, .values = {floors}});
        if (standing.predicted && simulates_too_little(gap))
            doubt(d, standing, policy::believed_simulated,
                  {.code = Note::Code::doubted_as_a_whole, .values = {gap.explained, floors}});
        else if (standing.settled && floors > policy::far_from_noise)
            d.reasons.push_back({.code = Note::Code::adds_up, .values = {floors}});
        return false;
    }
    d.verdict = Verdict::unknown;
    believe_at_most(d.effects, policy::believed_unnamed);
    if (!d.effects.empty()) why->names = d.effects[0].names;
    d.reasons.insert(d.reasons.begin(), *why);
    const bool stays = standing.predicted && why->code == Note::Code::rejected_worse;
    if (!stays) d.ladder.clear(), d.corrected_share = 0, d.remainder.share = 1;
    for (auto& rung : d.ladder) {
        rung.probability = std::min(rung.probability, policy::believed_unnamed);
        rung.ambiguous_with.clear();
    }
    d.ambiguous_with.clear();
    d.next_experiment = {};
    return true;
}

bool reject_no_gap(Diagnosis& d)
{
    if (d.verdict != Verdict::no_gap || !(d.overall.before > policy::far_from_noise)) return false;
    d.verdict = Verdict::unknown;
    std::erase_if(d.reasons, [](const Note& note) { return note.code == Note::Code::within_noise; });
    d.reasons.push_back({.code = Note::Code::far_as_a_whole, .values = {d.overall.before}});
    return true;
}

}  // namespace stickslip::gap
