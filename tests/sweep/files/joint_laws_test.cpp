#include "analysis/joint/parameters.h"
#include "sweep/files/toml/joint_file.h"
#include "tests/sweep/files/messages.h"
#include "tests/temporary_directory.h"

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <string>

using namespace stickslip;
using Catch::EndsWith;
using Catch::StartsWith;

TEST_CASE("rows of a law, a law inside a law, a table from a file")
{
    const TemporaryDirectory directory;
    const auto folder = directory.path() / "tables";
    std::filesystem::create_directory(folder);
    const auto table = [&](const std::string& content) { std::ofstream(folder / "g.csv") << content; };
    const std::string head = "joint.inertia = 1\ncontrol.k_p = 1\n";
    const std::string kernel = head + "[friction]\nlaw = \"kernel\"\nf_v = 1\ntable = \"g.csv\"\n";
    const auto error = [&](const std::string& text) {
        const auto all = messages_of([&] { read_joint_text(text, "joint.toml", folder); });
        for (const auto& message : all) UNSCOPED_INFO(message);
        REQUIRE(all.size() == 1);
        return all.front();
    };
    table("# measured\ntime,g\n0,5\n0.5,2\n1,0\n");
    Joint joint = read_joint_text(
        kernel +
            "exponentials = { weight = 2, rate = \"3 Hz\" }\n[[friction.delays]]\nweight = 1\ntime = \"2 ms\"\n"
            "[[friction.delays]]\nweight = \"1 N·s/mm\"\ntime = 1\n",
        "joint.toml", folder);
    const auto& law = std::get<Kernel>(joint.friction.law);
    CHECK(law.exponentials.size == 1);
    CHECK(law.exponentials[0].rate == 3);
    REQUIRE(law.impulses.size == 2);
    CHECK(law.impulses[0].time == 2e-3);
    CHECK(law.impulses[1].weight == 1000);
    REQUIRE(law.samples);
    CHECK(law.samples->time == std::vector<double>{0, 0.5, 1});
    CHECK(law.samples->value == std::vector<double>{5, 2, 0});
    apply_setting(joint, "friction.delays.1.time=4 ms");
    CHECK(std::get<Kernel>(joint.friction.law).impulses[1].time == 4e-3);
    CHECK_THAT(messages_of([&] { apply_setting(joint, "friction.delays.2.time=4"); }).at(0),
               EndsWith("friction.delays.2: there is no such element; the list has 2, counted from 0"));
    CHECK_THAT(error(kernel + "exponentials = 3\n"),
               StartsWith("joint.toml:7:16: friction.exponentials: is 3, expected a list of"));
    CHECK_THAT(error(kernel + "exponentials = [1]\n"),
               StartsWith("joint.toml:7:17: friction.exponentials: is 1, expected a table"));
    CHECK_THAT(error(kernel + "exponentials = [{ weight = 1 }]\n"),
               StartsWith("joint.toml:7:17: friction.exponentials.0.rate: is missing"));
    CHECK_THAT(error(kernel + "exponentials = [{ weight = 1, rate = 1, tau = 2 }]\n"),
               StartsWith("joint.toml:7:41: friction.exponentials.0.tau: unknown key, expected weight, rate"));

    const std::string place = "joint.toml:6:9: friction.table: is \"g.csv\": " + (folder / "g.csv").string();
    table("0,1\n1,x\n");
    CHECK(error(kernel) == place + ":2:1: is not a row of two numbers, time and g: \"1,x\"");
    table("0.5,1\n1,1\n");
    CHECK(error(kernel) == place + ": the table must start at time 0");
    table("");
    CHECK(error(kernel) == place + ": has fewer than two rows of numbers, time and g");
    std::filesystem::remove_all(folder);
    CHECK(error(kernel) == place + ": there is no such file");

    const Joint lagged = read_joint_text(head +
                                             "[friction]\nlaw = \"time-lag\"\nlag = \"5 ms\"\n"
                                             "curve = { law = \"stribeck\", c0 = 1, c1 = 2, c2 = 3, c3 = 4 }\n",
                                         "joint.toml");
    CHECK(std::get<TimeLag>(lagged.friction.law).lag == 5e-3);
    CHECK_THAT(
        error(head + "[friction]\nlaw = \"time-lag\"\nlag = 1\ncurve = { law = \"stribek\" }\n"),
        StartsWith("joint.toml:6:17: friction.curve.law: is \"stribek\", expected ") && EndsWith("\"stribeck\"?"));
    CHECK_THAT(error(head + "[friction]\nlaw = \"time-lag\"\nlag = 1\n"),
               StartsWith("joint.toml:3:1: friction.curve.law: is missing"));
}

TEST_CASE("registers of a servo are gains in SI")
{
    const std::string body =
        "[joint]\nmotion = \"revolute\"\ninertia = 0.001\n[friction]\nlaw = "
        "\"coulomb-viscous\"\ncoulomb = 0.02\nviscous = 0.001\n[control]\n";
    const auto dynamixel = read_joint_text(body + "servo = \"dynamixel-xl330\"\nregisters = { P = 400 }\n", "j");
    // 400/128 PWM a pulse, 4096 pulses a revolution, 885 PWM at full duty
    CHECK(dynamixel.control.k_p == Approx(3.125 * 4096 / (2 * 3.14159265358979) / 885));
    const auto odrive = read_joint_text(
        body + "servo = \"odrive\"\nregisters = { pos_gain = 20, vel_gain = 0.16, vel_integrator_gain = 0.32 }\n", "j");
    CHECK(odrive.control.structure == Structure::cascade);
    CHECK(odrive.control.position_gain == 20);
    CHECK(odrive.control.velocity_gain == Approx(0.16 / 6.28318530717959));
    CHECK(odrive.control.velocity_integral_gain == Approx(0.32 / 6.28318530717959));
    const auto moteus = read_joint_text(body + "servo = \"moteus\"\nregisters = { kp = 4, kd = 0.05, ki = 1 }\n", "j");
    CHECK(moteus.control.k_p == Approx(4 / 6.28318530717959));
    CHECK(moteus.control.k_i == Approx(1 / 6.28318530717959));
    const auto both = messages_of(
        [&] { read_joint_text(body + "servo = \"dynamixel-xl330\"\nregisters = { P = 400 }\nk_p = 3\n", "j"); });
    REQUIRE(both.size() == 1);
    CHECK_THAT(both[0], StartsWith("j:") && EndsWith("expected one of them"));
}
