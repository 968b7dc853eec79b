// Links what draws every page from its answer; report_links.py looks at what came with it. An archive gives the objects
// that are called and no others.
#include "sweep/report/pages/boundary_report.h"
#include "sweep/report/pages/check_report.h"
#include "sweep/report/pages/compare_report.h"
#include "sweep/report/pages/diagnosis_report.h"
#include "sweep/report/pages/figures_report.h"
#include "sweep/report/pages/linear_report.h"
#include "sweep/report/pages/margins_report.h"
#include "sweep/report/pages/outcome_report.h"
#include "sweep/report/pages/record_report.h"
#include "sweep/report/pages/robot_report.h"
#include "sweep/report/pages/set_point_design_report.h"
#include "sweep/report/pages/stability_report.h"
#include "sweep/report/pages/timeline_report.h"

namespace {

/// Every maker of a page, so that the linker has to find each: report_links.py compares the list with the headers.
template <class... Makers>
bool all_linked(Makers... makers)
{
    const void* volatile held[] = {reinterpret_cast<const void*>(makers)...};
    for (const void* maker : held)
        if (!maker) return false;
    return true;
}

}  // namespace

int main()
{
    using namespace stickslip;
    const bool all = all_linked(boundary_report, check_report, compare_report, comparison_report, diagnosis_report,
                                figures_report, linear_report, margins_report, outcome_report, record_report,
                                robot_report, set_point_design_report, stability_report, timeline_report);
    return all ? 0 : 1;
}
