// Every joint that `new joint` offers is decided, whatever its model, law and motion.
#include <catch2/catch.hpp>

#include "analysis/friction/law.h"
#include "tests/program/run.h"

TEST_CASE("evaluate decides every joint that new joint writes", "[program][slow]")
{
    program::Folder folder;
    const std::string file = folder / "joint.toml";
    for (const std::string model : {"single-mass", "two-mass", "three-mass", "lever"})
        for (const std::string motion : {"prismatic", "revolute"})
            for (const auto& law : stickslip::laws()) {
                CAPTURE(model, motion, law.name);
                const auto written = program::stickslip("new joint --force --model " + model + " --motion " + motion +
                                                        " --law " + std::string(law.name) + " -o '" + file + "'");
                REQUIRE(written.exit_code == 0);
                const auto answer = program::stickslip("evaluate '" + file + "'");
                INFO(answer.output);
                CHECK(answer.exit_code == 0);
            }
}
