// corrected-joint.toml: the joint with everything that a diagnosis found in it.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/results/diagnosis.h"

#include <string>

namespace stickslip {

/// As the program reads joints, with the findings in a comment at its head; empty where nothing was named.
std::string corrected_joint_text(const Diagnosis& d, const Joint& documented, const Joint& after);

}  // namespace stickslip
