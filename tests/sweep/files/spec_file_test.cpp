#include "sweep/files/toml/spec_file.h"

#include "sweep/files/toml/joint_file.h"
#include "sweep/study/samples.h"
#include "sweep/words/symbols.h"
#include "tests/sweep/files/messages.h"
#include "tests/temporary_directory.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>

using namespace stickslip;

namespace {

const std::string joint = R"([joint]
inertia = 1.0
[control]
k_p = 2e4
V0 = 1e-3
[friction]
law = "rate-and-state"
f0 = 60
A = 1
B = [1.5, 1]
L = [1e-5, 1e-4]
V_star = 1e-3
)";
constexpr int joint_lines = 12;

std::vector<std::string> errors(const std::string& text, const PlanLimits& limits = {})
{
    return messages_of([&] { read_spec_text(text, "spec.toml", "", limits); });
}

/// The one error of a spec whose lines behind the joint are given; "@3:" in front stands for the third of those lines.
std::string only_error(const std::string& text, const PlanLimits& limits = {})
{
    const auto all = errors(joint + text, limits);
    for (const auto& message : all) UNSCOPED_INFO(message);
    REQUIRE(all.size() == 1);
    const std::string& message = all.front();
    if (!message.starts_with("spec.toml:")) return message;
    const auto colon = message.find(':', 10);
    std::string relative(1, '@');
    relative += std::to_string(std::stoi(message.substr(10, colon - 10)) - joint_lines);
    return relative + message.substr(colon);
}

const std::string axes = "[axes]\n\"control.k_p\" = [1, 2]\n\"control.k_v\" = [1, 2]\n";

using Catch::Contains;
using Catch::EndsWith;
using Catch::StartsWith;

}  // namespace

TEST_CASE("a whole spec")
{
    const Spec spec = read_spec_text("title = \"Demo\"\n" + joint + R"([axes]
"control.k_p" = { from = "1 kN/m", to = 1e6, points = 4, scale = "log" }
friction.L.1 = [1e-5, "20 µm", 8e-5]
control.V0 = { from = 1e-3, to = 3e-3, points = 3 }
load.constant = 5
[design]
control.k_p = 2e3
"control.k_v" = 7
[nonlinear]
enabled = true
tolerance = 1e-9
disturbance = { kind = "impulse", size = "1 mN·s" }
[boundary]
kind = ["linear", "fold"]
along = "friction.f0"
over = ["control.k_p=1..2", "control.k_v"]
guard = 9
precision = 1e-4
[report]
title = "A page"
charts = [["control.k_p", "friction.L.1"], ["control.V0", "control.k_p"]]
surfaces = ["control.V0", "friction.L.1"]
[check]
tolerance = "2 %"
)",
                                     "spec.toml");
    CHECK(spec.title == "Demo");
    CHECK(spec.joint_file.empty());
    REQUIRE(spec.axes.size() == 4);  // in the order of the file, not of the names
    CHECK(spec.axes[0].path == "control.k_p");
    CHECK(spec.axes[0].symbol == "k_{p}");
    CHECK(spec.axes[0].name == "position gain");
    CHECK(spec.axes[0].quantity == Quantity::position_gain);
    CHECK(spec.axes[0].log);
    REQUIRE(spec.axes[0].values.size() == 4);
    CHECK(spec.axes[0].values.front() == 1e3);
    CHECK(spec.axes[0].values[1] == Approx(1e4).epsilon(1e-14));
    CHECK(spec.axes[0].values.back() == 1e6);
    CHECK(spec.axes[1].path == "friction.L.1");
    CHECK(spec.axes[1].symbol == "L_{2}");
    CHECK(spec.axes[1].values == std::vector<double>{1e-5, 2e-5, 8e-5});
    CHECK(spec.axes[1].log);  // more even in the logarithm
    CHECK(spec.axes[2].values == std::vector<double>{1e-3, 2e-3, 3e-3});
    CHECK(!spec.axes[2].log);
    CHECK(spec.axes[3].values == std::vector<double>{5});
    CHECK(spec.points() == 36);
    CHECK(spec.design == std::vector<std::pair<std::string, double>>{
                             {"control.k_p", 2e3}, {"friction.L.1", 1e-4}, {"control.V0", 1e-3}, {"load.constant", 0}});
    CHECK(spec.joint.control.k_v == 7);    // a design value of no axis holds everywhere
    CHECK(spec.joint.control.k_p == 2e4);  // that of an axis marks a point only
    CHECK(spec.nonlinear.enabled);
    CHECK(spec.nonlinear.disturbance.disturbance.kind == DisturbanceKind::impulse);
    CHECK(spec.nonlinear.disturbance.disturbance.size == 1e-3);
    CHECK(spec.nonlinear.tolerance == 1e-9);
    REQUIRE(spec.boundary);
    CHECK(spec.boundary->kinds == std::vector{BoundaryKind::state_variable, BoundaryKind::fold});
    CHECK(spec.boundary->along == std::vector<std::string>{"friction.f0"});
    CHECK(spec.boundary->over == std::vector<std::string>{"control.k_p=1..2", "control.k_v"});
    CHECK(spec.boundary->guard == 9);
    CHECK(spec.boundary->precision == 1e-4);
    CHECK(spec.report.title == "A page");
    CHECK(spec.report.charts.size() == 2);
    CHECK(spec.report.charts[1][0] == "control.V0");
    CHECK(spec.report.surfaces.size() == 1);
    CHECK(spec.check.tolerance == 0.02);
}

TEST_CASE("a joint file is looked up from the folder of the spec, its errors come with its name")
{
    const TemporaryDirectory folder;
    std::filesystem::create_directories(folder / "joints");
    std::ofstream(folder / "joints" / "arm.toml") << joint << "[record]\n";
    std::ofstream(folder / "spec.toml") << "joint = \"joints/arm.toml\"\n" << axes;
    const Spec spec = read_spec(folder / "spec.toml");
    CHECK(spec.joint.control.k_p == 2e4);
    CHECK(spec.joint_file == (folder / "joints" / "arm.toml").string());
    CHECK_FALSE(spec.boundary);

    std::ofstream(folder / "joints" / "arm.toml") << joint << "[loat]\n";
    std::ofstream(folder / "spec.toml") << "joint = \"joints/arm.toml\"\n[control]\n[chekc]\n" << axes;
    const auto all = messages_of([&] { read_spec(folder / "spec.toml"); });
    REQUIRE(all.size() == 3);
    CHECK_THAT(all[0], StartsWith((folder / "joints" / "arm.toml").string() + ":13:2: loat: unknown key"));
    CHECK_THAT(all[1], StartsWith((folder / "spec.toml").string() + ":2:2: control: does not belong beside joint = "));
    CHECK_THAT(all[2], EndsWith("did you mean \"check\"?"));
    CHECK_THAT(messages_of([&] { read_spec_text("joint = \"x.toml\"\n", "spec.toml", folder.path() / "gone"); }).at(0),
               StartsWith("spec.toml:1:9: joint: names ") &&
                   EndsWith("x.toml, which does not exist; the path starts at this file"));
}

TEST_CASE("axes that are wrong")
{
    const auto axis = [](const std::string& text) { return "[axes]\n" + text + "\n"; };
    const std::string k_p = "\"control.k_p\" = ";
    CHECK(only_error(axis("\"control.kp\" = [1]")) ==
          "@2:1: axes.control.kp: is not a parameter of this joint; did you mean \"control.k_p\"?");
    // a chart may mean the axis that is misspelt, in its wrong or in its right spelling
    for (const std::string chart : {"control.kp", "control.k_p"})
        CHECK_THAT(only_error(axis("\"control.kp\" = [1]\n\"control.k_v\" = [1, 2]") + "[report]\ncharts = [[\"" +
                              chart + "\", \"control.k_v\"]]\n"),
                   StartsWith("@2:1: axes.control.kp: is not a parameter"));
    CHECK_THAT(only_error(axis("\"control.kind\" = [1]")), StartsWith("@2:1: axes.control.kind: is not a parameter"));
    CHECK_THAT(only_error(axis("\"friction.c0\" = [1]")), StartsWith("@2:1: axes.friction.c0: is not a parameter"));
    CHECK_THAT(only_error(axis("\"friction.L.2\" = [1]")), StartsWith("@2:1: axes.friction.L.2: is not a parameter"));
    CHECK(only_error(axis(k_p + "[]")) == "@2:17: axes.control.k_p: is an empty list, expected 1 or more values");
    CHECK(only_error(axis(k_p + "[1, 3, 2]")) == "@2:24: axes.control.k_p: has 2 after 3, expected ascending values");
    CHECK(only_error(axis(k_p + "[1, 1]")) == "@2:21: axes.control.k_p: has 1 after 1, expected ascending values");
    CHECK_THAT(only_error(axis(k_p + "[1, \"2 N\"]")),
               StartsWith("@2:21: axes.control.k_p: \"2 N\": ") && EndsWith("expected N/m"));
    CHECK_THAT(only_error(axis(k_p + "[1, true]")),
               StartsWith("@2:21: axes.control.k_p: is true, expected a number in N/m"));
    CHECK_THAT(only_error(axis("\"joint.inertia\" = [0, 1]")),
               StartsWith("@2:20: axes.joint.inertia: is 0, expected a number in kg, > 0"));
    CHECK_THAT(only_error(axis("\"joint.inertia\" = { from = 0, to = 1, points = 3 }")),
               StartsWith("@2:28: axes.joint.inertia.from: is 0"));
    CHECK_THAT(only_error(axis(k_p + "{ from = 1, points = 3 }")), StartsWith("@2:1: axes.control.k_p.to: is missing"));
    CHECK_THAT(only_error(axis(k_p + "{ from = 1, to = 2 }")), StartsWith("@2:1: axes.control.k_p.points: is missing"));
    CHECK_THAT(only_error(axis(k_p + "{ from = 1, to = 2, points = 0 }")),
               StartsWith("@2:46: axes.control.k_p.points: is 0, expected a whole"));
    CHECK_THAT(only_error(axis(k_p + "{ from = 1, to = 2, points = 2.5 }")),
               StartsWith("@2:46: axes.control.k_p.points: is 2.5"));
    CHECK_THAT(only_error(axis(k_p + "{ from = 1, to = 2, points = -3 }")),
               StartsWith("@2:46: axes.control.k_p.points: is -3"));
    CHECK(only_error(axis(k_p + "{ from = 2, to = 1, points = 3 }")) ==
          "@2:34: axes.control.k_p.to: is 1, expected a value above from = 2");
    CHECK_THAT(only_error(axis(k_p + "{ from = 1, to = 2, points = 1 }")),
               StartsWith("@2:34: axes.control.k_p.to: is 2, expected the value of from"));
    CHECK_THAT(only_error(axis(k_p + "{ from = 1, to = 1.0000000000000002, points = 9 }")),
               Contains("more than there are numbers"));
    CHECK_THAT(only_error(axis(k_p + "{ from = 0, to = 2, points = 3, scale = \"log\" }")),
               StartsWith("@2:1: axes.control.k_p: a log scale needs values > 0, got 0"));
    CHECK_THAT(only_error(axis(k_p + "{ from = -2, to = -1, points = 3, scale = \"log\" }")), Contains("got -2"));
    CHECK(only_error(axis(k_p + "{ from = 1, to = 2, points = 3, scale = \"logg\" }")) ==
          "@2:57: axes.control.k_p.scale: is \"logg\", expected log, linear; did you mean \"log\"?");
    CHECK(only_error(axis(k_p + "{ values = [1, 2], point = 3 }")) ==
          "@2:36: axes.control.k_p.point: unknown key, expected from, to, points, scale, values; did you mean "
          "\"points\"?");
    CHECK(only_error(axis(k_p + "[1, 2]\n\"friction.B.0\" = [1]\ncontrol.k_p = [3]")) ==
          "@4:9: axes.control.k_p: is the same parameter as an axis above");
    CHECK_THAT(only_error("[axes]\n"), StartsWith("@1:1: axes: are empty"));
    CHECK_THAT(only_error(""), StartsWith("@-11:1: axes: is missing, expected one or more dotted paths of the joint, "
                                          "such as \"control.k_p\" = { from"));
}

TEST_CASE("plans that nobody can compute are refused with their size")
{
    const std::string huge = R"([axes]
"control.k_p" = { from = 1, to = 2, points = 100000 }
"control.k_v" = { from = 1, to = 2, points = 100000 }
"control.V0" = { from = 1, to = 2, points = 100000 }
)";
    const PlanLimits limits{1'000'000'000};
    CHECK(only_error(huge, limits) ==
          "@1:1: axes: make 1e+15 points (about 36 PB of results and 12.7 years of one core), expected at most "
          "1e+09");
    // a point that is simulated takes 5e-5 s
    CHECK_THAT(only_error(huge + "[nonlinear]\nenabled = true\n", limits), Contains("1584.5 years of one core"));
    const auto single =
        errors(joint + "[axes]\n\"control.k_p\" = { from = 1, to = 2, points = 1000000000000000 }\n", limits);
    REQUIRE(single.size() == 2);
    CHECK_THAT(single[0], Contains("about 36 PB"));
    CHECK_THAT(single[1], Contains("within [1, 1000000]"));
    std::string overflow = "[axes]\n";
    for (const char* path : {"control.k_p", "control.k_v", "control.V0", "friction.f0", "friction.A", "load.constant"})
        overflow += std::string(path) + " = { from = 1, to = 2, points = 1000000 }\n";
    CHECK_THAT(only_error(overflow), Contains("1e+36 points"));
    CHECK(errors(joint + "[axes]\n\"control.k_p\" = { from = 1, to = 2, points = 1000000 }\n").empty());
}

TEST_CASE("design points that are wrong")
{
    CHECK(only_error(axes + "[design]\n\"control.kp\" = 1\n") ==
          "@5:1: design.control.kp: is not a parameter of this joint; did you mean \"control.k_p\"?");
    CHECK_THAT(only_error(axes + "[design]\n\"joint.inertia\" = -1\n"),
               StartsWith("@5:19: design.joint.inertia: is -1, expected"));
    CHECK_THAT(only_error(axes + "[design]\ncontrol.k_p = \"1 mm\"\n"),
               StartsWith("@5:15: design.control.k_p: \"1 mm\""));
    CHECK(only_error("design = 3\n" + axes).find("friction.design") != std::string::npos);  // it stands in [friction]
}

TEST_CASE("a sweep needs a velocity")
{
    std::string text = joint;
    text.replace(text.find("V0 = 1e-3"), 9, "         ");
    CHECK_THAT(messages_of([&] { read_spec_text(text + axes, "spec.toml"); }).at(0),
               StartsWith("spec.toml:1:1: control.V0: is missing"));
    CHECK(errors(text + axes + "[design]\ncontrol.V0 = 1\n").empty());
    CHECK(errors(text + axes + "[design]\ncontrol.force_rate = 1\n").empty());
    CHECK(errors(text + axes + "\"control.V0\" = [1]\n[design]\ncontrol.V0 = 1\n").empty());
}

TEST_CASE("the other tables")
{
    CHECK_THAT(only_error(axes + "[nonlinear]\nenable = true\n"),
               StartsWith("@5:1: nonlinear.enable: unknown key") && EndsWith("\"enabled\"?"));
    CHECK_THAT(only_error(axes + "[nonlinear]\ntolerance = 1\n"),
               StartsWith("@5:13: nonlinear.tolerance: is 1, expected a number, within"));
    CHECK_THAT(only_error(axes + "[nonlinear]\ndisturbance.kind = \"kick\"\n"),
               StartsWith("@5:20: nonlinear.disturbance.kind: is \"kick\", expected position, velocity, impulse, "
                          "offset, state, start"));
    CHECK_THAT(only_error(axes + "[nonlinear]\ndisturbance = { kind = \"position\", size = \"1 N\" }\n"),
               EndsWith("expected m"));
    CHECK_THAT(
        only_error(axes + "[boundary]\naxis = \"control.kp\"\n"),
        StartsWith("@5:8: boundary.axis: is \"control.kp\", which is not a parameter of this joint; did you mean"));
    CHECK_THAT(only_error(axes + "[boundary]\nkind = [\"folt\"]\n"),
               StartsWith("@5:9: boundary.kind: is \"folt\", expected") && EndsWith("did you mean \"fold\"?"));
    CHECK_THAT(only_error(axes + "[boundary]\nover = [\"control.k_p\"]\n"),
               StartsWith("@5:8: boundary.over: has 1 entries, expected two axes"));
    CHECK_THAT(only_error(axes + "[boundary]\nalong = 3\n"), StartsWith("@5:9: boundary.along: is 3, expected text"));
    CHECK_THAT(only_error(axes + "[boundary]\nprecision = 0\n"), StartsWith("@5:13: boundary.precision: is 0"));
    CHECK_THAT(only_error(axes + "[report]\nchart = []\n"),
               StartsWith("@5:1: report.chart: unknown key") && EndsWith("\"charts\"?"));
    CHECK_THAT(only_error(axes + "[report]\ncharts = [[\"control.k_p\"]]\n"),
               StartsWith("@5:11: report.charts: is a list, expected a pair"));
    CHECK_THAT(only_error(axes + "[report]\ncharts = [[\"control.k_p\", \"control.V0\"]]\n"),
               StartsWith("@5:27: report.charts: is \"control.V0\", expected the axes control.k_p, control.k_v"));
    CHECK_THAT(only_error(axes + "[report]\nsurfaces = [\"control.k_p\", \"control.k_p\"]\n"),
               StartsWith("@5:12: report.surfaces: has \"control.k_p\" twice"));
    CHECK_THAT(only_error(axes + "[report]\ntitle = 3\n"), StartsWith("@5:9: report.title: is 3, expected text"));
    CHECK_THAT(only_error(axes + "[check]\ntolerance = 2\n"),
               StartsWith("@5:13: check.tolerance: is 2, expected a number, within [0, 1]"));
    CHECK_THAT(only_error(axes + "[nonlinera]\n"),
               StartsWith("@4:2: nonlinera: unknown key") && EndsWith("\"nonlinear\"?"));
    CHECK_THAT(errors("nonlinear = 3\ntitle = 4\n" + joint + axes).at(0),
               StartsWith("spec.toml:1:13: nonlinear: is 3, expected a table"));
    CHECK(errors("nonlinear = 3\ntitle = 4\ndesign = 5\nreport = 6\nboundary = 7\naxes = 8\n" + joint).size() == 6);
}

TEST_CASE("spacing is exact at its ends and even between them")
{
    const auto log = spaced(1e-6, 1e-4, 60, true);
    CHECK(log.front() == 1e-6);
    CHECK(log.back() == 1e-4);
    for (std::size_t i = 0; i < log.size(); ++i)
        CHECK(log[i] == Approx(1e-6 * std::pow(100.0, static_cast<double>(i) / 59)).epsilon(1e-13));
    const auto linear = spaced(-1, 1, 5, false);
    CHECK(linear == std::vector<double>{-1, -0.5, 0, 0.5, 1});
}

TEST_CASE("symbols and names of parameters")
{
    CHECK(symbol_of("control.V0", Units(Motion::prismatic)) == "V_{0}");
    CHECK(symbol_of("joint.inertia", Units(Motion::prismatic)) == "m");
    CHECK(symbol_of("joint.link_inertia", Units(Motion::revolute)) == "J_{link}");
    CHECK(symbol_of("friction.link.L.0", Units(Motion::prismatic)) == "L_{1}");
    CHECK(symbol_of("friction.L", Units(Motion::prismatic)) == "L");
    CHECK(symbol_of("friction.motor.f0", Units(Motion::prismatic)) == "f_{0}");
    CHECK(symbol_of("a.some_odd_key", Units(Motion::prismatic)) == "some_{odd key}");
    CHECK(symbol_of("a.plain", Units(Motion::prismatic)) == "plain");
    CHECK(symbol_of("a.some_odd.1", Units(Motion::prismatic)) == "some_{odd,2}");
    CHECK(name_of("control.k_v") == "velocity gain");
    CHECK(name_of("a.some_odd.key_two") == "some odd key two");
    CHECK(name_of("friction.B.1") == "evolution effect 2");
}

TEST_CASE("every example reads")
{
    int specs = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator("examples")) {
        const std::string name = entry.path().filename().string();
        if (!name.starts_with("spec") || !name.ends_with(".toml")) continue;
        INFO(entry.path());
        CHECK(messages_of([&] { read_spec(entry.path()); }) == std::vector<std::string>{});
        ++specs;
    }
    CHECK(specs >= 3);
}
