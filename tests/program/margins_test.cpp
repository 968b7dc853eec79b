// stickslip margins as a user runs it.
#include "tests/program/run.h"

#include <catch2/catch.hpp>
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
