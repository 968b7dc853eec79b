// Which friction law explains a table of measured outcomes.
#pragma once
#include "analysis/diagnosis/outcomes/law_fit.h"
#include "analysis/diagnosis/search/attribute.h"
#include "analysis/results/diagnosis.h"
#include "analysis/results/diagnosis_stage.h"

namespace stickslip::gap {

/// Where the two best explanations differ most: what to measure next.
struct NextOutcome {
    std::vector<double> settings;  ///< SI, one for each path of the table; empty: nothing is left to distinguish
    double one = 0, two = 0;       ///< probability of stick-slip by each
};

/// What explain() found, and what it was found from.
struct OutcomeAnswer {
    Diagnosis diagnosis;       ///< verdict, causes and gap, as of records
    Joint after;               ///< the nominal joint with the winning law; equal to it where nothing was named
    Outcomes outcomes;         ///< the rows, each with its joint
    LawFit nominal;            ///< the joint as documented
    std::vector<LawFit> laws;  ///< most probable first
    std::vector<std::string_view> alike;  ///< laws that the rows cannot distinguish from the best one
    NextOutcome next;                     ///< what to measure next
    int contradictions = 0;               ///< rows that say the opposite of most rows with the same settings
};

/// Fits every friction law to the rows, judges each by rows that its fit has not seen, and ranks them. `gap`: the
/// nominal joint does not explain the rows and a law does. Throws std::invalid_argument for a joint whose boundary the
/// rows cannot be read against (several masses, contact stiffness) and for settings that it lacks or may not take.
/// `rivals` outlive the answer. `checkpoint` is called before every row is looked at, and may throw to end early.
OutcomeAnswer explain(const Joint& nominal, const OutcomeTable& table, const ParallelFor& parallel,
                      const StageProgress& progress = {}, std::span<const RivalLaw> rivals = rival_laws(),
                      const std::function<void()>& checkpoint = {});

}  // namespace stickslip::gap
