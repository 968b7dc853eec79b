// Parameters that the linear theory has no term for: nothing denies a boundary along them.
#include "sweep/study/idle_axes.h"
#include "analysis/simulation/set_point/set_point.h"
#include "sweep/files/text/bad_input.h"
#include "sweep/files/toml/requirements_file.h"
#include "sweep/report/pages/boundary_report.h"
#include "sweep/report/pages/margins_report.h"
#include "sweep/study/margins_answer.h"
#include "tests/analysis/boundary/axis.h"
#include "tests/analysis/simulation/joints.h"

#include <catch2/catch.hpp>

using namespace stickslip;

namespace {

bool has(const std::string& text, const char* part)
{
    return text.find(part) != std::string::npos;
}

bool alerts(const Report& report, const char* part)
{
    for (const auto& alert : report.alerts)
        if (has(alert.text, part)) return true;
    return false;
}

/// Of the boundary of hunting of a joint that hunts all along an axis.
BoundaryAnswer hunting_along(const Joint& joint, const Axis& axis)
{
    BoundaryAnswer answer;
    answer.design = joint;
    answer.set_point = set_point(joint);
    LocatedRay ray;
    ray.kind = BoundaryKind::hunting;
    ray.axis = axis;
    ray.axis.symbol = "x";
    ray.nodes = 40, ray.stable_share = 0;
    answer.rays.push_back(ray);
    if (auto idle = idle_at_rest(joint, axis)) answer.idle.push_back(*idle);
    return answer;
}

/// Of a design that slides, along an axis where all 200 scanned points do.
BoundaryAnswer along(const Joint& joint, const Axis& axis)
{
    BoundaryAnswer answer;
    answer.design = joint;
    answer.region = Region::stable;
    LocatedRay ray;
    ray.axis = axis;
    ray.axis.symbol = "x";
    ray.nodes = 200, ray.stable_share = 1;
    answer.rays.push_back(ray);
    answer.idle = idle_axes(joint, {axis});
    return answer;
}

}  // namespace

TEST_CASE("An axis is idle where no linear answer changes along it, and says why", "[idle]")
{
    Joint joint = example_joint(60e3, 10, 1e-3);
    const auto idle = idle_axes(joint, {axis("load.gravity_amplitude", 0.1, 1e4), axis("control.k_p", 1e4, 1e5),
                                        axis("load.constant", -1, 1, false), axis("load.cogging.amplitude", 1e-9, 1)});
    REQUIRE(idle.size() == 3);
    CHECK(idle[0].path == "load.gravity_amplitude");
    CHECK(idle[0].why == WhyNot::place);
    CHECK(idle[0].matters);
    // the theory has a constant load, which moves no root of this joint
    CHECK(idle[1].path == "load.constant");
    CHECK_FALSE(idle[1].why);
    CHECK_FALSE(idle[1].matters);
    CHECK(idle[2].why == WhyNot::place);
    // with a limit that gravity exceeds on a part of the axis, too: 60 N and 140 N of 200 N
    joint.control.effort_limit = 200;
    CHECK(idle_axes(joint, {axis("load.gravity_amplitude", 0.1, 1e4)}).size() == 1);
    CHECK(idle_axes(joint, {axis("load.gravity_amplitude", 1e3, 1e4)}).empty());
}

TEST_CASE("A page about an axis without a term denies no boundary and is not green where it matters", "[idle][report]")
{
    const Joint joint = example_joint(60e3, 10, 1e-3);
    const auto page = boundary_report(along(joint, axis("load.gravity_amplitude", 0.1, 1e4)));
    CHECK(page.tone == Headline::Tone::warning);
    CHECK(has(page.verdict, "the linear theory has no term for load.gravity_amplitude"));
    CHECK_FALSE(has(page.verdict, "stable throughout"));
    CHECK(alerts(page, "load.gravity_amplitude"));
    // 20 N/m beside 60 kN/m
    const auto weak = boundary_report(along(joint, axis("load.gravity_amplitude", 0.1, 20)));
    CHECK(weak.tone == Headline::Tone::good);
    CHECK(has(weak.verdict, "the linear theory has no term for load.gravity_amplitude"));
    const auto known = boundary_report(along(joint, axis("control.k_p", 6e4, 1e5)));
    CHECK(known.tone == Headline::Tone::good);
    CHECK(has(known.verdict, "stable throughout"));
}

TEST_CASE("Nothing is said of an uncertainty that the theory does not know", "[idle][margins]")
{
    Joint joint = example_joint(60e3, 10, 1e-3);
    joint.load.gravity_amplitude = 20;
    auto answer = margins_of(joint);
    const auto ask = [&](const std::vector<std::string>& uncertain) {
        answer.uncertainty = uncertainty_from(joint, uncertain);
        answer.idle = idle_coordinates(joint, answer.uncertainty);
        answer.worst = worst_case(joint, answer.uncertainty, Curve::Kind::state_variable);
    };
    ask({"load.gravity_amplitude=90%"});
    CHECK(answer.only_idle());
    CHECK_FALSE(has(margins_text(answer), "stays stable"));
    CHECK(has(margins_text(answer), "Nothing is said of"));
    CHECK(margins_report(answer).tone == Headline::Tone::warning);
    ask({"load.gravity_amplitude=90%", "friction.L=1%"});
    CHECK_FALSE(answer.only_idle());
    CHECK(has(margins_text(answer), "stays stable"));
    CHECK(has(margins_text(answer), "no term for load.gravity_amplitude"));
    CHECK_THROWS_AS(uncertainty_from(joint, {"friction.L=1%", "friction.L=2%"}), BadInput);
}

TEST_CASE("An uncertainty with joints that have no verdict is no clean yes", "[margins]")
{
    // 60 N of friction and up to 38 N of gravity under a limit of 90 N
    Joint joint = example_joint(60e3, 10, 1e-3);
    joint.load.gravity_amplitude = 20;
    joint.control.effort_limit = 90;
    auto answer = margins_of(joint);
    REQUIRE(answer.nearest.decided);
    answer.uncertainty = uncertainty_from(joint, {"load.gravity_amplitude=90%", "friction.L=1%"});
    answer.worst = worst_case(joint, answer.uncertainty, Curve::Kind::state_variable);
    CHECK(answer.worst->undecided > 0);
    CHECK(has(margins_text(answer), "had no verdict"));
    CHECK(margins_report(answer).tone == Headline::Tone::warning);
}

TEST_CASE("along what no answer at a set point depends on nothing denies a boundary of hunting", "[idle]")
{
    Joint joint;
    joint.mechanism.inertia = 1;
    auto& c = joint.control;
    c.V0 = 0, c.k_p = 100, c.k_v = 20, c.k_i = 100;
    joint.friction.law = KineticStatic{1, 1.5};
    const auto noise = hunting_along(joint, axis("sensor.position_noise", 1e-9, 1e-6));
    REQUIRE(noise.idle.size() == 1);
    CHECK(noise.idle[0].at_rest);
    CHECK(noise.idle[0].matters);
    const auto said = boundary_report(noise).verdict;
    CHECK(has(said, "No hunting boundary can lie along x"));
    CHECK(has(said, "no answer at a set point has a place for sensor.position_noise"));
    CHECK(has(said, "simulate it"));
    // effort noise is that of a record
    CHECK(has(boundary_report(hunting_along(joint, axis("sensor.effort_noise", 1e-3, 1))).verdict,
              "no answer of this joint at a set point depends on sensor.effort_noise"));
    // the dead time moves the cycle, and ends it
    CHECK_FALSE(idle_at_rest(joint, axis("control.delay", 1e-3, 1e-2)));
    CHECK_FALSE(idle_at_rest(joint, axis("load.gravity_amplitude", 1, 100)));
}
