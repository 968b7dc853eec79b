// What becomes of a page: compared with another, dated, equal byte for byte; and what a shell is told of the verbs.
#include "tests/program/run.h"

#include <catch2/catch.hpp>

using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;
using program::Folder;
using program::stickslip;

namespace {

/// A small sweep of the reference contact with the given critical slip distance.
std::string spec(const char* slip_distance)
{
    return std::string(
               "[joint]\nmotion = \"prismatic\"\nmodel = \"single-mass\"\ninertia = 1.0\n"
               "[control]\nk_p = 6e4\nk_v = 0.0\nV0 = 1e-3\n"
               "[friction]\nlaw = \"rate-and-state\"\nf0 = 60.0\nA = 1.0\nB = 1.5\nL = ") +
           slip_distance +
           "\nV_star = 1e-3\n"
           "[axes]\n\"control.k_p\" = { from = 1e4, to = 1e5, points = 31, scale = \"log\" }\n"
           "\"control.k_v\" = { from = 0.0, to = 1e3, points = 9 }\n";
}

void sweep(const Folder& folder, const std::string& name, const char* slip_distance)
{
    const auto file = folder.write(name + ".toml", spec(slip_distance));
    const auto run = stickslip("sweep '" + file + "' -o '" + (folder / name) + "'");
    INFO(run.output);
    REQUIRE(run.exit_code == 0);
}

}  // namespace

TEST_CASE("two sweeps are compared: boundaries, regions, numbers", "[program][slow]")
{
    Folder folder;
    sweep(folder, "a", "1e-5");
    sweep(folder, "b", "2e-5");
    const auto changed =
        stickslip("report '" + (folder / "a") + "' '" + (folder / "b") + "' -o '" + (folder / "ab") + "'");
    INFO(changed.output);
    REQUIRE(changed.exit_code == 0);
    // k_cr = ((B − A)/L)(1 + m V_0²/(L A)): 55 kN/m for L = 10 µm and 26.25 kN/m for 20 µm, −52.3 %
    CHECK_THAT(changed.output, Contains("stable under small disturbances, as before"));
    CHECK_THAT(changed.output, Contains("−52.3 %"));
    const auto page = program::read(folder / "ab/report.html");
    for (const char* said :
         {"id=\"change-k-p-k-v\"", "id=\"difference-k-p-k-v\"", "55 kN/m", "26.25 kN/m", "friction.L"})
        CHECK_THAT(page, Contains(said));
    for (const char* file :
         {"ab/charts/change-k-p-k-v.svg", "ab/charts/change-k-p-k-v.png", "ab/charts/change-k-p-k-v.csv"})
        CHECK(std::filesystem::file_size(folder / file) > 1000);

    const auto same =
        stickslip("report '" + (folder / "a") + "' '" + (folder / "a") + "' -o '" + (folder / "aa") + "'");
    CHECK_THAT(same.output, Contains("No change"));
}

TEST_CASE("charts of two sweeps that are cut at different values name both", "[program][slow]")
{
    Folder folder;
    for (const std::string k_v : {"200", "400"}) {
        auto text = spec("1e-5");
        text.replace(text.find("k_v = 0.0"), 9, "k_v = " + k_v);
        text.replace(text.find("points = 9"), 10, "points = 6");
        text +=
            "\"control.V0\" = { from = 1e-4, to = 1e-2, points = 7, scale = \"log\" }\n"
            "[report]\ncharts = [[\"control.k_p\", \"control.V0\"]]\n";
        const auto run = stickslip("sweep '" + folder.write(k_v + ".toml", text) + "' -o '" + (folder / k_v) + "'");
        INFO(run.output);
        REQUIRE(run.exit_code == 0);
    }
    stickslip("report '" + (folder / "200") + "' '" + (folder / "400") + "' -o '" + (folder / "both") + "'");
    CHECK_THAT(program::read(folder / "both/report.html"),
               Contains("Held: k<sub>v</sub> = 200 N·s/m before, k<sub>v</sub> = 400 N·s/m after."));
}

TEST_CASE("a sweep without a title of its own has a page with one, and its locus names the located gain", "[program]")
{
    Folder folder;
    auto text = spec("1e-5");
    text.erase(text.find("\"control.k_v\" = "));
    const auto run = stickslip("sweep '" + folder.write("one.toml", text) + "' -o '" + (folder / "one") + "'");
    INFO(run.output);
    REQUIRE(run.exit_code == 0);
    const auto page = program::read(folder / "one/report.html");
    CHECK_THAT(page, Contains("<h1>Where the joint slides smoothly</h1>"));
    // (35): ((B − A)/L)(1 + m V_0²/(L A)) = 55 kN/m
    CHECK_THAT(page, Contains("Stability changes at k<sub>p</sub> = 55 kN/m"));
}

TEST_CASE("a page carries a date only when asked, and is the same every time", "[program][slow]")
{
    Folder folder;
    sweep(folder, "a", "1e-5");
    const auto page = folder / "a/report.html";
    const auto first = program::read(page);
    CHECK_THAT(first, !Contains("<dt>drawn</dt>"));
    const std::string again = "report '" + (folder / "a") + "'";
    REQUIRE(stickslip(again + " --timestamp 0").exit_code == 0);
    const auto dated = program::read(page);
    CHECK_THAT(dated, Contains("<dt>drawn</dt><dd>1970-01-01T00:00:00Z</dd>"));
    REQUIRE(stickslip(again + " --timestamp 0").exit_code == 0);
    CHECK(program::read(page) == dated);
    setenv("SOURCE_DATE_EPOCH", "86400", 1);
    const auto by_variable = stickslip(again);
    unsetenv("SOURCE_DATE_EPOCH");
    REQUIRE(by_variable.exit_code == 0);
    CHECK_THAT(program::read(page), Contains("1970-01-02T00:00:00Z"));
    REQUIRE(stickslip(again).exit_code == 0);
    CHECK(program::read(page) == first);
    CHECK(stickslip(again + " --timestamp yesterday").exit_code == 2);
}

TEST_CASE("the page of one sweep goes where -o says, and nowhere else", "[program][slow]")
{
    Folder folder;
    sweep(folder, "a", "1e-5");
    const auto first = program::read(folder / "a/report.html");
    std::filesystem::remove(folder / "a/report.html");
    const std::string again = "report '" + (folder / "a") + "' -o '";
    const auto elsewhere = stickslip(again + (folder / "b") + "'");
    INFO(elsewhere.output);
    CHECK(elsewhere.exit_code == 0);
    CHECK_THAT(elsewhere.output, Contains("report:  " + (folder / "b/report.html")));
    CHECK(program::read(folder / "b/report.html") == first);

    const auto nowhere = stickslip(again + "/proc/page'");
    INFO(nowhere.output);
    CHECK(nowhere.exit_code == 2);
    CHECK_THAT(nowhere.output, Contains("/proc/page"));
    CHECK(!std::filesystem::exists(folder / "a/report.html"));
}

TEST_CASE("a finished sweep is drawn from its stored answers, byte for byte, and nothing is computed",
          "[program][slow]")
{
    Folder folder;
    sweep(folder, "a", "1e-5");
    const auto page = folder / "a/report.html", stored = folder / "a/answer.json";
    const auto first = program::read(page), answer = program::read(stored);
    CHECK_THAT(answer, StartsWith("{\"format\":\"stickslip-sweep/6\""));
    const std::string again = "report '" + (folder / "a") + "'";
    REQUIRE(stickslip(again).exit_code == 0);
    CHECK(program::read(page) == first);
    CHECK(program::read(stored) == answer);

    // what the file says stands on the page, true or not
    auto told = answer;
    const std::string found = "\"nearest\":{\"decided\":true,\"stable\":true,\"found\":true";
    const auto at = told.find(found);
    REQUIRE(at != std::string::npos);
    told.replace(at, found.size(), "\"nearest\":{\"decided\":true,\"stable\":true,\"found\":false");
    folder.write("a/answer.json", told);
    CHECK_THAT(stickslip(again).output, Contains("no boundary near"));

    // without it, or with that of another sweep, it is made again
    for (const std::string& other :
         {std::string(), std::string("{\"format\":\"stickslip-sweep/6\",\"plan_id\":\"x\"}")}) {
        std::filesystem::remove(stored);
        if (!other.empty()) folder.write("a/answer.json", other);
        REQUIRE(stickslip(again).exit_code == 0);
        CHECK(program::read(stored) == answer);
        CHECK(program::read(page) == first);
    }
    folder.write("a/answer.json", "not ours");
    const auto foreign = stickslip(again);
    CHECK(foreign.exit_code == 2);
    CHECK_THAT(foreign.output, Contains("answer.json: is not a sweep answer"));
}

TEST_CASE("piped output has no colours and no progress", "[program][slow]")
{
    Folder folder;
    const auto run = stickslip("sweep '" + folder.write("spec.toml", spec("1e-5")) + "' -o '" + (folder / "out") + "'");
    CHECK(run.output.find('\033') == std::string::npos);
    CHECK(run.output.find('\r') == std::string::npos);
    CHECK_THAT(run.output, Contains("k_p: stick-slip below "));
    // several numbers at once come nearer than any alone
    CHECK_THAT(run.output, Contains("Stick-slip appears if L falls by"));
}

TEST_CASE("completions and manual know every verb", "[program]")
{
    Folder folder;
    const auto bash = stickslip("completion bash"), zsh = stickslip("completion zsh"),
               fish = stickslip("completion fish"), manual = stickslip("man-page");
    for (const char* verb :
         {"sweep", "boundary", "check", "evaluate", "simulate", "diagnose", "blind", "report", "merge", "list"}) {
        CHECK_THAT(bash.output, Contains(std::string("        ") + verb + ") options='"));
        CHECK_THAT(zsh.output, Contains(std::string("'") + verb + ":"));
        CHECK_THAT(fish.output, Contains(std::string("-n __fish_use_subcommand -f -a ") + verb + " "));
        CHECK_THAT(manual.output, Contains(std::string(".SS ") + verb + "\n"));
    }
    CHECK_THAT(bash.output, Contains("--max-undecided"));
    CHECK_THAT(manual.output, Contains("\\-\\-max\\-undecided"));
    const auto script = folder.write("stickslip.bash", bash.output);
    const std::string asks =
        "bash -c 'source \"" + script +
        "\"; COMP_WORDS=(stickslip sw); COMP_CWORD=1; _stickslip; test \"${COMPREPLY[*]}\" = sweep; a=$?; "
        "COMP_WORDS=(stickslip sweep --ti); COMP_CWORD=2; _stickslip; "
        "test \"${COMPREPLY[*]}\" = --timestamp || exit 1; "
        "COMP_WORDS=(stickslip boundary a.toml --kind fo); COMP_CWORD=4; _stickslip; "
        "test \"${COMPREPLY[*]}\" = fold || exit 1; "
        "COMP_WORDS=(stickslip list la); COMP_CWORD=2; _stickslip; "
        "test \"${COMPREPLY[*]}\" = laws && exit $a'";
    CHECK_THAT(zsh.output, Contains(":value:(velocity-only linear v-min fold outcome hunting)"));
    CHECK(std::system(asks.c_str()) == 0);
    CHECK_THAT(fish.output, Contains("-l kind -x -a 'velocity-only linear v-min fold outcome hunting'"));
    if (program::shell("command -v fish >/dev/null").exit_code != 0) return;
    const auto completed = [&](const std::string& words) {
        return program::shell("fish -N -c 'source " + folder.write("stickslip.fish", fish.output) +
                              "; complete -C \"stickslip " + words + "\"'")
            .output;
    };
    CHECK_THAT(completed("sw"), Catch::Matchers::StartsWith("sweep\t"));
    CHECK_THAT(completed("sweep --ti"), Catch::Matchers::StartsWith("--timestamp"));
    CHECK_THAT(completed("boundary a.toml --kind fo"), Catch::Matchers::StartsWith("fold"));
    CHECK_THAT(completed("list la"), Catch::Matchers::StartsWith("laws"));
}

TEST_CASE("report says what a folder holds that is no sweep's", "[program]")
{
    Folder folder;
    const auto said = [&](const std::string& name) {
        const auto run = stickslip("report '" + (folder / name) + "'");
        CHECK(run.exit_code == 2);
        CHECK_FALSE(std::filesystem::exists(folder / name + "/results.nc"));
        return run.output;
    };
    const auto joint = "examples/01-reference-joint/spec.toml";
    REQUIRE(stickslip("margins " + std::string(joint) + " --effort 0.1 -o '" + (folder / "m") + "'").exit_code == 0);
    CHECK_THAT(said("m"), Contains("holds margins.json of `stickslip margins`, not a sweep; its page is ") &&
                              Contains("m/report.html, which that command draws"));
    std::filesystem::create_directory(folder / "d");
    folder.write("d/diagnosis.json", R"({"format": "stickslip-diagnosis/2"})");
    CHECK_THAT(said("d"), Contains("holds diagnosis.json of `stickslip diagnose`, not a sweep; that command draws its "
                                   "page, ") &&
                              Contains("d/report.html, when it runs again"));
    folder.write("d/diagnosis.json", "{");
    CHECK_THAT(said("d"), Contains("holds no finished sweep (results.nc); make one with: stickslip sweep SPEC -o "));
    std::filesystem::create_directory(folder / "d/journal");
    CHECK_THAT(said("d"), Contains("holds a sweep that is not finished"));
    CHECK_THAT(said("d/diagnosis.json"), Contains("d/diagnosis.json: is a file, expected the folder of a sweep"));
    CHECK_THAT(said("nowhere"), Contains("nowhere: there is no such folder"));
}
