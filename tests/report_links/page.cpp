// Links what draws the page of a sweep from its answers; report_links.py looks at what came with it.
#include "sweep/report/pages/linear_report.h"
#include "sweep/report/pages/stability_report.h"

int main()
{
    using namespace stickslip;
    const Report sweep = stability_report({}, {}, {}), joint = linear_report({}, {});
    return sweep.title.empty() || joint.title.empty();
}
