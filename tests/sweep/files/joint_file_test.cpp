#include "sweep/files/toml/joint_file.h"

#include "tests/sweep/files/good_joint.h"
#include "tests/sweep/files/messages.h"

#include <catch2/catch.hpp>
#include <filesystem>
#include <string>

using namespace stickslip;

namespace {

/// The good joint with one line replaced: line numbers of messages stay those of `good`.
std::string with(const std::string& line, const std::string& replacement)
{
    std::string text = good;
    const auto at = text.find("\n" + line + "\n");
    REQUIRE(at != std::string::npos);
    return text.replace(at + 1, line.size(), replacement);
}

std::vector<std::string> errors(const std::string& text)
{
    return messages_of([&] { read_joint_text(text, "joint.toml"); });
}

std::string only_error(const std::string& text)
{
    const auto all = errors(text);
    for (const auto& message : all) UNSCOPED_INFO(message);
    REQUIRE(all.size() == 1);
    return all.front();
}

using Catch::Contains;
using Catch::EndsWith;
using Catch::StartsWith;

}  // namespace

TEST_CASE("a joint with units, whole numbers and a list of one")
{
    const Joint joint = read_joint_text(good, "joint.toml");
    CHECK(joint.mechanism.inertia == 1.0);
    CHECK(joint.control.k_p == 2e4);
    CHECK(joint.control.V0 == 1e-3);
    const auto& law = std::get<RateAndState>(joint.friction.law);
    CHECK(law.f0 == 60);
    CHECK(law.B.size == 1);
    CHECK(law.B[0] == 1.5);
    CHECK(law.L[0] == 1e-5);
    CHECK(joint.actuator.limit == infinity);
}

TEST_CASE("lists, inline and dotted tables, a [record] table of someone else")
{
    const Joint joint = read_joint_text(R"(
control = { k_p = 10, k_v = 1, velocity_estimate = { form = "exact", tau = "3 ms" } }
joint.motion = "revolute"
joint.model = "two-mass"
joint.motor_inertia = "2 kg·mm²"
joint.link_inertia = 1
joint.transmission = { stiffness = "5 N·m/rad", backlash = "1 arcmin" }
actuator.limit = inf
[friction]
motor = { law = "stribeck", c0 = 1, c1 = 0, c2 = 0, c3 = 1 }
[friction.link]
law = "rate-and-state"
f0 = 1
A = 1
B = [1, "2 N·m"]
L = [1e-3, "1 mrad"]
V_star = 1
ripple.amplitude = 0.5
[record]
anything = 1
)",
                                        "joint.toml");
    CHECK(joint.mechanism.model == Model::two_mass);
    CHECK(joint.mechanism.motor_inertia == 2e-6);
    CHECK(joint.mechanism.transmission.stiffness == 5);
    CHECK(joint.control.velocity_estimate.form == EstimateForm::exact);
    CHECK(joint.control.velocity_estimate.tau == 3e-3);
    CHECK(std::get<Stribeck>(joint.frictions.motor.law).c4 == 2);
    const auto& law = std::get<RateAndState>(joint.frictions.link.law);
    REQUIRE(law.B.size == 2);
    CHECK(law.B[1] == 2);
    CHECK(law.L[1] == 1e-3);
    CHECK(joint.frictions.link.ripple.amplitude == 0.5);
}

TEST_CASE("syntax errors have a place")
{
    CHECK_THAT(only_error(with("k_v = 0", "k_v = = 0")), StartsWith("joint.toml:8:7: not valid TOML: "));
    CHECK_THAT(only_error(with("k_v = 0", "k_p = 0")), StartsWith("joint.toml:8:") && Contains("k_p"));
    CHECK_THAT(only_error(std::string("a = \"\0\"", 7)), StartsWith("joint.toml:1:"));
    CHECK_THAT(only_error("\x7f\x45LF\x01\x02"), StartsWith("joint.toml:1:"));
    CHECK_THAT(only_error("a = " + std::string(100000, '[')), StartsWith("joint.toml:1:"));
}

TEST_CASE("what is wrong with a line is told from the file, whatever the parser's words are")
{
    const auto twice = [](const std::string& text) {
        CHECK_THAT(only_error(text), Contains(" appears twice in this file"));
    };
    twice(with("k_v = 0", "k_v = 0\nk_v = [\n  1]"));
    twice(with("k_v = 0", "k_v = 0\n[control]"));
    // a list that has no end, and a table that names one key twice inside: no line of theirs appears twice
    for (const char* other : {"delay = [1,\n2\nk_i = 1", "delay = { kind = 1, kind = 2 }"}) {
        const auto error = only_error(with("k_v = 0", "k_v = 0\n" + std::string(other)));
        CHECK_THAT(error, Contains("not valid TOML") && !Contains("this file") && !Contains("in quotes"));
    }

    const auto said = [](const char* value) { return only_error(with("k_v = 0", std::string("k_v = ") + value)); };
    for (const char* unit : {"1 N·s/m", "1.5 °", "12 %", "1e3N", "-2 µm", "3mm", "1N # newton"})
        CHECK_THAT(said(unit), Contains("a number with a unit is written in quotes"));
    for (const char* no_unit : {"1 2", "\"x\" N", "[1 2]", "= 1"}) CHECK_THAT(said(no_unit), !Contains("in quotes"));
}

TEST_CASE("unknown keys, with the allowed ones and the nearest")
{
    CHECK(
        only_error(with("k_v = 0", "kv = 0")) ==
        "joint.toml:8:1: control.kv: unknown key, expected kind, feedback, structure, k_p, k_v, k_i, "
        "integral_limit, anti_windup, tracking_time, integral_band, dead_zone, V0, force_rate, contact_stiffness, "
        "force_gain, period, reference_velocity, effort_limit, delay, velocity_estimate, feed_forward, dither; did you "
        "mean \"k_v\"?");
    CHECK_THAT(only_error(good + "[frction]\nlaw = 1\n"),
               StartsWith("joint.toml:17:2: frction: unknown key") && EndsWith("did you mean \"friction\"?"));
    CHECK_THAT(only_error(with("inertia = 1.0", "inertia = 1.0\nk_v = 3")),
               StartsWith("joint.toml:5:1: joint.k_v: unknown key") && EndsWith("did you mean \"control.k_v\"?"));
    CHECK_THAT(only_error(good + "[load.cogging]\namplitud = 1\n"),
               StartsWith("joint.toml:18:1: load.cogging.amplitud: ") && EndsWith("\"amplitude\"?"));
}

TEST_CASE("the spec of a sweep is named as such where a joint is expected")
{
    CHECK(only_error(good + "[axes]\n\"control.k_p\" = [1, 2]\n[nonlinear]\nenabled = true\n") ==
          "joint.toml:17:1: axes: this is the spec of a sweep, expected a joint file: stickslip new joint --from "
          "joint.toml writes its design point");
    CHECK(only_error("joint = \"arm.toml\"\n[axes]\n") ==
          "joint.toml:1:9: joint: this is the spec of a sweep, expected a joint file: the one that it names, arm.toml");
}

TEST_CASE("keys that belong to another law, model or kind say so")
{
    CHECK_THAT(only_error(with("f0 = 60", "f0 = 60\nc0 = 1")),
               StartsWith("joint.toml:13:1: friction.c0: unknown key (it belongs to friction.law = \"stribeck\")"));
    CHECK_THAT(
        only_error(with("inertia = 1.0", "inertia = 1.0\nlink_inertia = 2")),
        StartsWith("joint.toml:5:1: joint.link_inertia: unknown key (it belongs to joint.model = \"two-mass\" or "));
    CHECK_THAT(only_error(good + "[actuator]\nk_t = 1\n"),
               StartsWith("joint.toml:18:1: actuator.k_t: unknown key (it belongs to actuator.kind = \"dc-motor\")"));
    CHECK_THAT(only_error(good + "[friction.motor]\nlaw = \"stribeck\"\n"),
               StartsWith("joint.toml:17:11: friction.motor: unknown key (it belongs to joint.model = "));
}

TEST_CASE("missing keys stand where their table does")
{
    CHECK(only_error(with("inertia = 1.0", "")) ==
          "joint.toml:1:1: joint.inertia: is missing, expected a number in kg, > 0: moving inertia m");
    CHECK_THAT(only_error(with("B = 1.5", "")),
               StartsWith("joint.toml:10:1: friction.B: is missing, expected a number in N, ≥ 0, or a list"));
    CHECK_THAT(only_error(with("law = \"rate-and-state\"", "")),
               StartsWith("joint.toml:10:1: friction.law: is missing, expected coulomb-viscous, "));
    const auto all = errors("");
    REQUIRE(all.size() == 3);
    CHECK_THAT(all[0], StartsWith("joint.toml:1:1: joint.inertia: is missing"));
    CHECK_THAT(all[1], StartsWith("joint.toml:1:1: control.k_p: is missing"));
    CHECK_THAT(all[2], StartsWith("joint.toml:1:1: friction.law: is missing"));
}

TEST_CASE("wrong types")
{
    CHECK(only_error(with("inertia = 1.0", "inertia = true")) ==
          "joint.toml:4:11: joint.inertia: is true, expected a number in kg, > 0");
    CHECK_THAT(only_error(with("k_v = 0", "k_v = [1]")),
               StartsWith("joint.toml:8:7: control.k_v: is a list, expected a number in N·s/m"));
    CHECK_THAT(only_error(with("k_v = 0", "k_v = {}")), StartsWith("joint.toml:8:7: control.k_v: is a table"));
    CHECK_THAT(only_error(with("k_v = 0", "k_v = 1979-05-27")),
               StartsWith("joint.toml:8:7: control.k_v: is a date or time"));
    CHECK(only_error(with("kind = \"position\"", "kind = 3")) ==
          "joint.toml:6:8: control.kind: is 3, expected position, force");
    CHECK(only_error(with("k_v = 0", "reference_velocity = 1")) ==
          "joint.toml:8:22: control.reference_velocity: is 1, expected true, false");
    CHECK(only_error(good + "[sensor]\n[load]\ncogging = 3\n") ==
          "joint.toml:19:11: load.cogging: is 3, expected a table");
    CHECK(only_error("load = []\n" + good) == "joint.toml:1:8: load: is a list, expected a table");
}

TEST_CASE("units of another kind")
{
    CHECK(only_error(with("V0 = \"1 mm/s\"", "V0 = \"1 mm\"")) ==
          "joint.toml:9:6: control.V0: \"1 mm\": \"mm\" is not a unit of this quantity, expected m/s");
    const auto all = errors(with("motion = \"prismatic\"", "motion = \"revolute\""));
    REQUIRE(all.size() == 3);
    CHECK(all[0] ==
          "joint.toml:7:7: control.k_p: \"20 kN/m\": \"kN/m\" is not a unit of this quantity, expected N·m/rad");
    CHECK_THAT(all[1], EndsWith("expected rad/s"));
    CHECK_THAT(all[2], StartsWith("joint.toml:15:5: friction.L: ") && EndsWith("expected rad"));
}

TEST_CASE("values out of range")
{
    CHECK(only_error(with("inertia = 1.0", "inertia = 0")) ==
          "joint.toml:4:11: joint.inertia: is 0, expected a number in kg, > 0");
    CHECK(only_error(with("L = \"10 µm\"", "L = \"-10 µm\"")) ==
          "joint.toml:15:5: friction.L: is \"-10 µm\" (-1e-05 m), expected a number in m, > 0");
    CHECK_THAT(only_error(with("k_v = 0", "k_v = nan")), StartsWith("joint.toml:8:7: control.k_v: is nan"));
    CHECK_THAT(only_error(with("k_v = 0", "k_v = inf")), StartsWith("joint.toml:8:7: control.k_v: is inf"));
    CHECK_THAT(only_error(with("k_v = 0", "period = inf")), StartsWith("joint.toml:8:10: control.period: is inf"));
    CHECK_THAT(only_error(with("k_v = 0", "velocity_estimate.average = 1.5")), Contains("a whole number within [1, 1"));
}

TEST_CASE("unknown laws and names, without follow-up complaints about their keys")
{
    CHECK_THAT(only_error(with("law = \"rate-and-state\"", "law = \"rate-and-sate\"")),
               StartsWith("joint.toml:11:7: friction.law: is \"rate-and-sate\", expected coulomb-viscous, ") &&
                   EndsWith("; did you mean \"rate-and-state\"?"));
    CHECK(only_error(with("model = \"single-mass\"", "model = \"singlemass\"\nmotor_inertia = 2\n#")) ==
          "joint.toml:3:9: joint.model: is \"singlemass\", expected single-mass, two-mass, three-mass, lever; did "
          "you mean \"single-mass\"?");
}

TEST_CASE("lists")
{
    CHECK_THAT(only_error(with("B = 1.5", "B = []")),
               StartsWith("joint.toml:14:5: friction.B: is a list of 0, expected 1 to 8"));
    CHECK_THAT(only_error(with("B = 1.5", "B = [1,1,1,1,1,1,1,1,1]")),
               StartsWith("joint.toml:14:5: friction.B: is a list of 9"));
    CHECK_THAT(only_error(with("B = 1.5", "B = [1, -2]")),
               StartsWith("joint.toml:14:9: friction.B.1: is -2, expected a number in N, ≥ 0"));
    CHECK_THAT(only_error(with("B = 1.5", "B = [1, [2]]")), StartsWith("joint.toml:14:9: friction.B.1: is a list"));
    CHECK(only_error(with("B = 1.5", "B = [1, 2]")) ==
          "joint.toml:10:1: friction: B and L need one value a state each, got 2 and 1");
}

TEST_CASE("rules of a struct beyond ranges")
{
    CHECK(only_error(with("k_p = \"20 kN/m\"", "k_p = 2e4") +
                     "[actuator]\nkind = \"dc-motor\"\nk_t = 1\nk_e = 1\nresistance = 1\nsignal = \"duty\"\n") ==
          "joint.toml:17:1: actuator: signal = \"duty\" needs supply_voltage");
}

TEST_CASE("all errors of a file come at once, in order")
{
    std::string text = with("inertia = 1.0", "inertia = -1");
    text.replace(text.find("k_v = 0"), 7, "kv = 0 ");
    text.replace(text.find("f0 = 60"), 7, "f0 = \"\"");
    const auto all = errors(text + "[extra]\n");
    REQUIRE(all.size() == 4);
    CHECK_THAT(all[0], StartsWith("joint.toml:4:11: joint.inertia: "));
    CHECK_THAT(all[1], StartsWith("joint.toml:8:1: control.kv: "));
    CHECK_THAT(all[2], StartsWith("joint.toml:12:6: friction.f0: "));
    CHECK_THAT(all[3], StartsWith("joint.toml:17:2: extra: "));
}

TEST_CASE("files that cannot be read")
{
    const auto folder = std::filesystem::temp_directory_path();
    CHECK(messages_of([&] { read_joint(folder / "no-such-joint.toml"); }) ==
          std::vector<std::string>{(folder / "no-such-joint.toml").string() + ": there is no such file"});
    CHECK_THAT(messages_of([&] { read_joint(folder); }).at(0), EndsWith("is a folder, expected a TOML file"));
}
