#include "analysis/results/contradictions.h"

#include <cmath>
#include <numeric>
#include <set>

namespace stickslip {
namespace {

constexpr double rounding = 1e-9;
/// Shares that were computed apart, from means over other rows, may differ by so much of the gap.
constexpr double apart = 0.05;

using Found = std::vector<std::string_view>;

bool is_named(const Diagnosis& d)
{
    return d.verdict == Verdict::gap && !d.effects.empty();
}

bool has_reason(const Diagnosis& d, Note::Code code)
{
    return std::ranges::any_of(d.reasons, [&](const Note& note) { return note.code == code; });
}

/// What was gained on unseen rows may stand beside a simulation of whole records that gets worse with it: no verdict.
bool gained_but_worse(const Diagnosis& d)
{
    return has_reason(d, Note::Code::rejected_worse) && d.verdict == Verdict::unknown && d.overall.worse() &&
           std::ranges::all_of(d.ladder, [](const LadderRung& rung) { return rung.probability < 0.5; });
}

void check_probabilities(const Diagnosis& d, Found& found)
{
    double sum = 0, most = 0;
    bool each = true;
    for (const auto& cause : d.effects) {
        each = each && cause.probability >= 0 && cause.probability <= 1;
        sum += cause.probability, most = std::max(most, cause.probability);
    }
    if (!each || sum > 1 + rounding) found.push_back("probabilities-exceed-one");
    if (is_named(d) && d.effects[0].probability < most - rounding) found.push_back("first-cause-is-not-the-likeliest");
    // a rival that cannot be distinguished from the first has 1/e of its odds at least (policy/)
    if (is_named(d) && !d.ambiguous_with.empty() && d.effects[0].probability > 1 / (1 + std::exp(-1.0)) + 1e-3)
        found.push_back("sure-beside-a-rival");
    for (const auto& rung : d.ladder)
        if (!(rung.probability >= 0 && rung.probability <= 1)) found.push_back("probability-of-a-rung");
}

void check_names(const Diagnosis& d, Found& found)
{
    const auto set = [](const std::vector<std::string>& names) { return std::set(names.begin(), names.end()); };
    for (const auto& cause : d.effects)
        if (set(cause.names).size() != cause.names.size()) found.push_back("a-cause-twice-in-a-set");
    if (is_named(d))
        for (const auto& rival : d.ambiguous_with)
            if (d.effects[0].form.empty() && set(rival) == set(d.effects[0].names) && d.ladder.size() > 1)
                found.push_back("a-cause-is-its-own-rival");
    if (d.verdict == Verdict::gap) return;
    if (!d.ladder.empty() && !gained_but_worse(d)) found.push_back("rungs-without-a-cause");
    if (!d.ambiguous_with.empty()) found.push_back("rivals-without-a-cause");
    if (!d.effects.empty() && d.effects[0].probability > 0.5) found.push_back("likely-and-not-named");
}

/// Rungs, corrections and the remainder are the whole gap; nothing named takes more than is explainable.
void check_shares(const Diagnosis& d, Found& found)
{
    const double rungs = std::accumulate(d.ladder.begin(), d.ladder.end(), 0.0,
                                         [](double sum, const LadderRung& rung) { return sum + rung.share; });
    const double taken = rungs + d.corrected_share;
    const bool judged = std::isfinite(d.ceiling.share) && !d.corrections.empty();
    if (judged && std::abs(taken + d.remainder.share - 1) > apart) found.push_back("shares-are-not-the-whole");
    if (judged && taken > d.ceiling.share + apart) found.push_back("more-taken-than-explainable");
    if (d.remainder.share < -rounding || d.remainder.share > 1 + rounding) found.push_back("remainder-is-no-share");
    if (!d.remainder.structure.empty() && !(d.remainder.share > 0)) found.push_back("structure-of-nothing");
    const bool corrections_answer = taken >= 0.5 && taken >= 0.5 * d.ceiling.share;  // policy/: least_of_gap
    if (d.verdict == Verdict::unknown && judged && corrections_answer &&
        !has_reason(d, Note::Code::force_beside_numbers) && !gained_but_worse(d))
        found.push_back("unknown-though-mostly-taken");
}

void check_reasons(const Diagnosis& d, Found& found)
{
    for (const auto& reason : d.reasons)
        if (reason.code == Note::Code::takes_too_little &&
            !(reason.values.size() == 2 && reason.values[1] >= 0.01 && reason.values[0] < reason.values[1]))
            found.push_back("too-little-of-nothing");
    if (has_reason(d, Note::Code::within_noise) && d.verdict != Verdict::no_gap)
        found.push_back("within-noise-and-a-gap");
    const bool noise = has_reason(d, Note::Code::cause_to_noise) || has_reason(d, Note::Code::numbers_to_noise);
    if (noise && !d.remainder.structure.empty()) found.push_back("structure-of-noise");
    if (has_reason(d, Note::Code::rejected_worse) && !d.overall.worse())
        found.push_back("withdrawn-as-worse-and-better");
    if (noise && d.verdict != Verdict::gap) found.push_back("to-the-noise-and-not-named");
}

void check_gap(const Diagnosis& d, Found& found)
{
    const OverallGap& gap = d.overall;
    if (!(gap.before > 0)) return;
    if (is_named(d) && gap.worse()) found.push_back("named-and-worse");
    const double whole = gap.before * gap.before - gap.floor * gap.floor;
    if (whole > 0 && gap.floor > 0 &&
        std::abs(gap.explained - (gap.before * gap.before - gap.after * gap.after) / whole) > 1e-6)
        found.push_back("explained-is-not-before-less-after");
    if (d.verdict == Verdict::unknown && gap.after != gap.before && d.effects.empty())
        found.push_back("shrunk-by-nothing");
}

}  // namespace

std::vector<std::string_view> contradictions_in(const Diagnosis& d)
{
    Found found;
    check_probabilities(d, found);
    check_names(d, found);
    check_shares(d, found);
    check_reasons(d, found);
    check_gap(d, found);
    return found;
}

}  // namespace stickslip
