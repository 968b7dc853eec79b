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
         {"Phase portrait", "Friction over velocity", "steady sliding f", "limit-cycle", "95.43 ms"})
        CHECK_THAT(page, Catch::Contains(words));
}

TEST_CASE("the force of the loop is a column of motions backwards, too", "[slow]")
{
    const Folder folder;
    for (const double V0 : {-4e-3, 4e-3})
        for (const double load : {0.0, 3.0}) {  // which pulls along in one direction, and is held back in the other
            const auto joint = folder.write(
                "joint.toml",
                "[joint]\ninertia = 2.0\n[control]\nk_p = 1e4\nk_v = 20.0\nV0 = " + std::to_string(V0) +
                    "\n[friction]\nlaw = \"stribeck\"\nc0 = 10.0\nc1 = 5.0\nc2 = 0.5\nc3 = 2e-3\nc4 = 2.0\n" +
                    "[load]\nconstant = " + std::to_string(load) + "\n");
            const auto run = stickslip("simulate " + joint + " --disturbance velocity --size 1e-3 --duration 0.2 -o " +
                                       (folder / "out"));
            INFO(V0 << " m/s, " << load << " N\n" << run.output);
            REQUIRE(run.exit_code == 0);
            const auto csv = read(folder / "out/trajectory.csv");
            const auto header = csv.substr(0, csv.find('\n'));
            INFO(header);
            REQUIRE(header.ends_with(",control_force [N]"));
            const auto t = column(csv, 0), x = column(csv, 1), V = column(csv, 2), f = column(csv, 3),
                       u = column(csv, 5);
            CHECK(V[0] == Approx(V0 + 1e-3));
            // ẋ = V − V_0 and m V̇ = u − f + load, integrated over the motion
            double impulse = 0, moved = 0, way = 0, distance = 0;
            for (std::size_t i = 1; i < t.size(); ++i) {
                const double now = u[i] - f[i] + load, before = u[i - 1] - f[i - 1] + load, step = t[i] - t[i - 1];
                impulse += 0.5 * (now + before) * step;
                moved += 0.5 * (std::abs(now) + std::abs(before)) * step;
                way += (0.5 * (V[i] + V[i - 1]) - V0) * step;
                distance += std::abs(0.5 * (V[i] + V[i - 1]) - V0) * step;
                CHECK(2 * (V[i] - V[0]) == Approx(impulse).margin(1e-3 * moved + 1e-7));
                CHECK(x[i] - x[0] == Approx(way).margin(1e-3 * distance + 1e-10));
            }
        }
}
