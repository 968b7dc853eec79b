// How a plan looks as a NetCDF file: names of dimensions, variables and their attributes. Documented in README.md.
#pragma once
#include "sweep/engine/netcdf_file.h"
#include "sweep/engine/plan.h"
#include "sweep/engine/row_format.h"

#include <string>
#include <vector>

namespace stickslip {

/// One name an axis: the last part of its path ("k_p"); with as many parts more ("motor_A") as it takes to differ from
/// the other axes and from all columns, with a number appended if even the whole path does not.
std::vector<std::string> dimension_names(const std::vector<Axis>& axes);

/// The variables of a results file, in the order of RowFormat.
struct ResultsVariables {
    std::vector<int> numbers, codes;
};

/// Writes dimensions, coordinates, variables and attributes of the plan into a new file. The same bytes for the same
/// plan.
ResultsVariables define_results(const NetcdfFile& file, const Plan& plan, const RowFormat& format);

}  // namespace stickslip
