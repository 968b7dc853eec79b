#include "analysis/diagnosis/verdict/withdraw.h"

#include <algorithm>
#include <optional>

namespace stickslip::gap {
namespace {

void believe_at_most(std::vector<Cause>& causes, double most)
{
    if (causes.empty() || causes[0].probability <= most) return;
    const double factor = most / causes[0].probability;
    for (auto& c : causes) c.probability *= factor;
}

/// Nothing where the cause may stay.
std::optional<Note> why_withdrawn(const Diagnosis& d, const Standing& standing)
{
    const OverallGap& gap = d.overall;
    constexpr double mostly_left = 0.5;  // of the mean square beyond the noise
    // Of floors that nobody documented. Of the unsettled causes in ten draws of sealed cases the one that left less
    // than two was right, the two that left more than seven were an inertia that changed with time.
    constexpr double many = 3;
    if (gap.worse()) return Note{Note::Code::withdrawn_worse};
    if (standing.settled) return std::nullopt;
    if (gap.left() >= mostly_left) return Note{Note::Code::withdrawn_leaves_most};
    if (!d.effects.empty() && !d.effects[0].plausible) return Note{Note::Code::withdrawn_implausible};
    if (!standing.noise_documented && gap.after > many * gap.noise())
        return Note{.code = Note::Code::withdrawn_in_many_floors, .values = {gap.after / gap.noise()}};
    return std::nullopt;
}

}  // namespace

bool withdraw_if_no_better(Diagnosis& d, const Standing& standing)
{
    // In floors. Of ten unsettled causes in two draws of sealed cases the six that left less were right, and the four
    // that left more were wrong, or lacked a second effect.
    constexpr double more_than_noise = 1.5, doubted = 0.2;
    if (d.verdict != Verdict::gap) return false;
    auto why = why_withdrawn(d, standing);
    if (!why) {
        if (!standing.settled && standing.noise_documented && d.overall.after > more_than_noise * d.overall.noise())
            believe_at_most(d.effects, doubted);
        return false;
    }
    d.verdict = Verdict::unknown;
    believe_at_most(d.effects, believed_unnamed);
    if (!d.effects.empty()) why->names = d.effects[0].names;
    d.reasons.insert(d.reasons.begin(), *why);
    d.ladder.clear();
    d.remainder.share = 1;
    d.ambiguous_with.clear();
    d.next_experiment = {};
    return true;
}

bool withdraw_no_gap(Diagnosis& d)
{
    // of 470 sealed joints without an effect none was further away than 1.25 floors
    constexpr double far_from_noise = 1.5;
    if (d.verdict != Verdict::no_gap || !(d.overall.before > far_from_noise)) return false;
    d.verdict = Verdict::unknown;
    std::erase_if(d.reasons, [](const Note& note) { return note.code == Note::Code::within_noise; });
    d.reasons.push_back({.code = Note::Code::far_as_a_whole, .values = {d.overall.before}});
    return true;
}

}  // namespace stickslip::gap
