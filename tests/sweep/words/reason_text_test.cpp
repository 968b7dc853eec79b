// Why a verdict is open, in words.
#include "sweep/words/reason_text.h"

#include <catch2/catch.hpp>

using namespace stickslip;
using Catch::Matchers::Contains;

TEST_CASE("of a motion that runs away no spring or damper is denied: a late loop may have both", "[report]")
{
    NonlinearVerdict verdict;
    verdict.reason = Reason::diverges;
    CHECK_THAT(reason_text(verdict), Contains("runs away") && !Contains("spring") && !Contains("damper"));
}
