// Which numbers of a spec's joint differ from those of a baseline: what has moved the boundaries.
#pragma once
#include "sweep/study/spec.h"

#include <map>
#include <string>
#include <vector>

namespace stickslip {

/// Every number of the design point that is set, by its path.
std::map<std::string, double> numbers_of(const Spec& spec);

struct ChangedNumber {
    std::string path;
    double before = not_set, after = not_set;  ///< not set: the joint has no such number
};

std::vector<ChangedNumber> changed_numbers(const std::map<std::string, double>& before,
                                           const std::map<std::string, double>& after);

}  // namespace stickslip
