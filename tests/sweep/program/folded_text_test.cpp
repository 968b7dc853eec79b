// Lines as a terminal of a given width gets them.
#include "sweep/program/verbs/folded_text.h"

#include <catch2/catch.hpp>

using namespace stickslip;

TEST_CASE("a line is broken between words, and goes on below its column", "[program]")
{
    CHECK(folded("to the noise floor of a very long record", 30) == "to the noise floor of a very\nlong record");
    CHECK(folded("  k_p  to the noise floor of a long one", 33, 7) ==
          "  k_p  to the noise floor of a\n       long one");
    CHECK(folded("short", 30) == "short");
    CHECK(folded("any length at all where a program reads the answer", 0) ==
          "any length at all where a program reads the answer");
    // letters count, not bytes: 30 of them
    CHECK(folded("µµµµµµµµµ µµµµµµµµµ µµµµµµµµµµ", 30) == "µµµµµµµµµ µµµµµµµµµ µµµµµµµµµµ");
    // a word that fits nowhere stays whole
    CHECK(folded("aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa b", 30) == "aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa\nb");
}

TEST_CASE("help keeps its columns, and examples stay whole", "[program]")
{
    const std::string option = "  -o,--output TEXT            directory for timeline.json and report.html\n";
    CHECK(folded_help(option, 61) ==
          "  -o,--output TEXT            directory for timeline.json and\n"
          "                              report.html\n");
    const std::string example = "Example: stickslip timeline runs -o elbow-over-time --joint elbow --json\n";
    CHECK(folded_help(example, 40) == example);
    CHECK(folded_help(option, 0) == option);
}
