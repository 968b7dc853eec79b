// That an answer lacks a part or contradicts itself, as the first thing that is said of it.
#pragma once
#include <string>
#include <vector>

namespace stickslip {

struct NonlinearVerdict;

/// What of an outcome is undecided, with the reason.
std::string open_ending_text(const NonlinearVerdict& verdict);

/// The same before the verdict on small disturbances.
std::string open_text(const NonlinearVerdict& verdict);

/// One sentence before the linear verdict where the simulation, which has these terms that the linear theory lacks,
/// shows the opposite: that small disturbances grow, or that they decay.
std::string contradicted_text(const std::vector<std::string>& terms, bool grows);

}  // namespace stickslip
