// From records to cases: per-record overrides, clock, scales.
#pragma once
#include "analysis/diagnosis/fit/fit.h"
#include "analysis/diagnosis/records/record.h"
#include "analysis/results/note.h"

namespace stickslip::gap {

/// The joint with the numbers that held in this record. Throws std::invalid_argument for an override whose path the
/// joint does not have.
Joint joint_in(const Record& record, const Joint& nominal);

/// A case from a record: overrides applied, put on its clock, noise as documented or, where the joint does not say or
/// the record shows a quarter more, as estimated; `notes` says which. Throws as joint_in() does.
Case prepare(const Record& record, const Joint& nominal, std::vector<Note>& notes);

/// What one of everything means for these cases.
Scales scales_of(const std::vector<Case>& cases);

/// What the integrals held where the records begin, by the controllers that the cases have now.
void find_integrals(std::vector<Case>& cases);

}  // namespace stickslip::gap
