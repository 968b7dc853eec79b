// What a joint file says and a linear verdict cannot use is told by every verb: on the terminal, first on its page, in
// its JSON; and such a verdict is never green.
#include "tests/program/run.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using Catch::Matchers::Contains;
using Json = nlohmann::json;
using program::stickslip;

namespace {

// slides smoothly for every gain; a gear that loses more when driven back is a kink that no linear system has
constexpr const char* joint =
    "[joint]\ninertia = 1.0\n"
    "[control]\nk_p = 1e4\nk_v = 100.0\nV0 = 1e-2\nperiod = 1e-3\n"
    "velocity_estimate = { form = \"backward-difference\" }\n"
    "[friction]\nlaw = \"coulomb-viscous\"\ncoulomb = 3.0\nviscous = 5.0\n"
    "[sensor]\nposition_noise = 1e-6\n";
constexpr const char* axes =
    "[axes]\n\"control.k_p\" = { from = 1e3, to = 1e6, points = 5, scale = \"log\" }\n"
    "\"control.k_v\" = { from = 10.0, to = 1e3, points = 5, scale = \"log\" }\n";
constexpr const char* gear = "[friction.gear]\nforward = 0.1\nbackward = 0.2\n";

const char* const verbs[] = {"evaluate {} ", "margins {} ", "boundary {} --along control.k_p=1e3..1e8 ",
                             "design {} --require position_noise=1e-6 --require sample_time=1e-3 --effort 0.1 ",
                             "sweep {} "};

std::string call(std::string verb, const std::string& file)
{
    return verb.replace(verb.find("{}"), 2, "'" + file + "'");
}

}  // namespace

TEST_CASE("every verb tells the term that its linear theory lacks, and is not green", "[program][loop]")
{
    program::Folder folder;
    const auto bare = folder.write("bare.toml", std::string(joint) + axes);
    const auto geared = folder.write("geared.toml", std::string(joint) + gear + axes);
    for (const std::string verb : verbs) {
        INFO(verb);
        const auto name = verb.substr(0, verb.find(' '));
        const std::string out = " -o '" + folder / name + "'";
        const auto said = stickslip(call(verb, geared) + out);
        INFO(said.output);
        REQUIRE((said.exit_code == 0 || (name == "evaluate" && said.exit_code == 4)));  // its motion is undecided
        CHECK_THAT(said.output, Contains("Not used, though it may change the verdict: friction.gear."));
        const auto page = program::read(folder / name + "/report.html");
        CHECK_THAT(page, Contains("class=\"verdict warning\"") && Contains("may change the verdict: friction.gear."));
        const auto loop = Json::parse(stickslip(call(verb, geared) + out + " --json").output)["loop"];
        CHECK(loop["kind"] == "sampled");
        REQUIRE(loop["used"].size() > 0);
        CHECK(loop["used"][0] == "control.period");
        CHECK(std::ranges::any_of(loop["not_used"], [](const Json& term) {
            return term["key"] == "friction.gear" && term["matters"] == true && term["why_code"] == "load-direction";
        }));
        // without the gear the same answer is a clean yes
        const std::string clean = folder / (name + "-bare");
        REQUIRE(stickslip(call(verb, bare) + " -o '" + clean + "'").exit_code == 0);
        CHECK_THAT(program::read(clean + "/report.html"), Contains("class=\"verdict good\""));
    }
}

TEST_CASE("a page about the ideal loop begins with it, and is green only where the loop as it is slides, too",
          "[program][loop]")
{
    program::Folder folder;
    // the reference joint: stable above 53.9 kN/m in the ideal loop, above 65.7 kN/m behind one tick of dead time
    const auto late =
        folder.write("late.toml",
                     "[joint]\ninertia = 1.0\n[control]\nk_p = 60e3\nk_v = 10.0\nV0 = 1e-3\n"
                     "period = 1e-3\ndelay = 1e-3\nvelocity_estimate = { form = \"backward-difference\" }\n"
                     "[friction]\nlaw = \"rate-and-state\"\nf0 = 60.0\nA = 1.0\nB = 1.5\nL = 1e-5\n"
                     "V_star = 1e-3\n");
    for (const std::string verb : {"margins {} ", "boundary {} --along control.k_p=1e3..1e8 "}) {
        INFO(verb);
        const auto page_of = [&](const std::string& k_p) {
            const std::string out = folder / k_p;
            const auto said =
                stickslip(call(verb, late) + "--ideal-loop --set control.k_p=" + k_p + " -o '" + out + "'");
            INFO(said.output);
            CHECK(said.exit_code == 0);
            return program::read(out + "/report.html");
        };
        CHECK_THAT(page_of("60e3"),
                   Contains("class=\"verdict warning\"") && Contains("ideal loop.") &&
                       Contains("In the sampled loop as it is, sliding at this velocity is unstable."));
        CHECK_THAT(page_of("80e3"), Contains("class=\"verdict good\"") && Contains("ideal loop.") &&
                                        Contains("In the sampled loop as it is, sliding at this velocity is stable."));
    }
}
