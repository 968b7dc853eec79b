// Charts of hunting: their regions and the amplitude, against the closed form of dry friction.
#include <catch2/catch.hpp>
#include <cmath>

#include "analysis/boundary/kinds/boundary.h"
#include "analysis/joint/parameters.h"
#include "analysis/simulation/set_point/set_point.h"
#include "sweep/report/figures/hunting_map.h"
#include "sweep/report/figures/meeting_headlines.h"
#include "sweep/report/pages/boundary_report.h"
#include "sweep/study/boundary_charts.h"
#include "sweep/study/maps.h"

using namespace stickslip;

namespace {

void one_by_one(std::size_t n, const std::function<void(std::size_t)>& task)
{
    for (std::size_t i = 0; i < n; ++i) task(i);
}

BoundaryAnswer hunting_answer()
{
    BoundaryAnswer answer;
    auto& joint = answer.design;
    joint.mechanism.inertia = 1;
    joint.control.V0 = 0;
    joint.control.k_p = 100, joint.control.k_v = 20, joint.control.k_i = 100;
    joint.friction.law = KineticStatic{1, 1.5};
    const auto axis = [&](const char* path, double low, double high) {
        return Axis{path, path, path, Quantity::stiffness, true, {low, high}};
    };
    BoundaryRequest request;
    request.kind = BoundaryKind::hunting;
    answer.curves.push_back(
        follow_boundaries(joint, axis("control.k_p", 10, 1e4), axis("control.k_i", 10, 1e5), request));
    answer.set_point = set_point(joint);
    answer.meetings = meetings_of(joint, {}, answer.curves);
    answer.charts = boundary_charts(joint, answer.curves, one_by_one);
    return answer;
}

}  // namespace

TEST_CASE("a chart of hunting shows where the joint hunts and where the loop diverges", "[report][set-point][slow]")
{
    const auto answer = hunting_answer();
    const auto report = boundary_report(answer);
    CHECK(report.verdict.find("Hunts at a set point") == 0);
    CHECK(report.tone == Headline::Tone::bad);
    REQUIRE(report.sections.front().figures.size() >= 2);
    const auto& map = std::get<FieldMap>(report.sections.front().figures[0].picture);
    const auto& far = std::get<FieldMap>(report.sections.front().figures[1].picture);
    REQUIRE(map.values.size() == map.x.values.size() * map.y.values.size());
    int wrong = 0;
    for (std::size_t j = 0; j < map.y.values.size(); ++j)
        for (std::size_t i = 0; i < map.x.values.size(); ++i) {
            const std::size_t at = j * map.x.values.size() + i;
            const double k_p = map.x.values[i], k_i = map.y.values[j];
            const bool stable = k_i < 20 * k_p;  // Routh: k_v k_p = m k_i
            if (std::abs(std::log(k_i / (20 * k_p))) < 1e-6) continue;
            const auto& says = map.classes[static_cast<std::size_t>(map.values[at])];
            wrong += says != (stable ? "hunts" : "diverges: the loop itself is unstable");
            wrong += std::isfinite(far.values[at]) != stable;
        }
    CHECK(wrong == 0);
    CHECK(map.lines.size() == 1);
}

TEST_CASE("a boundary behind which the loop diverges is not shown as the end of hunting", "[report][set-point][slow]")
{
    const auto answer = hunting_answer();
    // Routh: k_v k_p = m k_i, from the design of k_p = 100 and k_i = 100 down to 5 and up to 2000
    REQUIRE(answer.meetings.size() == 1);  // 5 lies below the chart
    const auto& met = answer.meetings.front();
    CHECK(met.axis.path == "control.k_i");
    CHECK(std::abs(met.at / 2000 - 1) < 1e-3);
    REQUIRE(met.beyond);
    CHECK(met.beyond->diverges());
    const auto report = boundary_report(answer);
    REQUIRE(report.headlines.size() == 1);
    CHECK(report.headlines[0].tone == Headline::Tone::bad);
    CHECK(report.headlines[0].meaning.find("divergence") != std::string::npos);
    CHECK(report.verdict.find("The joint comes to rest nowhere on this chart") != std::string::npos);
}

TEST_CASE("where a dead zone ends hunting, the card says that it ends there", "[report][set-point][slow]")
{
    Joint joint = hunting_answer().design;
    number_at(joint, "control.dead_zone") = 1;
    BoundaryRequest request;
    request.kind = BoundaryKind::hunting;
    const Axis axis{"control.dead_zone", "e_{d}", "dead zone", Quantity::position, true, {0.5, 10}};
    const auto ray = locate_boundaries(joint, axis, request);
    const auto met = meetings_of(joint, {ray}, {});
    REQUIRE(met.size() == 1);
    REQUIRE(met[0].beyond);
    CHECK(met[0].beyond->hunting == Hunting::no);
    const auto cards = meeting_headlines(met, Units(Motion::prismatic));
    REQUIRE(cards.size() == 1);
    CHECK(cards[0].tone == Headline::Tone::neutral);
    CHECK(cards[0].meaning.find("where hunting ends") != std::string::npos);
}
