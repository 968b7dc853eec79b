// Joints as an engineer writes them from data sheets: what their first runs met.
#include "tests/program/run.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using Catch::Matchers::Contains;
using Json = nlohmann::json;
using program::Folder;
using program::stickslip;

namespace {

/// A brushed motor on a lead screw of 2 mm, its gains in V/m: everything at the carriage.
const std::string carriage = R"([joint]
motion = "prismatic"
inertia = 6.0
[control]
k_p = 3.0e4
k_v = 2.0e3
V0 = "0.5 mm/s"
period = "1 ms"
effort_limit = "24 V"
velocity_estimate = { form = "backward-difference" }
[actuator]
kind = "dc-motor"
k_t = 84.0
k_e = 84.0
resistance = "7.1 ohm"
supply_voltage = "24 V"
[friction]
law = "stribeck"
c0 = 18.0
c1 = 40.0
c2 = 6.0
c3 = "1.5 mm/s"
)";

/// A linear motor at 10 kHz behind a dead time and a lag.
const std::string stage = R"([joint]
motion = "prismatic"
inertia = 22
[control]
k_p = 3.5e6
k_v = 1.4e4
k_i = 2e8
V0 = "50 um/s"
period = "100 us"
delay = "150 us"
velocity_estimate = { form = "exact" }
[friction]
law = "dahl"
sigma0 = 4e5
coulomb = 2.0
)";

/// The reference contact with a normal force that moves with it.
const std::string pressed = R"([joint]
motion = "prismatic"
inertia = 1.0
[control]
k_p = 6e4
k_v = 10
V0 = 1e-3
[friction]
law = "rate-and-state"
f0 = 60
A = 1
B = 1.5
L = 1e-5
V_star = 1e-3
[normal]
displacement = 1e4
mu = 0.6
)";

double growth(const std::string& evaluated)
{
    return Json::parse(evaluated)["linear"]["state_variable"]["spectral_abscissa"];
}

}  // namespace

TEST_CASE("gains in volts are an axis like any other", "[program][sheets]")
{
    Folder folder;
    const auto spec = folder.write("spec.toml", carriage + "[axes]\n\"control.k_p\" = [1e4, 3e4, 1e5]\n");
    const auto run = stickslip("sweep '" + spec + "' --no-report --json -o '" + (folder / "out") + "'");
    INFO(run.output);
    REQUIRE(run.exit_code == 0);
    CHECK(Json::parse(run.output)["undecided"] == 0);
}

TEST_CASE("the ideal loop of a motor has its gains in volts, too", "[program][sheets][slow]")
{
    Folder folder;
    const auto joint = folder.write("joint.toml", carriage);
    const auto ideal = stickslip("evaluate '" + joint + "' --ideal-loop --json");
    // the same loop read and computed a hundred thousand times a second
    const auto fast = stickslip("evaluate '" + joint + "' --json --set control.period=1e-5");
    INFO(ideal.output);
    CHECK(growth(ideal.output) == Approx(growth(fast.output)).epsilon(1e-2));
    const auto said = stickslip("evaluate '" + joint + "' --ideal-loop").output;
    CHECK_THAT(said, Contains("leaves out control.period, control.velocity_estimate.form of the joint file"));
}

TEST_CASE("every verb that has a loop takes the ideal one", "[program][sheets][slow]")
{
    Folder folder;
    const auto joint = folder.write("joint.toml", carriage);
    const auto spec = folder.write("spec.toml", carriage +
                                                    "[axes]\n\"control.k_p\" = { from = 1e3, to = 1e6, points = 5, "
                                                    "scale = \"log\" }\n\"control.k_v\" = { from = 10, to = 1e4, "
                                                    "points = 5, scale = \"log\" }\n");
    const std::string out = " -o '" + (folder / "out") + "'", base = "'" + (folder / "base.json") + "'";
    for (const auto& line :
         {"evaluate '" + joint + "'", "margins '" + joint + "'", "boundary '" + joint + "' --along control.k_v",
          "simulate '" + joint + "'" + out, "sweep '" + spec + "' --no-report" + out,
          "check '" + spec + "' " + base + " --update", "check '" + spec + "' " + base}) {
        const auto run = stickslip(line + " --ideal-loop");
        INFO(line << "\n" << run.output);
        CHECK(run.exit_code == 0);
        CHECK_THAT(run.output, Contains("--ideal-loop leaves out control.period"));
    }
    // the real loop has other boundaries
    CHECK(stickslip("check '" + spec + "' " + base).exit_code == 1);
}

TEST_CASE("gains of the ideal loop are designed into the file as it is", "[program][sheets][slow]")
{
    Folder folder;
    const auto joint = folder.write("joint.toml", carriage);
    const auto run = stickslip("design '" + joint +
                               "' --ideal-loop --effort 0.1 --require 'position_noise=1 um' "
                               "--require front_points=2 -o '" +
                               (folder / "out") + "'");
    INFO(run.output);
    REQUIRE(run.exit_code == 0);
    CHECK_THAT(program::read(folder / "out/designed-joint.toml"), Contains("period = 0.001"));
}

TEST_CASE("a long motion in short ticks is simulated and drawn to its end", "[program][sheets][slow]")
{
    Folder folder;
    const auto run = stickslip("simulate '" + folder.write("joint.toml", stage) + "' -o '" + (folder / "out") + "'");
    INFO(run.output);
    CHECK(run.exit_code == 0);
    CHECK_THAT(run.output, !Contains("picture") && !Contains("ends at"));
    const auto rows = program::shell("wc -l < '" + (folder / "out/trajectory.csv") + "'").output;
    CHECK(std::stoul(rows) < 300'010);
    CHECK(std::filesystem::file_size(folder / "out/report.html") < 6'000'000);
}

TEST_CASE("a normal force that moves with the joint is refused by name where motions are simulated",
          "[program][sheets]")
{
    Folder folder;
    const auto joint = folder.write("joint.toml", pressed);
    const auto reference = folder.write("reference.csv", "time,reference_position\n0,0\n0.5,0.0005\n1,0.001\n");
    const auto along =
        stickslip("simulate '" + joint + "' --reference '" + reference + "' -o '" + (folder / "o") + "'");
    CHECK(along.exit_code == 2);
    CHECK_THAT(along.output,
               Contains("cannot follow a reference: [normal], a normal load that depends on the motion, is "
                        "part of the linear theory only"));
    const auto alone = stickslip("simulate '" + joint + "' -o '" + (folder / "o") + "'");
    CHECK(alone.exit_code == 4);
    CHECK_THAT(alone.output, Contains("No motion: a normal load that depends on the motion ([normal])"));
}

TEST_CASE("a disturbed state of a law without one is no undefined law", "[program][sheets]")
{
    Folder folder;
    const auto joint = folder.write("joint.toml", carriage);
    for (const std::string loop : {"", " --ideal-loop"}) {
        const auto run = stickslip("evaluate '" + joint + "' --disturbance state --size 0.5" + loop);
        INFO(run.output);
        CHECK(run.exit_code == 4);
        CHECK_THAT(run.output, Contains("a disturbed state is one of the friction on the link, and its law has none"));
    }
    const auto run = stickslip("simulate '" + joint + "' --disturbance state --size 0.5 -o '" + (folder / "o") + "'");
    CHECK_THAT(run.output, Contains("No motion: a disturbed state is one of the friction on the link"));
}

TEST_CASE("a sampled force loop has no velocity to estimate", "[program][sheets]")
{
    Folder folder;
    const auto joint = folder.write("joint.toml", R"([joint]
motion = "prismatic"
inertia = 3.0
[control]
kind = "force"
k_p = 2e4
k_v = 20
force_gain = 0.8
V0 = 1e-3
period = "2 ms"
[friction]
law = "coulomb-viscous"
coulomb = 8
viscous = 60
)");
    const auto run = stickslip("margins '" + joint + "'");
    INFO(run.output);
    CHECK(run.exit_code == 0);
}

TEST_CASE("a mechanism that grows beyond all numbers within a tick is unstable", "[program][sheets][slow]")
{
    Folder folder;
    // a planetary gear whose inertia stands at the slow side: falling friction drives it at 2·10^6 1/s, e^744 in a tick
    const auto joint = folder.write("joint.toml", R"([joint]
motion = "revolute"
model = "three-mass"
motor_inertia = 2.2e-6
transmission_inertia = 1.5e-7
link_inertia = 0.02
motor_transmission = { stiffness = 900, damping = 0.3, ratio = 156 }
transmission_link = { stiffness = 450, damping = 0.2, ratio = 1 }
[control]
k_p = 120.0
k_v = 1.5
V0 = 0.02
period = 4e-4
velocity_estimate = { form = "backward-difference", tau = 0.002 }
[friction.motor]
law = "coulomb-viscous"
coulomb = 0.002
viscous = 1e-6
[friction.transmission]
law = "stribeck"
c0 = 0.25
c1 = 0.1
c2 = 0.12
c3 = 0.01
[friction.link]
law = "coulomb-viscous"
coulomb = 0.05
viscous = 0.01
)");
    const auto run = stickslip("evaluate '" + joint + "' --json");
    INFO(run.output);
    REQUIRE(run.exit_code == 0);
    CHECK(growth(run.output) > 1e6);
    CHECK(Json::parse(run.output)["linear"]["state_variable"]["stable"] == false);
}

TEST_CASE("a fold just beyond its Hopf point is no Hopf point on a wide axis", "[program][sheets][slow]")
{
    // found along 53.8 to 53.9 kN/m and by evaluate; along four decades the critical gain was called a fold
    Folder folder;
    const auto joint = folder.write("joint.toml", R"([joint]
motion = "prismatic"
inertia = 1.0
[control]
k_p = 4e4
k_v = 10
V0 = "-1 mm/s"
[friction]
law = "rate-and-state-regularised"
evolution = "ageing"
f0 = 60
A = 1.0
B = 1.5
L = 1e-5
V_star = 1e-3
)");
    const auto wide = stickslip("boundary '" + joint + "' --kind fold --along control.k_p --json");
    const auto near = stickslip("evaluate '" + joint + "' --json");
    INFO(wide.output);
    const auto points = Json::parse(wide.output)["lines"][0]["points"];
    REQUIRE(points.size() == 1);
    CHECK(points[0]["value"].get<double>() ==
          Approx(Json::parse(near.output)["nonlinear"]["fold_k_p"].get<double>()).epsilon(1e-6));
}

TEST_CASE("margins of a set point say that it does not slide", "[program][sheets][slow]")
{
    Folder folder;
    const auto run = stickslip("margins '" + folder.write("joint.toml", carriage) + "' --set control.V0=0");
    CHECK(run.exit_code == 4);
    CHECK_THAT(run.output,
               Contains("No margin, as the joint has no verdict: the joint cannot slide at this velocity: V_0 "
                        "= 0 is a set point") &&
                   !Contains("boundary at"));
    const auto far = stickslip("margins '" + folder.write("far.toml", carriage) + "'");
    CHECK_THAT(far.output, Contains("no boundary within ×10"));
}
