// What a page says of the program that wrote it.
#pragma once
#include "analysis/results/report.h"
#include "sweep/engine/build.h"

namespace stickslip {

/// The report with the program's version before the rest of its provenance.
inline Report with_version(Report report)
{
    report.provenance.insert(report.provenance.begin(), {"version", program_version()});
    return report;
}

}  // namespace stickslip
