// Beside tests of the diagnosis: what their thresholds were compared with, printed at the end as a line of JSON. The
// environment variable STICKSLIP_CHANGED names thresholds with other values: NAME=VALUE NAME=VALUE.
#include "tests/evidence/change.h"
#include "tests/evidence/comparisons.h"

#include <cstdio>
#include <cstdlib>
#include <sstream>

namespace {

struct BesideTests {
    BesideTests()
    {
        const char* changed = std::getenv("STICKSLIP_CHANGED");
        std::istringstream words(changed ? changed : "");
        for (std::string word; words >> word;) stickslip::evidence::change(word);
    }
    ~BesideTests()
    {
        const nlohmann::ordered_json line{{"case", "tests"}, {"thresholds", stickslip::evidence::comparisons()}};
        std::fprintf(stderr, "%s\n", line.dump().c_str());
    }
} beside_tests;

}  // namespace
