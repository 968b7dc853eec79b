// The rows of a table of outcomes as joints, and what the rows say about one another. Internal to
// analysis/diagnosis/outcomes.
#pragma once
#include "analysis/diagnosis/outcomes/law_fit.h"
#include "analysis/results/note.h"

namespace stickslip::gap {

/// Throws CannotAnswer for a joint that a table of outcomes cannot be read against.
void refuse_unfit(const Joint& joint, const OutcomeTable& table);

/// The joint with the settings of a row; a commanded force rate becomes the velocity that it means.
Joint joint_at(const Joint& nominal, const OutcomeTable& table, const std::vector<double>& settings);

/// One joint a row, and the scales of the fit. Throws CannotAnswer for a row without velocity or stiffness.
Outcomes prepared(const Joint& nominal, const OutcomeTable& table);

/// Rows that say the opposite of most rows with the same settings; half of them where they are equally many.
int contradictions(const OutcomeTable& table, std::vector<Note>& notes);

}  // namespace stickslip::gap
