// A cause that is named alone, while a candidate with another one besides predicts better.
#include "sweep/words/named_cause.h"
#include "sweep/words/diagnosis_first_screen.h"

#include <catch2/catch.hpp>

using namespace stickslip;
using Catch::Matchers::Contains;

namespace {

Diagnosis with_pair()
{
    Diagnosis d;
    d.verdict = Verdict::gap;
    d.overall = {123, 49, 1, 0.6, {0.5, 0.7}};
    Cause alone, pair;
    alone.names = {"gain-k_p"}, alone.probability = 0.5;
    pair.names = {"gain-k_p", "load-dependent-friction"}, pair.probability = 0.33;
    pair.heldout_gain = 0.4, pair.heldout_gain_interval = {0.3, 0.6};
    d.effects = {alone, pair};
    return d;
}

}  // namespace

TEST_CASE("a pair that predicts held-out data better than the named cause is in the first sentence", "[words][gap]")
{
    const Diagnosis d = with_pair();
    CHECK(diagnosis_sentence(d) ==
          "The gap probably comes from position gain (alone 50 %, with load-dependent friction 33 %, which predicts "
          "held-out data better): on held-out data it shrinks from 123.00 to 49.00 times the noise floor with position "
          "gain alone.");
    CHECK_THAT(what_card(d).meaning,
               Contains("position gain with load-dependent friction predicts held-out data better"));
    CHECK(how_sure_card(d).value == "83 %");
    CHECK_THAT(how_sure_card(d).meaning, Contains("alone 50 %, with load-dependent friction 33 %"));
    CHECK(probability_of_part(d) == Approx(0.83));
}

TEST_CASE("a pair whose advantage may be chance, or that hardly anything speaks for, is not", "[words][gap]")
{
    Diagnosis d = with_pair();
    d.effects[1].heldout_gain_interval.low = -0.1;
    CHECK_THAT(diagnosis_sentence(d), Contains("The gap probably comes from position gain (50 %): on"));
    d = with_pair();
    d.effects[1].probability = 0.01;
    CHECK(wider_cause(d) == nullptr);
    d = with_pair();
    d.effects[1].names = {"load-dependent-friction"};  // another cause, and not a wider one
    CHECK(wider_cause(d) == nullptr);
}
