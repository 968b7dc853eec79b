// One motion as a user asks for it: its numbers and its page.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <sstream>
#include <vector>

#include "tests/example_joint.h"
#include "tests/program/run.h"

using namespace program;

namespace {

/// β = 1.5, M = 1 at 0.9 k_cr: a continuation program gives its cycle the period 9.54321087 L/V_0 and ln(V/V_0) within
/// [−0.473805, 0.371977].
const std::string known_cycle = example_joint_text(10, 9e4, 0, 1e-3);

/// The column with this number of a table whose first line is a header.
std::vector<double> column(const std::string& csv, int number)
{
    std::vector<double> values;
    std::istringstream lines(csv);
    std::string line, field;
    std::getline(lines, line);
    while (std::getline(lines, line)) {
        std::istringstream fields(line);
        for (int i = 0; i <= number; ++i) std::getline(fields, field, ',');
        values.push_back(std::stod(field));
    }
    return values;
}

}  // namespace

TEST_CASE("a motion settles on the cycle that is known, and its page says so", "[slow]")
{
    const Folder folder;
    const auto joint = folder.write("joint.toml", known_cycle);
    const auto run = stickslip("simulate " + joint + " -o " + (folder / "out"));
    INFO(run.output);
    REQUIRE(run.exit_code == 0);
    const auto velocity = column(read(folder / "out/trajectory.csv"), 2);
    const auto settled = velocity.begin() + static_cast<std::ptrdiff_t>(3 * velocity.size() / 4);
    CHECK(std::log(*std::max_element(settled, velocity.end()) / 1e-3) == Approx(0.371977).epsilon(1e-3));
    CHECK(std::log(*std::min_element(settled, velocity.end()) / 1e-3) == Approx(-0.473805).epsilon(1e-3));
    const auto page = read(folder / "out/report.html");
    for (const char* words :
         {"Phase portrait", "Friction over velocity", "steady sliding f", "limit-cycle", "95.4321 ms"})
        CHECK_THAT(page, Catch::Contains(words));
}
