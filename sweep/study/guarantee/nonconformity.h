// How badly a cause fits an answer of the diagnosis: the score of the conformal sets.
#pragma once
#include "sweep/study/score.h"

#include <string>
#include <vector>

namespace stickslip::guarantee {

/// What may be behind a record: a cause of the catalogue by its name, or one of these two.
inline constexpr const char* no_gap = "no-gap";
inline constexpr const char* none_of_these = "none-of-these";

/// What was put into a case: every cause that acts, or one of the two above.
std::vector<std::string> causes_of(const blind::Truth& truth);

/// One minus the probability that the answer gives to this cause, alone or with others. An answer that concludes
/// nothing (insufficient data) excludes nothing, and all score 0.
double nonconformity(const blind::Answer& answer, const std::string& cause);

/// Of a whole case: the largest over all causes that act, each by its name or by one for the very same motion. A
/// document that is off may also be called that.
double nonconformity(const blind::Answer& answer, const blind::Truth& truth);

}  // namespace stickslip::guarantee
