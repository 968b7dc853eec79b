#include "sweep/files/text/units.h"

#include <catch2/catch.hpp>
#include <string>

using namespace stickslip;

namespace {

double read(const std::string& text, Quantity quantity, Units units = {})
{
    const auto reading = parse_number_with_unit(text, quantity, units);
    INFO(text << ": " << reading.error);
    REQUIRE(reading.error.empty());
    return reading.value;
}

std::string error(const std::string& text, Quantity quantity, Units units = {})
{
    return parse_number_with_unit(text, quantity, units).error;
}

constexpr Units revolute(Motion::revolute);

}  // namespace

// Factors: The International System of Units (SI), 9th ed., BIPM 2019, tables 4, 7, 8.
TEST_CASE("decimal units give the same double as the SI number would")
{
    CHECK(read("1 mm/s", Quantity::velocity) == 1e-3);
    CHECK(read("10 µm", Quantity::position) == 1e-5);  // U+00B5
    CHECK(read("10 μm", Quantity::position) == 1e-5);  // U+03BC
    CHECK(read("10um", Quantity::position) == 1e-5);
    CHECK(read("2e4 N/m", Quantity::stiffness) == 2e4);
    CHECK(read("20 kN/m", Quantity::stiffness) == 2e4);
    CHECK(read("0.02 N/um", Quantity::stiffness) == 2e4);
    // as data sheets print them
    CHECK(read("4.5 kgm2", Quantity::inertia, revolute) == 4.5);
    CHECK(read("35 kgcm2", Quantity::inertia, revolute) == 35e-4);
    CHECK(read("35 gcm²", Quantity::inertia, revolute) == 35e-7);
    CHECK(read("52.5 mNm/A", Quantity::torque_constant, revolute) == 0.0525);
    CHECK(read("350 g", Quantity::inertia) == 0.35);
    CHECK(read("0.35 kg", Quantity::inertia) == 0.35);
    CHECK(read("3 ms", Quantity::time) == 3e-3);
    CHECK(read("-7.5 cm", Quantity::position) == -0.075);
    CHECK(read("+7.5 cm", Quantity::position) == 0.075);
    CHECK(read("4.7 mΩ", Quantity::resistance) == 4.7e-3);
    CHECK(read("4.7 kohm", Quantity::resistance) == 4700);
    CHECK(read("13 mV", Quantity::voltage) == 13e-3);
    CHECK(read("25 %", Quantity::number) == 0.25);
    CHECK(read("1.5E+2 mm", Quantity::position) == 0.15);
    CHECK(read("1e-2 MN", Quantity::effort) == 1e4);
}

TEST_CASE("angles, turns and minutes")
{
    const double pi = 3.14159265358979323846;
    CHECK(read("180 deg", Quantity::position, revolute) == Approx(pi).epsilon(1e-15));
    CHECK(read("180°", Quantity::angle) == Approx(pi).epsilon(1e-15));
    CHECK(read("60 rpm", Quantity::velocity, revolute) == Approx(2 * pi).epsilon(1e-15));
    CHECK(read("1 rev/s", Quantity::velocity, revolute) == Approx(2 * pi).epsilon(1e-15));
    CHECK(read("60 arcmin", Quantity::angle) == Approx(pi / 180).epsilon(1e-15));
    CHECK(read("3600 arcsec", Quantity::angle) == Approx(pi / 180).epsilon(1e-15));
    CHECK(read("2 min", Quantity::time) == 120);
    CHECK(read("5 mrad", Quantity::position, revolute) == 5e-3);
}

TEST_CASE("one unit, many spellings")
{
    for (const char* text :
         {"3 N·m·s/rad", "3 N m s/rad", "3 N*m*s/rad", "3 N.m.s/rad", "3 N⋅m⋅s/rad", "3 Nm s/rad", "3 Nms/rad",
          "3 N·m/(rad/s)", "3 kg m^2/s/rad", "3 kg·m²·s⁻¹·rad⁻¹", "3 kg m^2 s^-1 rad^-1", "3 J s/rad"})
        CHECK(read(text, Quantity::damping, revolute) == 3);
    CHECK(read("3 V/(rad/s)", Quantity::back_emf, revolute) == 3);
    CHECK(read("3 kg·mm²", Quantity::inertia, revolute) == 3e-6);
    CHECK(read("3 kg mm^2", Quantity::rotary_inertia) == 3e-6);
    CHECK(read("2 Hz", Quantity::rate) == 2);
}

TEST_CASE("temperatures have an offset, and only alone")
{
    CHECK(read("25 °C", Quantity::temperature) == 25);
    CHECK(read("298.15 K", Quantity::temperature) == Approx(25).epsilon(1e-14));
    CHECK_THAT(error("25 °C/s", Quantity::temperature), Catch::Contains("cannot stand in a product"));
    CHECK_THAT(error("25 s·°C", Quantity::temperature), Catch::Contains("cannot stand in a product"));
    CHECK_THAT(error("25 °C²", Quantity::temperature), Catch::Contains("no powers"));
}

TEST_CASE("a unit of another kind names the expected one")
{
    CHECK(error("2e4 N/m", Quantity::stiffness, revolute) ==
          "\"2e4 N/m\": \"N/m\" is not a unit of this quantity, expected N·m/rad");
    CHECK_THAT(error("5 mm", Quantity::velocity), Catch::EndsWith("expected m/s"));
    CHECK_THAT(error("5 N·m", Quantity::stiffness, revolute), Catch::EndsWith("expected N·m/rad"));
    CHECK_THAT(error("5 Hz", Quantity::angular_frequency), Catch::EndsWith("expected rad/s"));
    CHECK_THAT(error("5 deg", Quantity::position), Catch::EndsWith("expected m"));
    CHECK_THAT(error("5 m", Quantity::number), Catch::EndsWith("expected a number without unit"));
    CHECK_THAT(error("5 N/m·s", Quantity::effort_rate), Catch::EndsWith("expected N/s"));  // (N/m)·s
}

TEST_CASE("what is no number with a unit")
{
    CHECK_THAT(error("fast", Quantity::velocity), Catch::Contains("is not a number with a unit such as m/s"));
    CHECK_THAT(error("", Quantity::velocity), Catch::Contains("is not a number"));
    CHECK_THAT(error("nan m/s", Quantity::velocity), Catch::Contains("is not a number"));
    CHECK_THAT(error("inf m/s", Quantity::velocity), Catch::Contains("is not a number"));
    CHECK_THAT(error("1,5 m/s", Quantity::velocity), Catch::Contains("cannot read \",5 m/s\""));
    CHECK_THAT(error("2e4", Quantity::stiffness), Catch::Contains("without a unit"));
    CHECK_THAT(error("2 furlong", Quantity::position), Catch::Contains("unknown unit \"furlong\", expected m"));
    CHECK_THAT(error("2 m/", Quantity::velocity), Catch::Contains("ends too early"));
    CHECK_THAT(error("2 (m/s", Quantity::velocity), Catch::Contains("not closed"));
    CHECK_THAT(error("2 m/s)", Quantity::velocity), Catch::Contains("cannot read"));
    CHECK_THAT(error("2 m^9", Quantity::velocity), Catch::Contains("power"));
    CHECK_THAT(error("2 kmin", Quantity::time), Catch::Contains("unknown unit"));  // minutes take no prefix
    CHECK_THAT(error("1e999 m", Quantity::position), Catch::Contains("too large or too small"));
    CHECK_THAT(error("1e99999999999999 m", Quantity::position), Catch::Contains("too large or too small"));
    CHECK_THAT(error("1e308 km", Quantity::position), Catch::Contains("too large or too small"));
    CHECK_THAT(error("1 " + std::string(100, '('), Quantity::position), Catch::Contains("brackets"));
    CHECK_THAT(error("1 Gm·Gm^4·Gm^4·Gm^4", Quantity::position), Catch::Contains("too large"));
}

TEST_CASE("every printed unit reads back as itself")
{
    for (int q = 0; q <= static_cast<int>(Quantity::temperature); ++q)
        for (const Units units : {Units(), revolute}) {
            const auto quantity = static_cast<Quantity>(q);
            CHECK(read("7 " + std::string(unit_of(quantity, units)), quantity, units) == 7);
        }
}
