// A design of gains as a page.
#pragma once
#include "analysis/results/report.h"
#include "sweep/words/design_text.h"

#include <vector>

namespace stickslip {

/// `snippets`: the gains to take into the joint file, and the file.
Report design_report(const DesignAnswer& answer, std::vector<Snippet> snippets = {});

}  // namespace stickslip
