// What the comparison of both theories says of velocities and of gains that are enough for all of them.
#include "sweep/report/pages/comparison_section.h"
#include "sweep/report/figures/vmin_figure.h"

#include <catch2/catch.hpp>

using namespace stickslip;
using Catch::Matchers::Contains;

namespace {

/// Searched from 1 µm/s to 1 m/s, with V_min as stated at each of these velocity gains.
LinearDetails details_with(const std::vector<std::pair<double, double>>& least)
{
    LinearDetails details;
    details.velocity = 1e-3;
    details.study.velocities = {1e-6, 1};
    details.study.range_gain.emplace();
    for (const auto& [k_v, here] : least) details.least_velocities.push_back({k_v, {{1e3, 1e5}, {here, here}}, here});
    return details;
}

std::string enough(const LinearDetails& details)
{
    const auto section = comparison_section(Joint{}, details);
    for (const auto& row : section.tables.at(0).rows)
        if (row[0].starts_with("k_{v} for every velocity")) return row[2];
    return "no such row";
}

}  // namespace

TEST_CASE("V_min says of a gain without one that the highest velocity is unstable, not that none is stable", "[report]")
{
    // the joint may slide smoothly up to 1.22 mm/s, as the first screen says then
    const auto figure = vmin_figure(Joint{}, details_with({{10, missing}, {250, 1e-6}}));
    CHECK_THAT(figure.finding, Contains("sliding at the highest velocity searched is unstable with k_{v} = 10 N·s/m") &&
                                   Contains("all searched velocities are stable with k_{v} = 250 N·s/m"));
    for (const auto& text : {figure.finding, figure.caption}) {
        CHECK_THAT(text, !Contains("no velocity is stable"));
        CHECK_THAT(text, !Contains("stick-slip up to"));
    }
}

TEST_CASE("the table names a gain for every velocity that its figure shows", "[report]")
{
    CHECK(enough(details_with({{10, missing}, {250, 1e-6}, {500, 1e-6}})) == "k_{v} = 250 N·s/m is enough");
    CHECK(enough(details_with({{10, missing}, {20, 5e-3}})) == "not searched; not enough: 10 N·s/m, 20 N·s/m");
    CHECK(enough(details_with({})) == "–");
}
