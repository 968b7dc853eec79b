// What a record must be before anything is concluded from it.
#pragma once
#include "analysis/diagnosis/records/record.h"
#include "analysis/joint/joint.h"
#include "analysis/results/cannot_answer.h"
#include "analysis/results/note.h"

#include <vector>

namespace stickslip::gap {

struct Inspection {
    std::vector<CannotAnswer> errors;  ///< the record cannot be used at all: bad input
    std::vector<Note> shortages;       ///< it can be read, but nothing can be concluded: insufficient data
    std::vector<Note> notes;           ///< suspected units, missing columns and what they cost
};

/// Time missing, unsorted or repeated, values that are not numbers, columns of unequal length: errors. Too few rows,
/// nothing moves: shortages. Units that look wrong against the joint (degrees, millimetres): notes.
Inspection inspect(const Record& record, const Joint& joint);

}  // namespace stickslip::gap
