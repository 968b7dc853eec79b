// Beside tests of the diagnosis: what their thresholds were compared with, printed at the end as a line of JSON.
#include "tests/evidence/comparisons.h"

#include <cstdio>

namespace {

struct AtTheEnd {
    ~AtTheEnd()
    {
        const nlohmann::ordered_json line{{"case", "tests"}, {"thresholds", stickslip::evidence::comparisons()}};
        std::fprintf(stderr, "%s\n", line.dump().c_str());
    }
} at_the_end;

}  // namespace
