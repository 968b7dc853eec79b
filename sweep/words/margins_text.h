// How far a design is from its boundaries, in words.
#pragma once
#include "analysis/results/report.h"
#include "sweep/study/margins_answer.h"

#include <string>
#include <vector>

namespace stickslip {

/// "f_{0} − A"
std::string coordinate_text(const Coordinate& coordinate, Units units);

/// "−10.2 %" of a share.
std::string signed_percent(double share);

/// Of the parameter at a path of the joint.
Quantity quantity_of(const Joint& joint, const std::string& path);

/// One factor of e each: margins_of measures the nearest boundary in plain logarithms.
std::vector<double> scales_of(const MarginsAnswer& answer);

/// One row a parameter: value, boundary, change.
Table alone_table(const MarginsAnswer& answer);

/// The answer in a few sentences, mark-up.
std::string margins_text(const MarginsAnswer& answer);

}  // namespace stickslip
