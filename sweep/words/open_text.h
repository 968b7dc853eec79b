// That an answer lacks a part or contradicts itself, as the first thing that is said of it.
#pragma once
#include <string>

namespace stickslip {

struct LinearVerdict;
struct NonlinearVerdict;

/// One sentence about an outcome that is undecided, with the reason, before the verdict on small disturbances.
std::string open_text(const NonlinearVerdict& verdict);

/// One sentence before the linear verdict where the simulation, which has terms that the linear theory lacks, shows the
/// opposite; empty where the two agree.
std::string contradicted_text(const LinearVerdict& linear, const NonlinearVerdict& motion);

}  // namespace stickslip
