// --guarantee: a set of causes with a promise, from answered blind cases.
#pragma once
#include "sweep/program/verbs/diagnose_joint.h"
#include "sweep/study/guarantee/calibration.h"

#include "sweep/program/verbs/command_line.h"

#include <optional>
#include <string>
#include <vector>

namespace stickslip {

struct GuaranteeOption {
    double coverage = 0;  ///< 0: none was requested
    std::vector<std::string> files;

    void add_to(Verb& verb);
    bool asked() const { return coverage > 0; }
};

/// A promise that holds for this joint and these records.
struct Guarantee {
    guarantee::Calibration calibration;
    guarantee::Promise promise;
};

/// Empty where none was requested. Throws BadInput that says what is missing where the promise cannot be given: before
/// anything is computed, and never silently.
std::optional<Guarantee> guarantee_for(const GuaranteeOption& option, const Joint& joint,
                                       const std::vector<Record>& records);

/// Puts the set into an answer that concludes something.
void add_set(const Guarantee& guarantee, JointDiagnosis& found);

/// Where joint and records stand among those of a population.
guarantee::Place place_among(const Joint& joint, const std::vector<Record>& records);

/// What the diagnosis answered, as blind cases are scored.
blind::Answer answer_of(const Diagnosis& diagnosis);

}  // namespace stickslip
