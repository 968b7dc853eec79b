// How far a joint is behind its reference in steady sliding, against simulated motions along a ramp from rest.
#include "tests/program/run.h"

#include <fmt/format.h>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using Json = nlohmann::json;
using program::Folder;
using program::stickslip;

namespace {

constexpr double mass = 2, coulomb = 4, viscous = 10;

std::string joint(double V0, const std::string& control, const std::string& tables)
{
    return fmt::format(
        "[joint]\nmotion = \"prismatic\"\nmodel = \"single-mass\"\ninertia = {}\n"
        "[control]\nV0 = {}\n{}\n"
        "[friction]\nlaw = \"coulomb-viscous\"\ncoulomb = {}\nviscous = {}\n{}\n",
        mass, V0, control, coulomb, viscous, tables);
}

/// Reference less position at the end of a ramp that is long beside every time constant of the loop.
double simulated_error(const Folder& folder, const std::string& file, double V0)
{
    constexpr double step = 1e-3, duration = 6;
    std::string ramp = "time,reference_position,reference_velocity\n";
    for (int i = 0; i * step <= duration; ++i) ramp += fmt::format("{},{},{}\n", i * step, V0 * i * step, V0);
    const auto reference = folder.write("ramp.csv", ramp);
    const auto run = stickslip("simulate '" + file + "' --reference '" + reference + "' -o '" + (folder / "out") + "'");
    INFO(run.output);
    REQUIRE(run.exit_code == 0);
    const auto record = program::read(folder / "out/record.csv");
    std::istringstream lines(record);
    std::string header, line, last;
    std::getline(lines, header);
    while (std::getline(lines, line))
        if (!line.empty()) last = line;
    std::istringstream names(header), values(last);
    double reference_position = 0, position = 0;
    for (std::string name, value; std::getline(names, name, ',') && std::getline(values, value, ',');) {
        if (name.starts_with("reference_position")) reference_position = std::stod(value);
        if (name == "position" || name.starts_with("position ")) position = std::stod(value);
    }
    return reference_position - position;
}

}  // namespace

TEST_CASE("the steady deflection is what a motion along a ramp ends with", "[program][steady][slow]")
{
    const double V = 0.02, f = coulomb + viscous * V;
    const std::string pd = "k_p = 2000.0\nk_v = 150.0\n", pid = pd + "k_i = 8000.0\n",
                      silent = "reference_velocity = false\n",
                      cascade = "structure = \"cascade\"\nposition_gain = 10.0\nvelocity_gain = 150.0\n",
                      integrating = cascade + "velocity_integral_gain = 600.0\n",
                      sampled = "period = 1e-3\nvelocity_estimate = { form = \"backward-difference\" }\n";
    struct Case {
        std::string what, control, tables;
        double error;  ///< of the reference that moves forwards
    };
    const std::vector<Case> cases = {
        {"a spring carries the friction", pd, "", f / 2000},
        {"k_v brakes where nothing takes the reference's velocity into account", pd + silent, "", (f + 150 * V) / 2000},
        {"a share of the reference's velocity", pd + "feed_forward = { velocity = 0.3 }\n", "",
         (f + 150 * 0.7 * V) / 2000},
        {"an integral takes it all", pid, "", 0},
        {"an integral takes the share of k_v, too", pid + silent, "", 0},
        {"an integral at its limit", pid + "integral_limit = 3.0\n", "", (f - 3) / 2000},
        {"an integral at its limit beside k_v", pid + silent + "integral_limit = 3.0\n", "", (f + 150 * V - 3) / 2000},
        {"a cascade without an integral", cascade + silent, "", (f + 150 * V) / 1500},
        {"a cascade whose integral takes the velocity error", integrating, "", 0},
        {"a cascade that knows no reference velocity lags by V/K_pos", integrating + silent, "", V / 10},
        {"a cascade with its integral at its limit", integrating + silent + "integral_limit = 3.0\n", "",
         ((f - 3) / 150 + V) / 10},
        {"a dead zone", pd + "dead_zone = 1e-4\n", "", f / 2000 + 1e-4},
        {"a push by the reference", pd + "feed_forward = { coulomb = 3.0 }\n", "", (f - 3) / 2000},
        {"a push by the velocity", pd + "feed_forward = { coulomb = 3.0, coulomb_from = \"velocity\" }\n", "",
         (f - 3) / 2000},
        {"a weak drive", pd + silent, "[actuator]\neffort_gain = 0.5\n", (2 * f + 150 * V) / 2000},
        {"a weak drive with its integral at its limit", pid + "integral_limit = 3.0\n",
         "[actuator]\neffort_gain = 0.5\n", (2 * f - 3) / 2000},
    };
    Folder folder;
    for (const auto& c : cases)
        for (const bool ticks : {false, true})
            for (const double direction : {1.0, -1.0}) {
                const double V0 = direction * V;
                const auto file = folder.write("joint.toml", joint(V0, c.control + (ticks ? sampled : ""), c.tables));
                const auto run = stickslip("evaluate '" + file + "' --json");
                INFO(c.what << (ticks ? ", sampled " : ", continuous ") << V0 << "\n" << run.output.substr(0, 400));
                REQUIRE(run.exit_code == 0);
                const auto told = Json::parse(run.output)["steady"]["deflection"].get<double>();
                CHECK(told == Approx(direction * c.error).epsilon(1e-9).margin(1e-12));
                CHECK(told == Approx(simulated_error(folder, file, V0)).epsilon(1e-4).margin(1e-7));
            }
}
