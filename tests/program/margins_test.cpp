// stickslip margins as a user runs it.
#include "tests/program/run.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

using Catch::Matchers::Contains;
using Json = nlohmann::json;
using program::stickslip;

TEST_CASE("margins say which parameters lead to stick-slip, and how far", "[program][margins]")
{
    const std::string call = "margins examples/01-reference-joint/spec.toml --set control.k_v=0 ";
    const auto run = stickslip(call + "--uncertain friction.L=20% --json");
    INFO(run.output);
    REQUIRE(run.exit_code == 0);
    const auto json = Json::parse(run.output);
    CHECK(json["nearest"]["found"] == true);
    // k_cr = 55 kN/m in closed form; k_p = 60 kN/m
    double k_p = 0;
    for (const auto& row : json["alone"])
        if (row["path"] == "control.k_p") k_p = row["boundary"].get<double>();
    CHECK(k_p == Approx(55000).epsilon(1e-9));
    // 5e4·1.1/0.8 > 6e4: unstable at worst
    CHECK(json["worst_case"]["stable"] == false);
    CHECK(json["worst_case"]["deviations"][0].get<double>() == Approx(-0.2));
    CHECK_THAT(json["answer"].get<std::string>(), Contains("Stick-slip appears if "));
    CHECK(stickslip(call + "--uncertain friction.L=200%").exit_code == 2);
    CHECK(stickslip(call + "--uncertain friction.K=20%").exit_code == 2);
    CHECK(stickslip(call + "--over control.k_p control.k_v").exit_code == 2);
}

TEST_CASE("a velocity backwards is a parameter as one forwards is", "[program][margins]")
{
    program::Folder folder;
    const auto joint =
        folder.write("joint.toml",
                     "[joint]\ninertia = 1.0\n[control]\nk_p = 1e4\nk_v = 20.0\nV0 = -4e-3\n"
                     "[friction]\nlaw = \"stribeck\"\nc0 = 10.0\nc1 = 5.0\nc2 = 0.5\nc3 = 2e-3\nc4 = 2.0\n");
    const auto row = [](const Json& json, const std::string& path) {
        for (const auto& alone : json["alone"])
            if (alone["path"] == path) return alone;
        return Json();
    };
    const std::string call = "margins '" + joint + "' --uncertain control.V0=10% --json ";
    const auto back = stickslip(call);
    INFO(back.output);
    REQUIRE(back.exit_code == 0);
    const auto backwards = Json::parse(back.output);
    const auto forwards = Json::parse(stickslip(call + "--set control.V0=4e-3").output);
    // Dupont (23): c1 − (2 c2 V/c3²) e^{−(V/c3)²} = −k_v at the boundary
    const double V = row(backwards, "control.V0")["boundary"].get<double>();
    CHECK(V < 0);
    CHECK(2 * 0.5 * -V / 4e-6 * std::exp(-V * V / 4e-6) == Approx(25).epsilon(1e-7));
    CHECK(row(backwards, "control.V0")["value"].get<double>() == -4e-3);
    // this friction knows no direction
    CHECK(row(forwards, "control.V0")["boundary"].get<double>() == Approx(-V).epsilon(1e-9));
    CHECK(backwards["nearest"]["distance"].get<double>() ==
          Approx(forwards["nearest"]["distance"].get<double>()).epsilon(1e-6));
    CHECK(backwards["worst_case"]["spectral_abscissa"].get<double>() ==
          Approx(forwards["worst_case"]["spectral_abscissa"].get<double>()).epsilon(1e-9));
}

TEST_CASE("the nearest boundary of several bodies is found between the axes", "[program][margins][slow]")
{
    // three masses, each with a Stribeck peak: level and peak of the motor's friction act together with V_0. A search
    // of its own, from many starts, came to 0.343; the nearest axis lies at 0.58
    const auto run = stickslip("margins tests/sweep/found/nearest_of_many.toml --json");
    INFO(run.output);
    REQUIRE(run.exit_code == 0);
    const auto nearest = Json::parse(run.output)["nearest"];
    CHECK(nearest["found"] == true);
    CHECK(nearest["distance"].get<double>() < 0.345);
}
