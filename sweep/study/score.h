// How well answers to blind test cases agree with what was put into them. Plain data in, plain data out.
#pragma once
#include "analysis/results/point.h"

#include <map>
#include <string>
#include <vector>

namespace stickslip::blind {

/// Effects that are said, or known, to act together.
using EffectSet = std::vector<std::string>;

/// What the diagnosis answered to one case.
struct Answer {
    std::string verdict;                    ///< gap | no-gap | unknown | insufficient-data
    std::vector<EffectSet> ranked;          ///< best first
    std::vector<double> probabilities;      ///< of the ranked sets; may be shorter or empty
    std::vector<EffectSet> ambiguous_with;  ///< what cannot be distinguished from the first
    double gap_before = missing, gap_after = missing;
};

/// What a generator put into one case.
struct Truth {
    std::string verdict;
    EffectSet effects;
    EffectSet equivalent;  ///< other names for the very same motion
    std::string kind, strength, engine, joint, columns;
    bool dirty = false;  ///< the joint was not quite its document; `equivalent` of no effect are corrections of it
    double gap_before = missing, gap_after = missing;
};

/// A share with its count; the share of nothing is NaN.
struct Share {
    int right = 0, of = 0;
    void count(bool is_right)
    {
        right += is_right;
        ++of;
    }
    double value() const { return of ? static_cast<double>(right) / of : missing; }
};

/// Answers whose first probability fell into [low, high).
struct ReliabilityBin {
    double low = 0, high = 0, mean_probability = 0;
    Share right;
};

/// One case, judged.
struct Judgement {
    std::string name, kind, strength, engine, expected, answered;
    bool answered_at_all = false, right = false, right_or_ambiguous = false;
    double probability = missing;   ///< of the first answer
    double shrink = missing;        ///< gap after / before, as answered
    double truth_shrink = missing;  ///< the same for the true effect with its true numbers
};

struct Score {
    Share top1;        ///< single effects named first, alone (an equivalent name counts)
    Share top1_exact;  ///< the same, the very name
    Share named;       ///< first, or in an ambiguity set of at most two
    Share pairs_both;  ///< pairs whose first set is the pair
    Share pairs_both_or_ambiguous;
    Share pair_members;  ///< effects of pairs that the first set names
    Share false_alarms;  ///< cases without an effect where anything but no-gap, insufficient-data or a correction was
                         ///< said
    Share abstained;     ///< causes outside the catalogue answered with unknown
    Share insufficient;  ///< hopeless cases answered with insufficient-data
    Share verdicts;
    double brier = missing;              ///< of the first probability as a forecast that the first answer is right
    double calibration_error = missing;  ///< expected calibration error over the bins
    std::vector<ReliabilityBin> reliability;
    double median_shrink = missing, median_truth_shrink = missing;
    Share within_tenth;            ///< named cases whose shrink is at most 1.1 times the truth's
    Share explained_within_tenth;  ///< the same whose explained part of the squares is the truth's within 0.1
    std::map<std::string, Share> by_effect, by_strength, by_engine, by_joint, by_columns, by_kind;
    std::vector<Judgement> cases;
    std::string state;         ///< "clean" or "dirty" where only those were counted
    std::vector<Score> parts;  ///< the same of clean and of dirty cases, where there are both
};

/// Judges every case that has a truth; a case without an answer counts as wrong.
Score score(const std::map<std::string, Answer>& answers, const std::map<std::string, Truth>& truths);

/// Reads answers.json: {case: {verdict, effects: [name or [names] by rank], gap_before, gap_after, probabilities?,
/// ambiguous_with?}}. Throws std::invalid_argument with the case's name if something is not of that form.
std::map<std::string, Answer> parse_answers(const std::string& json);
/// Reads what the generators write. Throws as parse_answers does.
std::map<std::string, Truth> parse_truths(const std::string& json);

/// The score as a table for people, and as JSON with stable names.
std::string score_text(const Score& score);
std::string score_json(const Score& score);

}  // namespace stickslip::blind
