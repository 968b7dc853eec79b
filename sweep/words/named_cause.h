// How sure an answer is of the cause that it names, alone and with others.
#pragma once
#include "analysis/results/diagnosis.h"

#include <string>
#include <vector>

namespace stickslip {

/// The named cause, then those that the records cannot distinguish from it; one name where only its law is open.
std::vector<std::string> one_of(const Diagnosis& d);

/// The causes that the records cannot distinguish from the named one, or that its law is open.
std::string rivals_text(const Diagnosis& d);

/// The candidate that has the named cause and another one, and predicts held-out data better; none where no such
/// candidate is worth a reader's time.
const Cause* wider_cause(const Diagnosis& d);

/// "alone 50 %, with load-dependent friction 33 %", of the named cause and the wider one.
std::string alone_or_wider(const Diagnosis& d, const Cause& wider);

/// That it is the cause or a part of it: with a wider cause, of all candidates that have it.
double probability_of_part(const Diagnosis& d);

/// "The gap comes from …", as sure as the records are.
std::string said_by_probability(const Diagnosis& d);

}  // namespace stickslip
