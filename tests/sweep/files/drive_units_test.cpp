// Gains behind a DC motor have the unit of its signal: in files, in what is written back and in sentences.
#include "sweep/files/toml/joint_file.h"
#include "sweep/words/heading_text.h"
#include "tests/sweep/files/messages.h"

#include <catch2/catch.hpp>

using namespace stickslip;
using Catch::Matchers::Contains;

namespace {

Joint read(const std::string& text)
{
    return read_joint_text(text, "joint.toml");
}

std::string motor_joint(const std::string& signal, const std::string& k_p)
{
    return R"([joint]
motion = "revolute"
model = "single-mass"
inertia = 0.01
[control]
k_p = )" + k_p +
           R"(
k_v = 2
k_i = 5
V0 = 0.1
effort_limit = 12
[actuator]
kind = "dc-motor"
k_t = 0.5
k_e = 0.5
resistance = 2
supply_voltage = 24
signal = ")" +
           signal + R"("
[friction]
law = "coulomb-viscous"
coulomb = 1
viscous = 0.1
)";
}

}  // namespace

TEST_CASE("gains of a motor on voltage are read in volts", "[units]")
{
    CHECK(read(motor_joint("voltage", "\"350 V/rad\"")).control.k_p == 350);
    CHECK(read(motor_joint("voltage", "\"0.35 V/mrad\"")).control.k_p == Approx(350));
    CHECK(read(motor_joint("duty", "\"15 1/rad\"")).control.k_p == 15);
    const auto errors = messages_of([] { read(motor_joint("voltage", "\"350 N·m/rad\"")); });
    REQUIRE(errors.size() == 1);
    CHECK_THAT(errors[0], Contains("is not a unit of this quantity, expected V/rad"));
}

TEST_CASE("a setting of such a gain has the same unit", "[units]")
{
    auto joint = read(motor_joint("voltage", "350"));
    apply_setting(joint, "control.k_p = \"20 V/rad\"");
    CHECK(joint.control.k_p == 20);
    CHECK_THROWS(apply_setting(joint, "control.k_p = \"20 N·m/rad\""));
}

TEST_CASE("the text of such a joint says its units, and is read again", "[units]")
{
    for (const auto& [signal, k_p, k_v, k_i, limit] :
         {std::tuple{"voltage", "# V/rad", "# V·s/rad", "# V/(rad·s)", "# V\n"},
          std::tuple{"duty", "# 1/rad", "# s/rad", "# 1/(rad·s)", "effort_limit = 12\n"}}) {
        const auto joint = read(motor_joint(signal, "350"));
        const std::string text = joint_text(joint);
        INFO(text);
        CHECK_THAT(text, Contains(k_p) && Contains(k_v) && Contains(k_i) && Contains(limit));
        CHECK_THAT(text, !Contains("k_p = 350.0                 # N"));
        CHECK(joint_text(read(text)) == text);
    }
}

TEST_CASE("gains of an effort keep the units of springs and dampers", "[units]")
{
    auto joint = read(motor_joint("voltage", "350"));
    CHECK_THAT(gains_text(joint), Contains("350 V/rad") && Contains("2 V·s/rad"));
    joint.actuator = {};
    CHECK_THAT(gains_text(joint), Contains("350 N·m/rad") && Contains("2 N·m·s/rad"));
}
