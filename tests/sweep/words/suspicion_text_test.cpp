// Every suspicion has words, and says in them what it carries.
#include "sweep/words/suspicion_text.h"
#include "sweep/words/diagnosis_text.h"

#include <catch2/catch.hpp>

#include <set>

using namespace stickslip;
using Catch::Contains;
using Code = Note::Code;

TEST_CASE("every code of a suspicion has a sentence of its own, and every other code has none", "[report]")
{
    std::set<std::string> sentences;
    int suspicions = 0;
    for (int i = 0; i < Note::number_of_codes; ++i) {
        const Note note{.code = static_cast<Code>(i), .names = {"a", "b", "c"}, .values = {2, 3, 4, 5, 6}};
        CAPTURE(name_of(note.code));
        if (is_suspicion(note.code)) {
            ++suspicions;
            sentences.insert(suspicion_text(note));
            CHECK(remark_text(note) == suspicion_text(note));
            CHECK(contradicts(note) == (note.code != Code::motor_off));
        } else {
            CHECK_THROWS_AS(suspicion_text(note), std::logic_error);
        }
    }
    CHECK(suspicions == 16);
    CHECK(sentences.size() == 16);
}

TEST_CASE("a suspicion says factors above one, and which way", "[report]")
{
    const auto says = [](Code code, double value) {
        return suspicion_text({.code = code, .names = {"velocity", "position_rate"}, .values = {value}});
    };
    CHECK_THAT(says(Code::unit_of_rate, 9.549), Contains("velocity is 9.5 times the rate of position;"));
    CHECK_THAT(says(Code::unit_of_rate, 0.1), Contains("velocity is 10 times less than the rate of position;"));
    CHECK_THAT(says(Code::unit_of_effort, 1000), Contains("varies by 1000 times as much as the command requires;"));
    CHECK_THAT(says(Code::unit_of_effort, 0.001), Contains("varies by 1000 times less than the command requires;"));
    CHECK_THAT(says(Code::gains_of_another_joint, 7), Contains("requires 7 times the logged command;"));
    CHECK_THAT(says(Code::gains_of_another_joint, 1 / 7.0), Contains("requires 7 times less than the logged command;"));
}
