#include "sweep/study/score.h"

#include <algorithm>
#include <cmath>

namespace stickslip::blind {
namespace {

constexpr int bins = 10;
constexpr std::size_t largest_ambiguity = 2;  // names in a set that still counts as an answer, the first included
constexpr double shrink_slack = 1.1;
constexpr double explained_slack = 0.1;  // of the squares of the gap

/// Part of the gap's squares that is gone.
double explained(double shrink)
{
    return 1 - shrink * shrink;
}

bool has(const EffectSet& set, const std::string& name)
{
    return std::find(set.begin(), set.end(), name) != set.end();
}

/// Whether `set` names the truth: the same effects, where an equivalent may stand in for any of them.
bool names(const EffectSet& set, const Truth& t, bool equivalents = true)
{
    if (set.size() != t.effects.size()) return false;
    const auto missing = std::count_if(t.effects.begin(), t.effects.end(), [&](const auto& e) { return !has(set, e); });
    const auto stand_ins = std::count_if(set.begin(), set.end(),
                                         [&](const auto& e) { return !has(t.effects, e) && has(t.equivalent, e); });
    return missing <= (equivalents ? stand_ins : 0);
}

/// The first set of an answer. Flat rankings say two single names where they mean a pair of them.
EffectSet first_set(const Answer& a, std::size_t wanted)
{
    if (a.ranked.empty()) return {};
    EffectSet first = a.ranked[0];
    const bool flat = std::all_of(a.ranked.begin(), a.ranked.end(), [](const auto& s) { return s.size() == 1; });
    if (flat && a.probabilities.empty())
        for (std::size_t i = 1; i < a.ranked.size() && first.size() < wanted; ++i) first.push_back(a.ranked[i][0]);
    return first;
}

std::string joined(const EffectSet& set)
{
    std::string text;
    for (const auto& name : set) text += (text.empty() ? "" : " + ") + name;
    return text;
}

double median(std::vector<double> values)
{
    if (values.empty()) return missing;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    if (values.size() % 2) return *middle;
    return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

/// Whether a document that is off is called that, and nothing else.
bool only_corrections(const Truth& t, const Answer& a)
{
    if (!t.dirty || t.verdict != "no-gap" || a.verdict != "gap" || a.ranked.empty()) return false;
    return std::all_of(a.ranked[0].begin(), a.ranked[0].end(), [&](const auto& e) { return has(t.equivalent, e); });
}

Judgement judge(const std::string& name, const Truth& t, const Answer* a)
{
    Judgement j{.name = name, .kind = t.kind, .strength = t.strength, .engine = t.engine};
    j.expected = t.effects.empty() || t.verdict != "gap" ? t.verdict : joined(t.effects);
    j.truth_shrink = t.gap_after / t.gap_before;
    if (!a) return j;
    j.answered_at_all = true;
    const EffectSet first = first_set(*a, t.effects.size());
    j.answered = a->verdict == "gap" ? joined(first) : a->verdict;
    j.shrink = a->gap_after / a->gap_before;
    if (a->verdict == "gap" && !a->probabilities.empty()) j.probability = a->probabilities[0];
    j.right = (a->verdict == t.verdict && (t.verdict != "gap" || names(first, t))) || only_corrections(t, *a);
    j.right_or_ambiguous = j.right;
    if (!j.right && t.verdict == "gap" && a->verdict == "gap" && a->ambiguous_with.size() < largest_ambiguity)
        for (const auto& set : a->ambiguous_with) j.right_or_ambiguous = j.right_or_ambiguous || names(set, t);
    return j;
}

void count_case(Score& s, const Judgement& j, const Truth& t, const Answer* a)
{
    s.verdicts.count(a && a->verdict == t.verdict);
    s.by_kind[t.kind].count(j.right);
    if (t.verdict == "no-gap")
        s.false_alarms.count(a && a->verdict != "no-gap" && a->verdict != "insufficient-data" &&
                             !only_corrections(t, *a));
    if (t.verdict == "unknown") s.abstained.count(j.right);
    if (t.verdict == "insufficient-data") s.insufficient.count(j.right);
    if (t.verdict != "gap") return;
    s.by_strength[t.strength].count(j.right_or_ambiguous);
    s.by_engine[t.engine].count(j.right_or_ambiguous);
    s.by_joint[t.joint].count(j.right_or_ambiguous);
    s.by_columns[t.columns].count(j.right_or_ambiguous);
    const bool gap = a && a->verdict == "gap";
    if (t.effects.size() == 1) {
        s.top1.count(j.right);
        s.top1_exact.count(gap && names(first_set(*a, 1), t, false));
        s.named.count(j.right_or_ambiguous);
        s.by_effect[t.effects[0]].count(j.right_or_ambiguous);
    } else {
        s.pairs_both.count(j.right);
        s.pairs_both_or_ambiguous.count(j.right_or_ambiguous);
        const EffectSet first = gap ? first_set(*a, t.effects.size()) : EffectSet{};
        for (const auto& e : t.effects) s.pair_members.count(has(first, e));
    }
}

void calibrate(Score& s)
{
    s.reliability.resize(bins);
    std::vector<double> sums(bins);
    double squares = 0;
    int total = 0;
    for (int b = 0; b < bins; ++b) {
        s.reliability[b].low = static_cast<double>(b) / bins;
        s.reliability[b].high = static_cast<double>(b + 1) / bins;
    }
    for (const auto& j : s.cases) {
        if (std::isnan(j.probability)) continue;
        const int b = std::clamp(static_cast<int>(j.probability * bins), 0, bins - 1);
        s.reliability[b].right.count(j.right);
        sums[b] += j.probability;
        squares += (j.probability - j.right) * (j.probability - j.right);
        ++total;
    }
    if (total == 0) return;
    s.brier = squares / total;
    s.calibration_error = 0;
    for (int b = 0; b < bins; ++b) {
        auto& bin = s.reliability[b];
        if (bin.right.of == 0) continue;
        bin.mean_probability = sums[b] / bin.right.of;
        s.calibration_error +=
            static_cast<double>(bin.right.of) / total * std::abs(bin.mean_probability - bin.right.value());
    }
}

void compare_shrinks(Score& s)
{
    std::vector<double> answered, achievable;
    for (const auto& j : s.cases) {
        if (!j.right_or_ambiguous || std::isnan(j.shrink) || std::isnan(j.truth_shrink)) continue;
        // where abstaining is right nothing is added to the joint, and nothing shrinks
        if (j.expected == "no-gap" || j.expected == "unknown" || j.expected == "insufficient-data") continue;
        answered.push_back(j.shrink);
        achievable.push_back(j.truth_shrink);
        s.within_tenth.count(j.shrink <= shrink_slack * j.truth_shrink);
        s.explained_within_tenth.count(std::abs(explained(j.shrink) - explained(j.truth_shrink)) <= explained_slack);
    }
    s.median_shrink = median(answered);
    s.median_truth_shrink = median(achievable);
}

Score score_of(const std::map<std::string, Answer>& answers, const std::map<std::string, Truth>& truths)
{
    Score s;
    for (const auto& [name, truth] : truths) {
        const auto found = answers.find(name);
        const Answer* answer = found == answers.end() ? nullptr : &found->second;
        s.cases.push_back(judge(name, truth, answer));
        count_case(s, s.cases.back(), truth, answer);
    }
    calibrate(s);
    compare_shrinks(s);
    return s;
}

}  // namespace

Score score(const std::map<std::string, Answer>& answers, const std::map<std::string, Truth>& truths)
{
    std::map<std::string, Truth> clean, dirty;
    for (const auto& [name, truth] : truths) (truth.dirty ? dirty : clean).emplace(name, truth);
    Score s = score_of(answers, truths);
    if (clean.empty() != dirty.empty()) s.state = dirty.empty() ? "clean" : "dirty";
    if (clean.empty() || dirty.empty()) return s;
    s.parts = {score_of(answers, clean), score_of(answers, dirty)};
    s.parts[0].state = "clean", s.parts[1].state = "dirty";
    return s;
}

}  // namespace stickslip::blind
