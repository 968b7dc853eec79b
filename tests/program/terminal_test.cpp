// What a person at a terminal sees, and what a pipe gets instead: util-linux's script plays the terminal.
#include "tests/program/run.h"

#include <catch2/catch.hpp>

using Catch::Matchers::Contains;
using program::Folder;
using program::shell;

namespace {

/// The embedded sweep at a terminal, with these variables set.
std::string at_a_terminal(const Folder& folder, const std::string& variables, const std::string& rest)
{
    const auto run = shell(variables + " script -qec \"'" + STICKSLIP + "' sweep --fresh " + rest + " -o '" +
                           (folder / "out") + "'\" /dev/null </dev/null");
    REQUIRE(run.exit_code == 0);
    return run.output;
}

constexpr const char* coloured = "\033[3";

}  // namespace

TEST_CASE("a terminal gets progress with a rate, and colours unless they are unwanted", "[program][slow]")
{
    if (shell("command -v script >/dev/null").exit_code != 0) {
        WARN("skipped: script is not installed here");
        return;
    }
    Folder folder;
    const auto progress = at_a_terminal(folder, "TERM=xterm", "--no-report");
    CHECK_THAT(progress, Contains("points/s") && Contains(" left") && Contains("of 245025 points"));
    CHECK_THAT(progress, !Contains("e+0"));
    const auto spec = "examples/02-ball-screw/spec.toml";
    CHECK_THAT(at_a_terminal(folder, "TERM=xterm NO_COLOR=", spec), Contains(coloured));
    CHECK_THAT(at_a_terminal(folder, "TERM=xterm NO_COLOR=1", spec), !Contains(coloured));
    CHECK_THAT(at_a_terminal(folder, "TERM=dumb", spec), !Contains(coloured));
}

TEST_CASE("a joint that cannot be judged ends with exit code 4 and the reason", "[program]")
{
    const auto run = program::stickslip("evaluate examples/02-ball-screw/joint-with-memory.toml --set control.V0=0");
    INFO(run.output);
    CHECK(run.exit_code == 4);
    CHECK_THAT(run.output, Contains("undecided") && Contains("undefined at rest"));
}
