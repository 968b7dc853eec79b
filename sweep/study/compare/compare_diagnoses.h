// Two diagnoses of one joint: is the gap new, which cause came or went, which parameter moved and how far.
#pragma once
#include "sweep/study/compare/diagnosis_facts.h"

#include <optional>
#include <string>
#include <vector>

namespace stickslip {

enum class GapChange {
    none,  ///< neither has one
    same,
    appeared,
    gone,
    grown,
    shrunk,
    not_comparable  ///< one of the two has no answer
};

/// As JSON calls it.
std::string name_of(GapChange change);

/// One number in both diagnoses, or in one.
struct NumberChange {
    std::string name, unit;
    FoundNumber::Of of = FoundNumber::Of::parameter;
    std::optional<FittedParameter> before, after;
    double change = 0;           ///< after − before; NaN where one lacks it
    double standard_errors = 0;  ///< the change in standard errors of itself; NaN where one lacks it

    bool in_both() const { return before && after; }
    bool moved(double errors) const;  ///< by more than so many standard errors
};

struct DiagnosisComparison {
    DiagnosisFacts before, after;
    GapChange gap = GapChange::none;
    std::vector<std::string> appeared, gone, kept;  ///< causes
    bool perhaps_same_cause = false;                ///< one of them could not tell its cause from the other's
    std::vector<NumberChange> numbers;              ///< those that moved most standard errors first
};

/// A number has moved beyond what noise does once in 370 times.
constexpr double standard_errors_of_a_move = 3;
/// A gap of this share more, or less, is another gap: repeats of one motion differ by some hundredths.
constexpr double share_of_another_gap = 0.1;

DiagnosisComparison compare_diagnoses(DiagnosisFacts before, DiagnosisFacts after);

}  // namespace stickslip
