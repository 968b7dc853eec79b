// The impulse response of a `kernel` law from a file.
#pragma once
#include "analysis/friction/kernel_table.h"
#include "analysis/results/quantity.h"

#include <filesystem>

namespace stickslip {

/// Two columns, time [s] and g [N/m | N·m/rad], CSV or .csv.gz; a header row, whose units are converted, and `#`
/// comments may stand above. The first time is 0. Throws BadInput with the place of the first row that does not fit.
KernelTable read_kernel_table(const std::filesystem::path& file, Units units);

}  // namespace stickslip
