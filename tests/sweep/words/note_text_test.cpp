#include "sweep/words/diagnosis_text.h"

#include <catch2/catch.hpp>

#include <set>
#include <string>

using namespace stickslip;
using Catch::Contains;
using Code = Note::Code;

TEST_CASE("every code of a note has a name of its own and a sentence of its own", "[report]")
{
    std::set<std::string> names, sentences;
    for (int i = 0; i < Note::number_of_codes; ++i) {
        const auto code = static_cast<Code>(i);
        INFO(name_of(code));
        CHECK(names.insert(std::string(name_of(code))).second);
        const Note note{code,       "a.csv",         {"one", "two", "three"},
                        "velocity", {2, 3, 4, 5, 6}, std::string(name_of(code))};
        const std::string text = note_text(note);
        CHECK_THAT(text, Catch::StartsWith("a.csv: "));
        CHECK(text == "a.csv: " + remark_text(note));
        CHECK(sentences.insert(text).second);
        CHECK_THAT(text, !Catch::Matches(".*\\{[a-z0-9:].*"));  // no place left; TOML has a space in its braces
    }
}

TEST_CASE("why the nearest cause is not the answer is said from its code and numbers", "[report]")
{
    CHECK(note_text({.code = Code::takes_too_little, .names = {"stribeck", "viscous"}, .values = {0.31, 0.8}}) ==
          "Stribeck friction with viscous friction comes nearest, but explains only 31 % of what corrected parameters "
          "leave, of which 80 % "
          "is explainable");
    Note force{.code = Code::nearer_force, .names = {"gravity"}, .signal = "position"};
    CHECK_THAT(note_text(force), Contains("gravity comes nearest, but a force that depends on the position alone"));
    force.signal = "hysteresis";
    CHECK_THAT(note_text(force), Contains("a force that depends on where the position turned (hysteresis)"));
    CHECK_THAT(note_text({.code = Code::unexplained, .values = {0.58}}), Contains("the best leaves 58 % of it"));
    CHECK(note_text({.text = "as {it} stands"}) == "as {it} stands");
    CHECK(note_text({.code = Code::rig_laws_alike, .names = {"frictional-memory", "slip", "time", "ageing"}}) ==
          "the law of frictional memory is ambiguous: these data cannot distinguish the slip law, the time law and the "
          "ageing law");
    CHECK(note_sentence({.text = "no cause fits"}) == "No cause fits.");
    CHECK(note_sentence({.text = "k_p is off"}) == "k_p is off.");
    CHECK(note_sentence({.record = "a.csv", .text = "no cause fits"}) == "a.csv: no cause fits.");
    CHECK(note_text({.code = Code::interrupted_early, .names = {"reading", "fitting-singles", "climbing-ladder"}}) ==
          "interrupted while reading, and before fitting single effects, climbing the ladder where needed: no result "
          "yet");
}

TEST_CASE("the numbers of a note stand in its sentence as they are", "[report]")
{
    CHECK(note_text({.code = Code::holes, .record = "a.csv", .values = {1, 1.999, 2.5}}) ==
          "a.csv: 1 hole in time, the first from 1.999 s to 2.5 s: the rows after a hole are a separate record");
    CHECK_THAT(note_text({.code = Code::holes, .values = {3, 1, 2}}), Catch::StartsWith("3 holes in time"));
    CHECK_THAT(note_text({.code = Code::another_joint,
                          .names = {"gain-k_p.factor", "encoder-quantum.value"},
                          .values = {1.0833333, 1e-5}}),
               Contains("in 2 ways (gain-k_p.factor = 1.083, encoder-quantum.value = 1e-05); if"));
    CHECK(note_text({.code = Code::same_settings, .record = "t.csv", .values = {2, 100}}) ==
          "t.csv: lines 2, 100 have the same settings and both outcomes");
    CHECK_THAT(note_text({.code = Code::gains_not_judged, .values = {0.25}}), Contains("(misfit 0.25 of its rms)"));
    CHECK(note_text({.code = Code::rejected_in_many_floors, .names = {"stribeck"}, .values = {7.5}}) ==
          "Stribeck friction fits best, but leaves 7.5 times the noise floor on held-out data, and the joint file "
          "states no "
          "sensor noise: it is not "
          "named as the cause");
}

TEST_CASE("a note that lacks what its sentence says is an error and no half sentence", "[report]")
{
    CHECK_THROWS(note_text({Code::takes_too_little}));
    CHECK_THROWS(note_text({.code = Code::too_few_rows, .record = "a.csv", .values = {12}}));
}
