// Symbol and name of a number come from its declaration, not from the spelling of its path.
#include "analysis/joint/signs.h"

#include <catch2/catch.hpp>

using namespace stickslip;

TEST_CASE("a number is written as its declaration says, whatever the model, controller, drive and law", "[joint]")
{
    const auto is = [](const char* path, const char* symbol, const char* name) {
        INFO(path);
        const Sign* sign = sign_of(path);
        REQUIRE(sign);
        CHECK(sign->symbol == symbol);
        CHECK(sign->name == name);
    };
    is("control.k_p", "k_{p}", "position gain");
    is("control.velocity_gain", "K_{v}", "velocity gain of the cascade");
    is("actuator.k_t", "k_{t}", "torque constant");
    is("joint.transmission.stiffness", "k_{tr}", "transmission stiffness");
    is("joint.motor_transmission.stiffness", "k_{m-tr}", "motor-transmission stiffness");
    is("joint.transmission_link.damping", "c_{tr-l}", "transmission-link damping");
    is("friction.motor.L", "L", "slip distance");
    is("friction.curve.c2", "c_{2}", "Stribeck peak");
    is("friction.memory.B", "B", "evolution effect");
    CHECK(sign_of("joint.lever_arm")->quantity == Quantity::length);
}

TEST_CASE("a path that only ends like a number's has no sign", "[joint]")
{
    for (const char* path : {"k_p", "motor_transmission.stiffness", "neighbour.0.inertia", "friction.attraction", ""})
        CHECK(sign_of(path) == nullptr);
}
