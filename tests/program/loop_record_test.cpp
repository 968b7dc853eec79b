// From a joint to a record of its loop, and from the record back to the joint.
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/example_joint.h"
#include "tests/program/run.h"

using namespace program;

namespace {

const std::string machine =
    "[joint]\nmotion = \"revolute\"\nmodel = \"single-mass\"\ninertia = 0.05\n"
    "[control]\nk_p = 30\nk_v = 1.5\nperiod = 0.002\ndelay = 0.004\n"
    "[control.velocity_estimate]\nform = \"backward-difference\"\ntau = 0.004\n"
    "[friction]\nlaw = \"coulomb-viscous\"\ncoulomb = 0.4\nviscous = 0.15\n"
    "[sensor]\nencoder_quantum = 0.0002\nposition_noise = 0.0001\neffort_noise = 0.01\n";

/// Swings with reversals, rests and fast parts, every 2 ms.
std::string reference()
{
    std::ostringstream rows;
    rows.precision(12);
    rows << "time,reference_position,reference_velocity\n";
    for (int k = 0; k <= 6000; ++k) {
        const double t = 0.002 * k;
        const double a = 2 * M_PI * 0.25, b = 2 * M_PI * 0.7, c = 2 * M_PI * 1.6;
        rows << t << ',' << 0.8 * (1 - std::cos(a * t)) + 0.3 * std::sin(b * t) + 0.08 * std::sin(c * t) << ','
             << 0.8 * a * std::sin(a * t) + 0.3 * b * std::cos(b * t) + 0.08 * c * std::cos(c * t) << '\n';
    }
    return rows.str();
}

/// What diagnose makes of the record that this joint leaves, taken for the one without these settings.
nlohmann::json diagnosis_of(const Folder& folder, const std::string& settings, const std::string& of = machine)
{
    const auto joint = folder.write("joint.toml", of);
    const auto motion = folder.write("motion.csv", reference());
    const auto out = folder / "record";
    const auto played = stickslip("simulate " + joint + settings + " --reference " + motion + " --seed 5 -o " + out);
    INFO(played.output);
    REQUIRE(played.exit_code == 0);
    const auto found = stickslip("diagnose " + joint + " " + out + "/record.csv --no-report -o " + (folder / "found"));
    INFO(found.output);
    REQUIRE(found.exit_code == 0);
    return nlohmann::json::parse(read(folder / "found/diagnosis.json"));
}

}  // namespace

TEST_CASE("a record that the joint itself played has no gap", "[slow]")
{
    const Folder folder;
    CHECK(diagnosis_of(folder, "")["verdict"] == "no-gap");
}

TEST_CASE("a record of an edited joint names the edit", "[slow]")
{
    const Folder folder;
    const auto found = diagnosis_of(folder, " --set control.delay=0.012");
    CHECK(found["verdict"] == "gap");
    REQUIRE(!found["effects"].empty());
    CHECK(found["effects"][0]["names"][0] == "delay");
}

TEST_CASE("a record of a continuous loop has no gap, and names the edit of its joint", "[slow]")
{
    const Folder folder;
    const auto sampled = machine.find("period"), friction = machine.find("[friction]");
    const auto continuous = machine.substr(0, sampled) + machine.substr(friction);
    const auto same = diagnosis_of(folder, "", continuous);
    CHECK(same["verdict"] == "no-gap");
    CHECK(same["note_codes"].dump().find("straight-commands") != std::string::npos);
    const auto found = diagnosis_of(folder, " --set control.k_p=20", continuous);
    CHECK(found["verdict"] == "gap");
    REQUIRE(!found["effects"].empty());
    CHECK(found["effects"][0]["names"][0] == "gain-k_p");

    // a delayed loop moves as if its commands were held for longer; what the controller feeds back is seen in its
    // commands
    const auto late = diagnosis_of(folder, " --set control.delay=0.008", continuous);
    REQUIRE(!late["effects"].empty());
    CHECK(late["effects"][0]["names"].dump() == "[\"delay\"]");
    CHECK(late["effects"][0]["parameters"]["delay.time"]["value"].get<double>() == Approx(0.008).margin(5e-4));
}

TEST_CASE("what records are not simulated with is refused")
{
    const Folder folder;
    const auto motion = folder.write("motion.csv", reference());
    const auto joint = folder.write("joint.toml", machine);
    REQUIRE(stickslip("simulate " + joint + " --reference " + motion + " -o " + (folder / "record")).exit_code == 0);
    auto pressed = machine;
    pressed.insert(pressed.find("period"), "contact_stiffness = 50\n");
    const auto run = stickslip("diagnose " + folder.write("pressed.toml", pressed) + " " + (folder / "record") +
                               "/record.csv --no-report -o " + (folder / "found"));
    CHECK(run.exit_code == 2);
    CHECK_THAT(run.output, Catch::Contains("pressed.toml: control.contact_stiffness"));
}

TEST_CASE("a gear that loses more when the load drives it is friction that depends on the load", "[slow]")
{
    const Folder folder;
    const auto arm = "[load]\ngravity_amplitude = 3\n" + machine;
    CHECK(diagnosis_of(folder, " --set friction.gear.forward=0.05 --set friction.gear.backward=0.5",
                       arm)["effects"][0]["names"]
              .dump() == "[\"load-dependent-friction\"]");
    const auto found = nlohmann::json::parse(read(folder / "found/diagnosis.json"))["effects"][0]["parameters"];
    INFO(found.dump());
    CHECK(found["load-dependent-friction.forward"]["value"].get<double>() == Approx(0.05).margin(0.01));
    CHECK(found["load-dependent-friction.backward"]["value"].get<double>() == Approx(0.5).margin(0.02));
    CHECK_THAT(read(folder / "found/corrected-joint.toml"), Catch::Contains("backward = 0."));
}

TEST_CASE("a law that no record is fitted with says what to write instead", "[slow]")
{
    const Folder folder;
    const auto motion = folder.write("motion.csv", reference());
    const auto before = machine.find("law = "), after = machine.find("[sensor]");
    const auto refused = [&](const std::string& law) {
        const auto joint = folder.write("joint.toml", machine.substr(0, before) + law + machine.substr(after));
        const auto out = folder / "record";
        REQUIRE(stickslip("simulate " + joint + " --reference " + motion + " -o " + out).exit_code == 0);
        const auto run =
            stickslip("diagnose " + joint + " " + out + "/record.csv --no-report -o " + (folder / "found"));
        CHECK(run.exit_code == 2);
        CHECK_THAT(run.output, Catch::Contains("joint.toml: friction law"));
        return run.output;
    };
    CHECK_THAT(refused("law = \"maxwell-slip\"\nviscous = 0.15\nelements = [{ stiffness = 100, yield = 0.3 }, "
                       "{ stiffness = 20, yield = 0.1 }]\n"),
               Catch::Contains("coulomb = 0.4, viscous = 0.15, bristle = { stiffness = 120 }"));
    CHECK_THAT(refused("law = \"time-lag\"\nlag = 0.004\n[friction.curve]\nlaw = \"coulomb-viscous\"\n"
                       "coulomb = 0.4\nviscous = 0.15\n"),
               Catch::Contains("lag = 0.004, lag_viscous = true"));
}

TEST_CASE("a reference that cannot be followed says why")
{
    const Folder folder;
    const auto motion = folder.write("motion.csv", "time,reference_position\n0,0\n1,0\n2,0.1\n");
    const auto sliding = folder.write("joint.toml", example_joint_text(1, 6e4, 10, 1e-3));
    const auto run = stickslip("simulate " + sliding + " --reference " + motion + " -o " + (folder / "out"));
    CHECK(run.exit_code == 2);
    CHECK_THAT(run.output, Catch::Contains("no friction at rest"));
    const auto broken = folder.write("broken.csv", "time,reference_position\n0,0\n1,x\n");
    const auto second = stickslip("simulate " + folder.write("machine.toml", machine) + " --reference " + broken);
    CHECK(second.exit_code == 2);
    CHECK_THAT(second.output, Catch::Contains("broken.csv:3"));
}

TEST_CASE("what records are simulated without is said", "[slow]")
{
    const Folder folder;
    const auto plain = diagnosis_of(folder, "");
    CHECK(plain["notes"].dump().find("are simulated without") == std::string::npos);
    const auto more = folder.write("more.toml", machine +
                                                    "[normal]\nvelocity = 0.01\n[[neighbour]]\ninertia = 1.0\n"
                                                    "coupling = 0.001\n");
    const auto found = stickslip("diagnose " + more + " " + (folder / "record/record.csv") + " --no-report --json -o " +
                                 (folder / "found"));
    INFO(found.output);
    REQUIRE(found.exit_code == 0);
    CHECK(found.output.find("without normal.velocity, neighbour") != std::string::npos);
}

TEST_CASE("a motor of another back-EMF constant is told from viscous friction by its effort", "[slow]")
{
    const std::string motor = machine +
                              "[actuator]\nkind = \"dc-motor\"\nk_t = 0.8\nk_e = 0.8\nresistance = 1.5\n"
                              "supply_voltage = 48\nsignal = \"voltage\"\n";
    for (const auto& [edit, name] :
         {std::pair{" --set actuator.k_e=0.7", "effort-gain"}, std::pair{" --set friction.viscous=0.35", "viscous"}}) {
        const Folder folder;
        const auto found = diagnosis_of(folder, edit, motor);
        INFO(found["effects"].dump());
        CHECK(found["effects"][0]["names"] == nlohmann::json{name});
    }
}

TEST_CASE("the lesser friction of two masses is named when its document is wrong", "[slow]")
{
    const std::string geared =
        "[joint]\nmotion = \"revolute\"\nmodel = \"two-mass\"\nmotor_inertia = 0.5\nlink_inertia = 1.1\n"
        "[joint.transmission]\nstiffness = 3e4\ndamping = 30\n"
        "[control]\nk_p = 1.2e4\nk_v = 200\nperiod = 0.002\n"
        "[control.velocity_estimate]\nform = \"backward-difference\"\ntau = 0.002\n"
        "[friction.motor]\nlaw = \"coulomb-viscous\"\ncoulomb = 10\nviscous = 0.2\n"
        "[friction.link]\nlaw = \"coulomb-viscous\"\ncoulomb = 0.8\nviscous = 0.5\n"
        "[sensor]\nencoder_quantum = 1e-7\nposition_noise = 2e-7\n";
    const Folder folder;
    const auto found = diagnosis_of(folder, " --set friction.link.coulomb=3", geared);
    INFO(found["effects"].dump());
    CHECK(found["verdict"] == "gap");
    CHECK(found["effects"][0]["names"] == nlohmann::json{"coulomb-level"});
}

TEST_CASE("a spring that hardens is compliance, whether the file has a linear one or none", "[slow]")
{
    const std::string loop =
        "[control]\nk_p = 1.2e4\nk_v = 200\nperiod = 0.002\n"
        "[control.velocity_estimate]\nform = \"backward-difference\"\ntau = 0.002\n"
        "[sensor]\nencoder_quantum = 1e-7\nposition_noise = 2e-7\n";
    const std::string two_masses =
        loop +
        "[joint]\nmotion = \"revolute\"\nmodel = \"two-mass\"\nmotor_inertia = 0.5\nlink_inertia = 1.1\n"
        "[joint.transmission]\nstiffness = 3000\ndamping = 5\n"
        "[friction.motor]\nlaw = \"coulomb-viscous\"\ncoulomb = 8\nviscous = 0.2\n"
        "[friction.link]\nlaw = \"coulomb-viscous\"\ncoulomb = 3\nviscous = 0.5\n";
    const std::string one_mass = loop +
                                 "[joint]\nmotion = \"revolute\"\nmodel = \"single-mass\"\ninertia = 1.6\n"
                                 "[friction]\nlaw = \"coulomb-viscous\"\ncoulomb = 11\nviscous = 0.7\n";
    // as much again where the linear part carries 8 N·m
    const Folder folder;
    const auto documented = diagnosis_of(folder, " --set joint.transmission.cubic_stiffness=4.2e8", two_masses);
    INFO(documented["effects"].dump());
    CHECK(documented["effects"][0]["names"] == nlohmann::json{"compliance"});
    const auto& found = documented["effects"][0]["parameters"];
    CHECK(found["compliance.hardening_effort"]["value"].get<double>() ==
          Approx(std::sqrt(2.7e10 / 4.2e8)).epsilon(0.1));

    const auto joint = folder.write("rigid.toml", one_mass);
    const auto run =
        stickslip("diagnose " + joint + " " + (folder / "record") + "/record.csv --no-report -o " + (folder / "rigid"));
    INFO(run.output);
    REQUIRE(run.exit_code == 0);
    const auto rigid = nlohmann::json::parse(read(folder / "rigid/diagnosis.json"));
    CHECK(rigid["effects"][0]["names"] == nlohmann::json{"compliance"});
}
