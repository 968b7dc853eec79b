// What a joint file says and a linear verdict cannot use is told by every verb: on the terminal, first on its page, in
// its JSON; and such a verdict is never green.
#include "tests/program/run.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include <string>
#include <vector>

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

using Verbs = std::vector<std::string>;
const Verbs fast{"margins {} --effort 0.1 ", "boundary {} --along control.k_p=1e3..1e8 "};
const Verbs slow{"evaluate {} ", "margins {} ",
                 "design {} --require position_noise=1e-6 --require sample_time=1e-3 --effort 0.1 ", "sweep {} "};

std::string call(std::string verb, const std::string& file)
{
    return verb.replace(verb.find("{}"), 2, "'" + file + "'");
}

}  // namespace

namespace {

/// Each says which term its linear theory lacks, and is not green.
void say_what_they_lack(const Verbs& verbs)
{
    program::Folder folder;
    const auto bare = folder.write("bare.toml", std::string(joint) + axes);
    const auto geared = folder.write("geared.toml", std::string(joint) + gear + axes);
    for (const auto& verb : verbs) {
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

}  // namespace

TEST_CASE("margins and boundary name the term that their linear theory lacks, and are not green",
          "[program][loop][slow]")
{
    say_what_they_lack(fast);
}

TEST_CASE("every other verb names the term that its linear theory lacks, and is not green", "[program][loop][slow]")
{
    say_what_they_lack(slow);
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

namespace {

// the reference joint of the paper behind one tick of dead time, smooth in the ideal loop only
constexpr const char* late_joint =
    "[joint]\ninertia = 1.0\n[control]\nk_p = 60e3\nk_v = 10.0\nV0 = 1e-3\n"
    "period = 1e-3\ndelay = 1e-3\nvelocity_estimate = { form = \"backward-difference\" }\n"
    "[friction]\nlaw = \"rate-and-state\"\nf0 = 60.0\nA = 1.0\nB = 1.5\nL = 1e-5\nV_star = 1e-3\n";

}  // namespace

namespace {

/// With --ideal-loop the JSON of each says which loop was left out.
void say_which_loop_they_leave_out(const Verbs& verbs)
{
    program::Folder folder;
    const auto file = folder.write("late.toml", std::string(late_joint) + axes);
    for (const auto& verb : verbs) {
        INFO(verb);
        const std::string out = folder / verb.substr(0, verb.find(' '));
        const auto loop_of = [&](const std::string& option) {
            const auto said = stickslip(call(verb, file) + option + " --json 2>/dev/null -o '" + out + option + "'");
            return Json::parse(said.output)["loop"];
        };
        const auto loop = loop_of("--ideal-loop");
        CHECK(loop["kind"] == "ideal");
        REQUIRE(loop["left_out"].is_object());
        CHECK(loop["left_out"]["kind"] == "sampled");
        CHECK(loop["left_out"]["keys"] == Json({"control.period", "control.delay", "control.velocity_estimate.form"}));
        CHECK(loop["left_out"]["spectral_abscissa"].is_number());
        CHECK(loop_of("")["left_out"].is_null());
    }
}

}  // namespace

TEST_CASE("with --ideal-loop the JSON of margins and boundary says which loop was left out", "[program][loop]")
{
    say_which_loop_they_leave_out(fast);
}

TEST_CASE("with --ideal-loop the JSON of every other verb says which loop was left out", "[program][loop][slow]")
{
    say_which_loop_they_leave_out(slow);
}

TEST_CASE("a sweep of the ideal loop says so on its page, also when that is drawn again", "[program][loop][slow]")
{
    program::Folder folder;
    const auto file = folder.write("late.toml", std::string(late_joint) + axes);
    const std::string out = folder / "out", again = folder / "again";
    const auto said = stickslip("sweep '" + file + "' --ideal-loop -o '" + out + "'");
    CHECK_THAT(said.output, Contains("In the paper's ideal loop."));
    REQUIRE(stickslip("report '" + out + "' -o '" + again + "'").exit_code == 0);
    std::filesystem::remove(out + "/answer.json");  // as after a merge: everything but the points is computed again
    const std::string merged = folder / "merged";
    REQUIRE(stickslip("report '" + out + "' -o '" + merged + "'").exit_code == 0);
    for (const auto& page : {out, again, merged}) {
        INFO(page);
        CHECK_THAT(program::read(page + "/report.html"),
                   Contains("class=\"verdict warning\"") && Contains("ideal loop. ") &&
                       Contains("--ideal-loop leaves out control.period, control.delay") &&
                       Contains("In the sampled loop as it is, sliding at this velocity is unstable."));
    }
}

TEST_CASE("an axis over what --ideal-loop leaves out is refused", "[program][loop]")
{
    program::Folder folder;
    const auto joint = folder.write("joint.toml", late_joint);
    std::string cascade = late_joint;
    cascade.replace(cascade.find("k_p = 60e3\nk_v = 10.0\n"), 22,
                    "structure = \"cascade\"\nposition_gain = 100.0\nvelocity_gain = 600.0\n");
    const auto of = [&](const std::string& name, const std::string& text, const std::string& path) {
        return "'" + folder.write(name, text + "[axes]\n\"" + path + "\" = { from = 1e-3, to = 4e-3, points = 3 }\n") +
               "'";
    };
    for (const auto& [line, path] :
         {std::pair<std::string, std::string>{"sweep " + of("period.toml", late_joint, "control.period"),
                                              "control.period"},
          {"sweep " + of("gain.toml", cascade, "control.position_gain"), "control.position_gain"},
          {"boundary '" + joint + "' --along control.delay=1e-4..1e-2", "control.delay"},
          {"margins '" + joint +
               "' --uncertain friction.L=10% --over control.k_p "
               "control.period=1e-4..1e-3",
           "control.period"}}) {
        const auto said = stickslip(line + " --ideal-loop -o '" + folder / "out" + "'");
        INFO(said.output);
        CHECK(said.exit_code == 2);
        CHECK_THAT(said.output, Contains("--ideal-loop: leaves out " + path + ", expected axes"));
    }
}
