// A push against dry friction that follows the measured velocity, about steady sliding: linear theory, closed form and
// the simulated motion.
#include "tests/program/run.h"

#include <fmt/format.h>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <cmath>
#include <vector>

using Json = nlohmann::json;
using program::Folder;
using program::stickslip;

namespace {

/// The rate at which the swings of the simulated position grow: the slope of ln|x| over its extremes.
double simulated_growth(const Folder& folder, const std::string& file)
{
    const auto run =
        stickslip("simulate '" + file + "' --disturbance velocity --size 1e-6 --duration 0.8 --tolerance " +
                  "1e-10 -o '" + (folder / "out") + "'");
    INFO(run.output);
    REQUIRE(run.exit_code == 0);
    std::istringstream lines(program::read(folder / "out/trajectory.csv"));
    std::string line;
    std::getline(lines, line);
    std::vector<double> t, x, when, height;
    while (std::getline(lines, line)) {
        std::istringstream fields(line);
        std::string time, position;
        std::getline(fields, time, ','), std::getline(fields, position, ',');
        t.push_back(std::stod(time)), x.push_back(std::stod(position));
    }
    for (std::size_t i = 1; i + 1 < x.size(); ++i)
        if ((x[i] - x[i - 1]) * (x[i + 1] - x[i]) < 0) {
            // the top of the parabola through three rows
            const double a = t[i] - t[i - 1], b = t[i + 1] - t[i], l = (x[i] - x[i - 1]) / a, r = (x[i + 1] - x[i]) / b;
            const double bend = (r - l) / (a + b), slope = (l * b + r * a) / (a + b), step = -slope / (2 * bend);
            when.push_back(t[i] + step), height.push_back(std::abs(x[i] + 0.5 * slope * step));
        }
    REQUIRE(when.size() > 6);
    return std::log(height.back() / height[1]) / (when.back() - when[1]);
}

}  // namespace

TEST_CASE("a push by the velocity is part of the linear loop: growth as simulated", "[program][push][slow]")
{
    Folder folder;
    const double m = 2, viscous = 10, k_p = 2000, V0 = 0.02, push = 3, speed = 0.05;
    const double slope = push * (1 - std::pow(std::tanh(V0 / speed), 2)) / speed;  // 51.3 N·s/m
    const auto joint = [&](double k_v, const std::string& loop) {
        return folder.write(
            "joint.toml",
            fmt::format("[joint]\ninertia = {}\n[control]\nk_p = {}\nk_v = {}\nV0 = {}\n{}"
                        "feed_forward = {{ coulomb = {}, coulomb_speed = {}, coulomb_from = \"velocity\" }}\n"
                        "[friction]\nlaw = \"coulomb-viscous\"\ncoulomb = 4.0\nviscous = {}\n",
                        m, k_p, k_v, V0, loop, push, speed, viscous));
    };
    const auto evaluated = [&](const std::string& file) {
        const auto run = stickslip("evaluate '" + file + "' --json");
        INFO(run.output);
        REQUIRE(run.exit_code == 0);
        return Json::parse(run.output);
    };
    for (const double k_v : {30.0, 60.0}) {  // both sides of slope − viscous
        const auto file = joint(k_v, "");
        const auto json = evaluated(file);
        INFO("k_v " << k_v);
        const double rate = json["linear"]["state_variable"]["spectral_abscissa"].get<double>();
        CHECK(rate == Approx(-(k_v + viscous - slope) / (2 * m)).epsilon(1e-9));
        CHECK(rate == Approx(simulated_growth(folder, file)).epsilon(2e-3).margin(1e-3));
        CHECK(json["linear"]["velocity_only"]["k_v_min"].get<double>() == Approx(slope - viscous).epsilon(1e-6));
    }
    const std::string sampled =
        "period = 2e-3\ndelay = 1e-3\nvelocity_estimate = { form = \"backward-difference\", tau = 4e-3 }\n";
    for (const double k_v : {30.0, 90.0}) {
        const auto file = joint(k_v, sampled);
        const auto json = evaluated(file);
        INFO("sampled, k_v " << k_v);
        CHECK(json["linear"]["state_variable"]["spectral_abscissa"].get<double>() ==
              Approx(simulated_growth(folder, file)).epsilon(2e-2).margin(1e-2));
        for (const auto& term : json["loop"]["not_used"]) CHECK(term["key"] != "control.feed_forward.coulomb_from");
    }
}
