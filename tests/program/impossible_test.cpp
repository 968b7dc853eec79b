// Requests that are bad or cannot be met get an answer that says so, with what is possible.
#include "tests/program/run.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using Catch::Matchers::Contains;
using Json = nlohmann::json;
using program::Folder;
using program::stickslip;

namespace {

const std::string strip = "boundary examples/03-bistable-strip/spec.toml ";
const std::string design = "design examples/04-design/spec.toml --require front_points=2 ";

}  // namespace

TEST_CASE("a disturbance of negative size is refused before anything is simulated", "[program][impossible]")
{
    for (const char* kind : {"position", "start"}) {
        const auto run =
            stickslip(strip + "--kind outcome --along control.k_p --size -1 --disturbance " + std::string(kind));
        INFO(run.output);
        CHECK(run.exit_code == 2);
        CHECK_THAT(run.output, Contains("--size: got -1, expected ") && Contains("≥ 0"));
    }
}

TEST_CASE("a range without boundaries is answered with the nearest one outside, of every kind",
          "[program][impossible][slow]")
{
    struct Case {
        const char *arguments, *says;
    };
    const Case cases[] = {
        {"--kind linear --along control.k_p=1e5..1e6", "stable throughout. The nearest one outside lies at k_p = 19.4"},
        {"--kind fold --along control.k_p=1e5..1e6", "The nearest one outside lies at k_p = 24.84"},
        {"--kind outcome --disturbance position --size 1e-4 --along control.k_p=6e4..1e5",
         "stable throughout. The nearest one outside lies at k_p = 24.8"},
        {"--kind v-min --along control.V0=2e-2..1e-1", "stable throughout. The nearest one outside lies at V_0 = 9.92"},
        {"--kind fold --set control.k_v=0 --along control.k_p=1e5..1e6", "either."},
    };
    for (const auto& c : cases) {
        const auto run = stickslip(strip + c.arguments);
        INFO(run.output);
        CHECK(run.exit_code == 0);
        CHECK_THAT(run.output, Contains(" along ") && Contains(c.says));
    }
    const auto json = Json::parse(stickslip(strip + "--kind fold --along control.k_p=1e5..1e6 --json").output);
    CHECK(json["lines"][0]["points"].empty());
    CHECK(json["lines"][0]["outside"]["nearest"]["value"].get<double>() == Approx(24849).epsilon(1e-4));
}

TEST_CASE("points without a verdict are not counted to either side", "[program][impossible][slow]")
{
    // a metre of offset: the joint is thrown back, and part of the motions end undecided
    const auto run = stickslip(strip + "--kind outcome --along control.k_p --disturbance position --size 1");
    INFO(run.output);
    CHECK(run.exit_code == 4);
    CHECK_THAT(run.output, Contains("scanned points that have a verdict; "));
    CHECK_THAT(run.output, !Contains("throughout"));
}

TEST_CASE("demands that no gains meet are answered with what could be", "[program][impossible][slow]")
{
    const auto margin = stickslip(design + "--require margin=60");
    INFO(margin.output);
    CHECK(margin.exit_code != 2);
    if (margin.exit_code == 1)
        CHECK_THAT(margin.output, Contains("the margin can be ") && Contains("(required: 60)") &&
                                      Contains("Nearest to feasible: k_p = "));
    const auto beyond = stickslip(design + "--require margin=200");
    CHECK(beyond.exit_code == 2);
    CHECK_THAT(beyond.output, Contains("within [0, 100]"));

    const auto weak = stickslip(design + "--require effort_limit=30 --json");
    INFO(weak.output);
    CHECK(weak.exit_code == 1);
    const auto json = Json::parse(weak.output);
    CHECK_THAT(json["answer"].get<std::string>(),
               Contains("Steady sliding alone takes 60 N.") && Contains("the peak effort can be 60.04"));
    CHECK(json["best"]["margin"].get<double>() > 1 - 1e-4);

    const auto faster = stickslip(design + "--require 'least_velocity=2 mm/s'");
    CHECK(faster.exit_code == 2);
    CHECK_THAT(faster.output, Contains("above the commanded velocity"));
    const auto stiff = stickslip(design + "--require k_p_from=1e300");
    CHECK(stiff.exit_code == 2);
    CHECK_THAT(stiff.output, Contains("k_p_to is 6e+07"));
}

TEST_CASE("an objective that is no finite number is said to be none", "[program][impossible][slow]")
{
    const auto run = stickslip(
        "design examples/01-reference-joint/spec.toml --require sample_time=1e-3 --require "
        "position_noise=1e300 --require front_points=2");
    INFO(run.output);
    CHECK(run.exit_code == 1);
    CHECK_THAT(run.output, Contains("not a finite number"));
    CHECK_THAT(run.output, !Contains("Best gains"));
}

TEST_CASE("a spec may ask for boundaries by itself", "[program][boundary]")
{
    Folder folder;
    auto text = program::read(std::string(SOURCE_ROOT) + "/examples/03-bistable-strip/spec.toml");
    text += "[boundary]\nkind = [\"linear\", \"fold\"]\nalong = \"control.k_p=1e4..5e4\"\nprecision = 1e-3\n";
    const auto spec = folder.write("spec.toml", text);
    const auto run = stickslip("boundary '" + spec + "' --json");
    INFO(run.output);
    REQUIRE(run.exit_code == 0);
    const auto json = Json::parse(run.output);
    REQUIRE(json["lines"].size() == 2);
    CHECK(json["curves"].empty());
    CHECK(json["lines"][0]["kind"] == "linear");
    CHECK(json["lines"][1]["kind"] == "fold");
    CHECK(json["lines"][0]["points"][0]["precision"].get<double>() > 1e-8);
    CHECK(json["lines"][1]["points"][0]["value"].get<double>() == Approx(24849).epsilon(1e-4));
    // the command line goes first
    const auto own =
        Json::parse(stickslip("boundary '" + spec + "' --kind velocity-only --along control.k_v --json").output);
    REQUIRE(own["lines"].size() == 1);
    CHECK(own["lines"][0]["kind"] == "velocity-only");
}

TEST_CASE("an evaluation that the usual work does not decide says how to allow more", "[program][impossible][slow]")
{
    const std::string joint = "evaluate tests/sweep/found/w12-stribeck.toml ";
    const auto cut = stickslip(joint + "--effort 0.02");
    INFO(cut.output);
    CHECK(cut.exit_code == 4);
    CHECK_THAT(cut.output, Contains("undecided") && Contains("--effort 10"));
    CHECK(cut.output.starts_with("Undecided how the motion ends after the disturbance: "));
    const auto json = Json::parse(stickslip(joint + "--effort 0.02 --json").output);
    CHECK(json["decided"] == false);
    CHECK(json["nonlinear"]["reason_detail"] == "limit-of-work");
    const auto whole = stickslip(joint + "--json");
    CHECK(whole.exit_code == 0);
    CHECK(Json::parse(whole.output)["decided"] == true);
}

TEST_CASE("a page whose nonlinear outcome is undecided says so first, and is not green", "[program][impossible][slow]")
{
    const Folder folder;
    // decided with the usual work
    const auto run =
        stickslip("evaluate tests/sweep/found/sampled-seven-ticks.toml --effort 0.1 -o '" + (folder / "page") + "'");
    INFO(run.output);
    CHECK(run.exit_code == 4);
    const auto page = program::read(folder / "page/report.html");
    CHECK_THAT(page, Contains("class=\"verdict warning\"") && !Contains("class=\"verdict good\""));
    const auto open = page.find("Undecided whether larger disturbances"), small = page.find("Slides smoothly at");
    CHECK(open < small);
}

TEST_CASE("a file that cannot be written is named with the reason", "[program][impossible]")
{
    const Folder folder;
    const auto full = folder / "full";
    std::filesystem::create_symlink("/dev/full", full);
    for (const std::string& verb :
         {std::string("new joint --force"), std::string("import tests/fuzz/corpus/robot/arm.urdf --joint elbow")}) {
        const auto run = stickslip(verb + " -o " + full);
        INFO(run.output);
        CHECK(run.exit_code == 2);
        CHECK_THAT(run.output, Contains(full + ": No space left on device"));
    }
}

TEST_CASE("words that nobody can take end in the exit code, not in an abort", "[program][impossible][slow]")
{
    for (const char* nowhere : {"2>/dev/full", "2>&-", ">/dev/full 2>/dev/full"}) {
        CAPTURE(nowhere);
        CHECK(stickslip(std::string("evaluate no-such-joint.toml ") + nowhere).exit_code == 2);
        CHECK(stickslip(std::string("no-such-verb ") + nowhere).exit_code == 2);
    }
    CHECK(stickslip("list laws >/dev/full 2>/dev/full").exit_code == 3);
}
