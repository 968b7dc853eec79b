// How far a design is from its boundaries, in words.
#pragma once
#include "analysis/results/report.h"
#include "sweep/study/margins_answer.h"

#include <string>
#include <vector>

namespace stickslip {

/// "f_{0} − A"
std::string coordinate_text(const Coordinate& coordinate, Units units);

/// The same of the coordinate in this place, with its body where the joint has several of that symbol: "F_{c} of the
/// motor".
std::string alone_name(const MarginsAnswer& answer, std::size_t place);

/// "−10.2 %" of a share.
std::string signed_percent(double share);

/// One row a parameter: value, boundary, change.
Table alone_table(const MarginsAnswer& answer);

/// The same as lines of a terminal.
std::string alone_lines(const MarginsAnswer& answer);

/// For the top of a page: the nearest boundary, that of one parameter alone, how far all may be off, the worst joint.
std::vector<Headline> margins_headlines(const MarginsAnswer& answer);

/// The answer in a few sentences, mark-up.
std::string margins_text(const MarginsAnswer& answer);

}  // namespace stickslip
