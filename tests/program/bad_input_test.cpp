// Bad input gets one clear message with file, line and column, exit code 2, and existing results stay untouched.
#include "tests/program/run.h"

#include <catch2/catch.hpp>

using Catch::Matchers::Contains;
using program::Folder;
using program::stickslip;

namespace {

const std::string good =
    "[joint]\nmotion = \"prismatic\"\nmodel = \"single-mass\"\ninertia = 1.0\n"
    "[control]\nk_p = 6e4\nk_v = 10.0\nV0 = 1e-3\n"
    "[friction]\nlaw = \"rate-and-state\"\nf0 = 60.0\nA = 1.0\nB = 1.5\nL = 1e-5\nV_star = 1e-3\n"
    "[axes]\n\"control.k_p\" = { from = 1e4, to = 1e5, points = 7, scale = \"log\" }\n"
    "\"control.k_v\" = { from = 1.0, to = 1e3, points = 5, scale = \"log\" }\n";

std::string with(const std::string& from, const std::string& to)
{
    std::string text = good;
    const auto at = text.find(from);
    REQUIRE(at != std::string::npos);
    return text.replace(at, from.size(), to);
}

}  // namespace

TEST_CASE("every kind of bad spec is refused at its place", "[program][slow]")
{
    struct Bad {
        const char *what, *from, *to, *place, *says;
    };
    const Bad cases[] = {
        {"unknown key", "inertia = 1.0", "inertia = 1.0\nintertia = 2.0", "spec.toml:5:1", "inertia"},
        {"missing key", "A = 1.0\n", "", "spec.toml", "friction.A"},
        {"wrong type", "k_v = 10.0", "k_v = \"ten\"", "spec.toml:7:7", "k_v"},
        {"wrong unit kind", "V0 = 1e-3", "V0 = \"1 mm\"", "spec.toml:8:6", "m/s"},
        {"negative mass", "inertia = 1.0", "inertia = -1.0", "spec.toml:4:11", "> 0"},
        {"L of zero", "L = 1e-5", "L = 0", "spec.toml:14:5", "> 0"},
        {"empty axis", "{ from = 1.0, to = 1e3, points = 5, scale = \"log\" }", "[]", "spec.toml:18:17", "control.k_v"},
        {"axis that is no number of the joint", "\"control.k_v\"", "\"control.kv\"", "spec.toml:18:1", "control.k_v"},
        {"too many points", "points = 7", "points = 1000000000000000", "spec.toml", "points"},
        {"syntax error", "[control]", "[control", "spec.toml:5", ""},
        {"unknown law", "rate-and-state", "rate-and-stat", "spec.toml:10:7", "rate-and-state"},
    };
    for (const auto& bad : cases) {
        Folder folder;
        const auto spec = folder.write("spec.toml", with(bad.from, bad.to));
        const auto run = stickslip("sweep '" + spec + "' -o '" + (folder / "out") + "'");
        INFO(bad.what << "\n" << run.output);
        CHECK(run.exit_code == 2);
        CHECK_THAT(run.output, Contains(bad.place));
        CHECK_THAT(run.output, Contains(bad.says));
        CHECK_FALSE(std::filesystem::exists(folder / "out/results.nc"));
    }
}

TEST_CASE("a refused run leaves earlier results as they were", "[program]")
{
    Folder folder;
    const auto spec = folder.write("spec.toml", good);
    const std::string command = "sweep '" + spec + "' --no-report -o '" + (folder / "out") + "'";
    REQUIRE(stickslip(command).exit_code == 0);
    const auto before = program::read(folder / "out/results.nc");
    REQUIRE(before.size() > 1000);
    folder.write("spec.toml", with("inertia = 1.0", "inertia = 2.0"));
    const auto changed = stickslip(command);
    INFO(changed.output);
    CHECK(changed.exit_code == 2);
    CHECK_THAT(changed.output, Contains("--fresh"));
    folder.write("spec.toml", with("inertia = 1.0", "inertia = \"heavy\""));
    CHECK(stickslip(command).exit_code == 2);
    CHECK(program::read(folder / "out/results.nc") == before);
}

TEST_CASE("places that cannot be read or written are named", "[program]")
{
    Folder folder;
    const auto unreadable = stickslip("sweep '" + (folder / "nowhere.toml") + "'");
    CHECK(unreadable.exit_code == 2);
    CHECK_THAT(unreadable.output, Contains("nowhere.toml"));
    const auto spec = folder.write("spec.toml", good);
    const auto unwritable = stickslip("sweep '" + spec + "' -o /dev/null/out");
    CHECK(unwritable.exit_code == 2);
    CHECK_THAT(unwritable.output, Contains("/dev/null/out"));
    CHECK(stickslip("swep").exit_code == 2);
    CHECK(stickslip("evaluate").exit_code == 2);
}

TEST_CASE("a wrong command line is told what is allowed and the nearest name", "[program][slow]")
{
    struct Wrong {
        const char *arguments, *says;
    };
    const Wrong cases[] = {
        {"swep", "there is no verb \"swep\""},
        {"swep", "did you mean sweep?"},
        {"", "Example: stickslip sweep -o out"},
        {"sweep --freh", "stickslip sweep: there is no option \"--freh\""},
        {"sweep --freh", "did you mean --fresh?"},
        {"evaluate", "JOINT is required\nExample: stickslip evaluate"},
        {"evaluate a.toml b.toml", "\"b.toml\" is one argument too many"},
        {"simulate a.toml --disturbance posit", "got \"posit\", expected position, velocity"},
        {"simulate a.toml --disturbance posit", "did you mean position?"},
        {"sweep --max-undecided 7", "--max-undecided: got \"7\", expected 0 to 1\n"},
        {"sweep --threads many", "--threads: got \"many\", expected a whole number from 0 to 4096\n"},
        {"simulate a.toml --duration -1", "--duration: got \"-1\", expected a number above 0\n"},
        {"simulate a.toml --force sin", "expected impulse, step, sine, noise or a file; did you mean sine?"},
        {"report a b c", "DIR: got 3, expected at most 2"},
        {"report /dev/null/out", "/dev/null/out: there is no such folder"},
    };
    for (const auto& wrong : cases) {
        const auto run = stickslip(wrong.arguments);
        INFO(run.output);
        CHECK(run.exit_code == 2);
        CHECK_THAT(run.output, Contains(wrong.says));
    }
}

TEST_CASE("tolerances of check are shares or per cent", "[program]")
{
    for (const std::string given : {"0.5", "50%", "'50 %'"}) {
        const auto run = stickslip("check a.toml b.json --number-tolerance 0.1 --gap-tolerance " + given);
        INFO(given << "\n" << run.output);
        CHECK(run.exit_code == 2);
        CHECK_THAT(run.output, Contains("a.toml") && !Contains("-tolerance"));  // it is the file that is missing
    }
    const auto wrong = stickslip("check a.toml b.json --gap-tolerance 50x");
    CHECK_THAT(wrong.output, Contains("--gap-tolerance: got \"50x\", expected a share"));
}

TEST_CASE("options take no number that means nothing", "[program][slow]")
{
    struct Option {
        const char *arguments, *name, *also_wrong;
    };
    // "nan" is neither below nor above the ends of a range
    const Option options[] = {
        {"evaluate a.toml", "--effort", "0"},
        {"evaluate a.toml", "--size", "big"},
        {"evaluate a.toml", "--omega", "0"},
        {"margins a.toml", "--effort", "-1"},
        {"margins a.toml", "--guard", "2.5"},
        {"margins a.toml", "--threads", "-1"},
        {"simulate a.toml", "--tolerance", "0"},
        {"simulate a.toml", "--duration", "-1"},
        {"simulate a.toml", "--seed", "0.5"},
        {"boundary a.toml", "--max-undecided", "1.5"},
        {"boundary a.toml", "--precision", "0"},
        {"boundary a.toml", "--threads", "-2"},
        {"sweep a.toml", "--max-undecided", "-1"},
        {"check a.toml b.json", "--gap-tolerance", "-1"},
        {"check a.toml b.json", "--number-tolerance", "-1"},
        {"check a.toml b.json", "--threads", "-1"},
        {"design a.toml --set-point", "--friction-margin", "1"},
        {"design a.toml --set-point", "--integral-gain", "0"},
        {"design a.toml --set-point", "--push-speed", "0"},
        {"design a.toml --set-point", "--rest-error", "-1"},
        {"design a.toml", "--threads", "-1"},
        {"export a.toml --to mjcf", "--timestep", "0"},
        {"export a.toml --to mjcf", "--link-inertia", "0"},
        {"export a.toml --to mjcf", "--speed", "0"},
        {"diagnose a.toml b.csv", "--guarantee", "2"},
        {"diagnose a.toml b.csv", "--threads", "-1"},
        {"calibrate a.toml b.csv", "--cases", "0"},
        {"calibrate a.toml b.csv", "--seed", "-1"},
        {"calibrate a.toml b.csv", "--threads", "-1"},
        {"blind a", "--timeout", "0"},
        {"blind a", "--jobs", "0"},
        {"blind a", "--threads", "-1"},
        {"plan a.toml b.csv", "--threads", "-1"},
        {"arm-load a.csv", "--window", "0"},
    };
    for (const auto& option : options)
        for (const std::string value : {"nan", "inf", "1e999", "ten", option.also_wrong}) {
            const auto run = stickslip(std::string(option.arguments) + " " + option.name + " " + value);
            INFO(option.arguments << " " << option.name << " " << value << "\n" << run.output);
            CHECK(run.exit_code == 2);
            CHECK_THAT(run.output, Contains(std::string(option.name) + ": got \"" + value + "\", expected "));
        }
    // what disturbs by nothing shows nothing of what comes back from a disturbance; a start at 0 is one from rest
    const std::string joint = "evaluate examples/01-reference-joint/spec.toml --set control.k_p=5e4 ";
    for (const char* kind : {"", "--disturbance position ", "--disturbance velocity "}) {
        const auto run = stickslip(joint + kind + "--size 0");
        INFO(kind << run.output);
        CHECK(run.exit_code == 2);
        CHECK_THAT(run.output, Contains("--size: got 0, expected a disturbance other than 0"));
    }
    CHECK(stickslip(joint + "--disturbance start --size 0").exit_code == 0);
}

TEST_CASE("a name that no robot description can hold is refused", "[program][slow]")
{
    for (const char* to : {"mjcf", "urdf", "sdf", "isaaclab", "ros2_control"})
        for (const char* name : {"a<b>", "a&b", "a\"b", "two words", ""}) {
            const auto run = stickslip(std::string("export examples/02-ball-screw/joint.toml --to ") + to +
                                       " --name '" + name + "'");
            INFO(to << " " << name << run.output);
            CHECK(run.exit_code == 2);
            CHECK_THAT(run.output, Contains("the name of the joint: got \"" + std::string(name) + "\""));
        }
}

TEST_CASE("a directory that cannot be made is named, and what to do", "[program]")
{
    const auto run = stickslip("sweep -o /proc/results");
    INFO(run.output);
    CHECK(run.exit_code == 2);
    CHECK_THAT(run.output, Contains("stickslip: /proc/results: No such file or directory\nChoose a directory"));
}

TEST_CASE("what stands wrong in a file is said in the words of its writer", "[program]")
{
    Folder folder;
    const auto says = [&](const std::string& from, const std::string& to) {
        const auto run =
            stickslip("sweep '" + folder.write("spec.toml", with(from, to)) + "' -o '" + (folder / "out'"));
        CHECK(run.exit_code == 2);
        return run.output;
    };
    CHECK_THAT(says("k_v = 10.0", "k_v = \"fast\""),
               Contains("control.k_v: \"fast\" is not a number with a unit such as N·s/m"));
    CHECK_THAT(says("k_v = 10.0", "k_v = 10.0\nk_v = 11.0"), Contains("spec.toml:8:") && Contains("k_v appears twice"));
    CHECK_THAT(says("[friction]", "[control]\n[friction]"), Contains("[control] appears twice"));
    CHECK_THAT(says("V0 = 1e-3", "V0 = 1 mm/s"), Contains("a number with a unit is written in quotes"));
}

TEST_CASE("an axis that the maps leave out is named before it is swept", "[program]")
{
    Folder folder;
    const auto spec = folder.write(
        "spec.toml", with("\"control.k_v\" = {", "\"sensor.effort_noise\" = [0, 0.01, 0.1]\n\"control.k_v\" = {"));
    const auto run = stickslip("sweep '" + spec + "' --no-report -o '" + (folder / "out") + "'");
    CHECK(run.exit_code == 0);
    CHECK_THAT(run.output, Contains("note: no linear verdict of this joint depends on sensor.effort_noise"));
    CHECK_THAT(run.output, !Contains("depends on control.k_p"));
    CHECK_THAT(run.output, !Contains("depends on control.k_v"));
    // a joint that nothing damps oscillates, by k_p, whichever it is
    const auto neutral =
        folder.write("neutral.toml",
                     "[joint]\ninertia = 1.0\n[control]\nk_p = 1e4\nV0 = 1e-3\n[friction]\n"
                     "law = \"kinetic-static\"\nkinetic = 10.0\nstatic = 15.0\n"
                     "[axes]\n\"control.k_p\" = [1e3, 1e4, 1e5]\n\"sensor.effort_noise\" = [0, 0.1]\n");
    const auto still = stickslip("sweep '" + neutral + "' --no-report -o '" + (folder / "still") + "'");
    CHECK_THAT(still.output, Contains("depends on sensor.effort_noise"));
    CHECK_THAT(still.output, !Contains("depends on control.k_p"));
}

TEST_CASE("Ctrl-C ends a verb of seconds at once, in words and with code 3", "[program]")
{
    // it waits for its joint from a pipe; that this shell could open the other end says that it has begun to wait
    program::Folder folder;
    const auto run =
        program::shell("mkfifo '" + (folder / "joint") + "' && { '" + STICKSLIP + "' evaluate '" + (folder / "joint") +
                       "' & } && exec 3>'" + (folder / "joint") + "' && kill -INT $! && wait $!");
    CHECK(run.exit_code == 3);
    CHECK(run.output == "interrupted before the answer was complete\n");
}

TEST_CASE("a dead time or an average that is refused is named with its number and its place", "[program]")
{
    const std::string sampled = "V0 = 1e-3\nperiod = 1e-3\nvelocity_estimate = { form = \"backward-difference\" }\n";
    Folder folder;
    const auto late = folder.write("late.toml", with("V0 = 1e-3\n", sampled + "delay = 1e3\n"));
    const std::string both = with("V0 = 1e-3\n", sampled + "delay = 0.6\n") + "[sensor]\ndelay = 0.5\n";
    const auto apart = folder.write("apart.toml", both);
    const auto prompt = folder.write("prompt.toml", with("V0 = 1e-3\n", sampled));
    std::string average = sampled;
    average.insert(average.find(" }"), ", average = 1000000000");
    const auto averaging = folder.write("averaging.toml", with("V0 = 1e-3\n", average));
    struct Refused {
        std::string command;
        const char *place, *says;
    };
    const Refused cases[] = {
        {"evaluate '" + averaging + "'", "averaging.toml:10:", "control.velocity_estimate.average: is 1e+09"},
        {"simulate '" + prompt + "' --set control.velocity_estimate.average=1001", "--set: control.velocity_estimate",
         "is 1001, expected at most 1000 readings"},
        {"sweep '" + late + "' -o '" + (folder / "out") + "'", "late.toml:11:9: control.delay: is 1000 s",
         "1e+06 periods, expected at most 1000 periods (1 s)"},
        {"margins '" + apart + "'", "apart.toml:23:9: sensor.delay: is 0.5 s and control.delay 0.6 s",
         "1100 periods, expected at most 1000 periods (1 s)"},
        {"evaluate '" + prompt + "' --set control.delay=1000", "--set: control.delay: is 1000 s", "1e+06 periods"}};
    for (const auto& bad : cases) {
        const auto run = stickslip(bad.command);
        INFO(bad.command << "\n" << run.output);
        CHECK(run.exit_code == 2);
        CHECK_THAT(run.output, Contains(bad.place));
        CHECK_THAT(run.output, Contains(bad.says));
    }
}

TEST_CASE("a limit below the friction of steady sliding is said with its place by every verb", "[program][slow]")
{
    Folder folder;
    const auto weak = folder.write("weak.toml", with("V0 = 1e-3\n", "V0 = 1e-3\neffort_limit = 50.0\n"));
    const std::string says =
        "effort_limit: is 50 N, and steady sliding at V_0 = 1 mm/s takes 60 N (friction 60 N): there is no steady "
        "sliding";
    for (const std::string& rest :
         {"evaluate '" + weak + "'", "boundary '" + weak + "' --along control.k_p=1e4..1e6 -o '" + (folder / "b") + "'",
          "margins '" + weak + "'", "sweep '" + weak + "' --no-report -o '" + (folder / "s") + "'",
          "simulate '" + weak + "' -o '" + (folder / "m") + "'",
          "design '" + weak + "' --require position_noise=1e-6 --require sample_time=1e-3"}) {
        const auto run = stickslip(rest);
        INFO(rest << "\n" << run.output);
        CHECK(run.exit_code == 4);
        CHECK_THAT(run.output, Contains("weak.toml:9:16: control." + says));
        CHECK_THAT(run.output, !Contains("unstable throughout") && !Contains("Nearest to feasible"));
    }
    const auto set = stickslip("evaluate '" + weak + "' --set control.effort_limit=30");
    CHECK_THAT(set.output, Contains("--set: control.effort_limit: is 30 N"));
    CHECK(stickslip("evaluate '" + weak + "' --set control.effort_limit=61").exit_code == 0);
}

TEST_CASE("a loop that no controller has is refused at its place", "[program][slow]")
{
    Folder folder;
    struct Bad {
        const char *loop, *says;
    };
    const Bad cases[] = {
        {"period = 1e-3\n",
         "loop.toml:5:1: control: period is set and the loop feeds velocity back, but "
         "velocity_estimate.form is missing, expected \"backward-difference\", \"exact\""},
        {"period = 1e300\n", "loop.toml:9:10: control.period: is 1e+300, expected a number in s, within (0, 100]"},
        {"velocity_estimate = { tau = -1e-3 }\n",
         "loop.toml:9:29: control.velocity_estimate.tau: is -0.001, expected a number in s, ≥ 0"}};
    for (const auto& bad : cases) {
        const auto file = folder.write("loop.toml", with("V0 = 1e-3\n", std::string("V0 = 1e-3\n") + bad.loop));
        for (const std::string verb : {"evaluate", "margins", "sweep"}) {
            const auto run = stickslip(verb + " '" + file + "' -o '" + (folder / "out") + "'");
            INFO(verb << "\n" << run.output);
            CHECK(run.exit_code == 2);
            CHECK_THAT(run.output, Contains(bad.says));
        }
    }
}

TEST_CASE("an axis over dead times that are refused is refused", "[program]")
{
    const std::string ticked =
        with("V0 = 1e-3\n",
             "V0 = 1e-3\nperiod = 1e-3\nvelocity_estimate = { form = \"backward-difference\" }\ndelay = 1e-3\n");
    Folder folder;
    const auto over = [&](const std::string& name, const std::string& axis) {
        return folder.write(name, ticked.substr(0, ticked.find("\"control.k_v\" =")) + axis);
    };
    const auto joint = folder.write("joint.toml", ticked);
    const std::string late = over("late.toml", "\"control.delay\" = { from = 1e-3, to = 1e4, points = 3 }\n"),
                      fast = over("fast.toml", "\"control.period\" = [1e-7, 1e-3]\n"),
                      out = " -o '" + (folder / "out") + "'";
    for (const auto& [command, says] :
         {std::pair<std::string, std::string>{
              "sweep '" + late + "'" + out,
              "late.toml:21:1: axes.control.delay: control.delay is 10000 s, which is 1e+07 "
              "periods, expected at most 1000 periods (1 s)"},
          {"sweep '" + fast + "'" + out,
           "fast.toml:21:1: axes.control.period: control.delay is 0.001 s, which is 10000 periods"},
          {"boundary '" + joint + "' --along control.delay=1e-3..1e4",
           "--along control.delay: control.delay is 10000 s, which is 1e+07 periods"}}) {
        const auto run = stickslip(command);
        INFO(command << "\n" << run.output);
        CHECK(run.exit_code == 2);
        CHECK_THAT(run.output, Contains(says));
    }
}

TEST_CASE("a sweep along one axis without any verdict says so, and no axis is blamed", "[program]")
{
    Folder folder;
    std::string text = with("V0 = 1e-3\n", "V0 = 1e-3\neffort_limit = 50.0\n");
    const auto weak = folder.write("weak.toml", text.substr(0, text.find("\"control.k_v\" =")));
    const auto run = stickslip("sweep '" + weak + "' -o '" + (folder / "out") + "'");
    INFO(run.output);
    CHECK(run.exit_code == 4);
    CHECK_THAT(run.output, Contains("7 points have no verdict: the effort limit is not above"));
    CHECK_THAT(run.output, !Contains("no linear verdict of this joint depends") && !Contains("finite value"));
    CHECK(std::filesystem::exists(folder / "out/report.html"));
}
