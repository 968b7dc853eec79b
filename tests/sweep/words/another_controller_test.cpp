// A mechanism that is as documented, behind a controller that is not.
#include "sweep/words/diagnosis_first_screen.h"

#include <catch2/catch.hpp>

using namespace stickslip;
using Catch::Matchers::Contains;

TEST_CASE("a mechanism without a gap behind another controller is not called a joint without one", "[words]")
{
    Diagnosis d;
    d.verdict = Verdict::no_gap;
    d.signals = {{"effort", 1, {1, 1}, 1.5, 0.04, "N"}, {"motion", 0, {0, 0}, 0.01, 0.01, "N"}};
    d.reasons = {{Note::Code::within_noise}};
    CHECK(diagnosis_sentence(d) == "No gap: the nominal joint predicts the records to within noise.");
    d.reasons.insert(d.reasons.begin(), {.code = Note::Code::no_such_controller, .values = {0.11}});
    CHECK_THAT(diagnosis_sentence(d), Contains("No gap in the mechanism") && Contains("Another controller"));
    CHECK(where_card(d).value == "effort");
    CHECK(what_card(d).tone == Headline::Tone::warning);
}
