// Lanes of two masses against CVODE at rtol 1e-11, which follows the joint in its own units by ChainFlow.
#include <catch2/catch.hpp>

#include "tests/analysis/simulation/lanes/lanes_comparison.h"
#include "tests/analysis/simulation/lanes/two_mass_joints.h"
#include "tests/analysis/simulation/lanes/watched_answers.h"

using namespace stickslip;

namespace {

constexpr Remembers every_place[] = {Remembers::on_link, Remembers::on_motor, Remembers::on_both};
constexpr double patient = 10;  ///< some of these motions come back after ten turns and more

/// Every row as CVODE has it; how many of them lanes decided.
int same_as_cvode(const std::vector<Joint>& joints)
{
    int by_lanes = 0;
    for (const auto& c : compare_with_cvode(joints, true, {}, patient)) {
        CAPTURE(c.row.period, c.truth.period, c.truth.repeats);
        CHECK(c.same_outcome());
        CHECK(c.row.reason == c.truth.reason);
        CHECK(c.row_spectrum < 1e-7);
        // where the speed hardly rises above a hundredth of V_0, a share depends on the root of what it is off by
        CHECK(c.rest < (c.row.outcome == Outcome::period_n ? 1e-3 : 1e-5));
        CHECK(c.period < 1e-5);
        CHECK(c.amplitude < 1e-4);
        by_lanes += c.row.path == DecisionPath::lanes;
    }
    return by_lanes;
}

/// Of all places and both laws; every one of them leaves different unknowns to the kernel.
std::vector<lanes::WatchedJob> every_kind(std::size_t count, unsigned seed)
{
    std::vector<Joint> joints;
    for (const auto place : every_place)
        for (const auto& joint : random_two_mass_joints(count, seed, place)) {
            joints.push_back(joint);
            joints.push_back(with_ageing_masses(joint));
        }
    return jobs_of(joints);
}

}  // namespace

TEST_CASE("two masses in lanes: every row as CVODE has it", "[lanes][slow]")
{
    for (const auto place : every_place) {
        CAPTURE(static_cast<int>(place));
        auto joints = random_two_mass_joints(16, 28, place);
        for (const auto& joint : random_two_mass_joints(12, 29, place)) joints.push_back(with_ageing_masses(joint));
        CHECK(same_as_cvode(joints) > 25);
    }
}

TEST_CASE("lanes take no two masses but two smooth contacts and a spring", "[lanes]")
{
    const Joint joint = random_two_mass_joints(1, 28, Remembers::on_link)[0];
    REQUIRE(lanes::watched_scaled(joint));
    const auto refused = [&](const auto& change) {
        Joint changed = joint;
        change(changed);
        return !lanes::watched_scaled(changed);
    };
    CHECK(refused([](Joint& j) { j.mechanism.transmission.backlash = 1e-4; }));
    CHECK(refused([](Joint& j) { j.mechanism.transmission.cubic_stiffness = 1; }));
    CHECK(refused([](Joint& j) { j.frictions.motor.law = CoulombViscous{1, 0}; }));
    CHECK(refused([](Joint& j) { j.frictions.motor.load_coefficient = 0.1; }));
    CHECK(refused([](Joint& j) { j.control.contact_stiffness = 1; }));
    CHECK(refused([](Joint& j) { j.control.kind = ControlKind::force; }));
    CHECK(refused([](Joint& j) { j.control.V0 *= -1; }));
    CHECK(refused([](Joint& j) { j.normal.displacement = 1; }));
    CHECK(refused([](Joint& j) { j.frictions.motor.law = with_ageing_masses(j).frictions.link.law; }));
    CHECK_FALSE(refused([](Joint& j) { j.frictions.motor.law = j.frictions.link.law; }));
}

TEST_CASE("an answer of two masses depends on its job alone", "[lanes]")
{
    const auto jobs = every_kind(8, 30);
    check_that_jobs_are_alone(jobs);
}

TEST_CASE("every instruction set gives the same outcomes of two masses", "[lanes]")
{
    const auto jobs = every_kind(8, 31);
    const auto baseline = answers_of(jobs, lanes::Instructions::baseline);
    for (const auto set : {lanes::Instructions::avx2, lanes::Instructions::avx512}) {
        if (set > lanes::best_instructions()) continue;
        const auto wide = answers_of(jobs, set);
        for (std::size_t i = 0; i < jobs.size(); ++i) {
            CHECK(wide[i].ending == baseline[i].ending);
            CHECK(wide[i].cycle == baseline[i].cycle);
            CHECK(wide[i].period == Approx(baseline[i].period).epsilon(1e-5));
        }
    }
}

TEST_CASE("disturbances of stated size of two masses end in lanes as CVODE has it", "[lanes][slow]")
{
    StatedComparison compare{patient};
    for (const auto place : every_place)
        for (const auto& joint : random_two_mass_joints(4, 32, place)) {
            const double V0 = joint.control.V0, m = joint.mechanism.link_inertia,
                         time = std::sqrt(m / joint.control.k_p);
            compare(joint, {DisturbanceKind::position, 0.3 * V0 * time});
            compare(joint, {DisturbanceKind::velocity, 0.5 * V0});
            compare(joint, {DisturbanceKind::impulse, -0.4 * m * V0});
            compare(joint, {DisturbanceKind::offset, 2 * V0 * time});
            if (place != Remembers::on_motor)  // there are states to change on the link alone
                compare(joint, {DisturbanceKind::state, 0.2 * joint.control.k_p * V0 * time});
            compare(joint, {DisturbanceKind::start, 0.02});
        }
    CHECK(compare.by_lanes > 0.9 * compare.asked);
}
