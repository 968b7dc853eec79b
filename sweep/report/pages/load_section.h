// A joint under the normal loads of a record, on a page and in numbers.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/results/report.h"
#include "analysis/stability/load_study.h"

namespace stickslip {

/// Growth rates and critical gain over the range of loads. The study has loads.
Section load_section(const Joint& joint, const LoadStudy& study);

/// The same in lines of label and value.
Table load_table(const Joint& joint, const LoadStudy& study);

}  // namespace stickslip
