#include "sweep/files/toml/asked_axes.h"
#include "sweep/files/text/bad_input.h"

#include <catch2/catch.hpp>

using namespace stickslip;

TEST_CASE("an axis about a number without decades says which range it could have", "[toml]")
{
    Asked asked;
    const auto refused = [&](double V0) -> std::string {
        asked.design.control.V0 = V0;
        try {
            axis_from(asked, "control.V0", "--along");
        } catch (const BadInput& bad) {
            return bad.what();
        }
        return "";
    };
    CHECK(
        refused(-0.02).ends_with("is -0.02 in the joint and no axis of the spec, so its range has to be given: --along "
                                 "control.V0=-2..-0.0002"));
    CHECK(refused(0).ends_with("--along control.V0=FROM..TO"));
    CHECK(refused(not_set).find("is not set in the joint") != std::string::npos);
    asked.design.control.V0 = -0.02;
    const auto axis = axis_from(asked, "control.V0=-2..-0.0002", "--along");
    CHECK(axis.values == std::vector<double>{-2, -0.0002});
}
