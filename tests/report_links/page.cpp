// Links what draws the pages of a sweep, of a joint and of boundaries from their answers; report_links.py looks at what
// came with it.
#include "sweep/report/pages/boundary_report.h"
#include "sweep/report/pages/linear_report.h"
#include "sweep/report/pages/stability_report.h"

int main()
{
    using namespace stickslip;
    const Report sweep = stability_report({}, {}, {}), joint = linear_report({}, {});
    const Report boundaries = boundary_report({});
    return sweep.title.empty() || joint.title.empty() || boundaries.title.empty();
}
