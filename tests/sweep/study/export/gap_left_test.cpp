// What is left of the gap by what a text holds, against a closed form, and what each simulator can say of each effect.
#include <catch2/catch.hpp>

#include "analysis/diagnosis/audit/prepare.h"
#include "analysis/diagnosis/heldout/ensemble.h"
#include "analysis/diagnosis/plant/simulator.h"
#include "sweep/files/simulators/simulator_text.h"
#include "sweep/study/export/effect_targets.h"
#include "sweep/study/export/gap_left.h"
#include "sweep/study/export/simulator_run.h"
#include "sweep/study/start/starting_joint.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <regex>

using namespace stickslip;

namespace {

const ParallelFor in_order = [](std::size_t n, const std::function<void(std::size_t)>& task) {
    for (std::size_t i = 0; i < n; ++i) task(i);
};

Joint damped()
{
    Joint joint = starting_joint(Model::single_mass, "coulomb-viscous", Motion::revolute);
    joint.mechanism.inertia = 0.2;
    joint.friction.law = CoulombViscous{.coulomb = 0, .viscous = 1};
    joint.control.k_p = 200, joint.control.k_v = 12;
    joint.control.period = 1e-3;
    joint.control.velocity_estimate.form = EstimateForm::backward_difference;
    joint.sensor.position_noise = 1e-5;
    return joint;
}

/// What the joint would log over a slow sine.
Record record_of(const Joint& joint)
{
    Record r;
    r.name = "held-out.csv";
    for (int k = 0; k < 8000; ++k) {
        r.time.push_back(1e-3 * k);
        r.reference_position.push_back(0.2 * (1 - std::cos(r.time.back())));
    }
    r.position.assign(r.time.size(), 0);
    const auto trace = gap::simulate_closed_loop(gap::flatten(joint), gap::on_clock(r, joint), 3);
    r.position = trace.position, r.effort_command = trace.command;
    return r;
}

GapLeft left_of(const Joint& joint, Simulator to)
{
    return gap_left(joint, to, {}, {record_of(joint)}, in_order);
}

/// XML's and Python's or YAML's.
std::string without_comments(const std::string& text)
{
    return std::regex_replace(std::regex_replace(text, std::regex("<!--[^]*?-->"), ""), std::regex("#[^\n]*"), "");
}

}  // namespace

TEST_CASE("export: a load that a simulator lacks leaves its share over the position gain")
{
    Joint joint = damped();
    const double without = left_of(joint, Simulator::mjcf).text;
    CHECK(without < 2);
    joint.load.constant = 3;
    for (const auto to : {Simulator::mjcf, Simulator::isaaclab, Simulator::sdf}) {
        const GapLeft left = left_of(joint, to);
        REQUIRE(left.signals.size() == 2);  // effort_command, position
        // the loop holds it by F/k_p of error; that takes 2ζ/ω = 65 ms to begin
        CHECK(left.signals[1].text == Approx(3 / 200.).epsilon(0.02));
        CHECK(left.signals[0].text == Approx(3).epsilon(0.02));
        CHECK(left.signals[1].joint < 2 * left.signals[1].floor);
        CHECK(left.joint < 2);
        CHECK(left.text > 100);
    }
}

TEST_CASE("export: what is left is counted in the diagnosis' multiples of the noise floor")
{
    Joint true_joint = damped(), joint = damped();
    true_joint.load.constant = 4e-3;  // 2e-5 rad of error, twice the noise
    const Record record = record_of(true_joint);
    std::vector<Note> notes;
    const gap::Case c = gap::prepare(record, joint, notes);
    const double everywhere = std::numeric_limits<double>::infinity();
    double squares = 0;
    for (const auto& s : gap::compare(c, joint, 40, -everywhere, everywhere)) squares += s.difference / s.floor / 2;
    const GapLeft left = gap_left(joint, Simulator::mjcf, {}, {record}, in_order);
    CHECK(left.joint == Approx(std::sqrt(squares)).epsilon(0.05));
    CHECK(left.joint > 1.1);
}

TEST_CASE("export: behind a gear, what is left stands in the units of the record")
{
    Joint joint = starting_joint(Model::two_mass, "coulomb-viscous", Motion::revolute);
    joint.mechanism.motor_inertia = 2e-5, joint.mechanism.link_inertia = 0.05;
    joint.mechanism.transmission.ratio = 50, joint.mechanism.transmission.stiffness = 4000;
    joint.mechanism.transmission.damping = 3;
    joint.frictions.motor.law = CoulombViscous{.coulomb = 0, .viscous = 2e-3};
    joint.frictions.link.law = CoulombViscous{.coulomb = 0, .viscous = 0.1};
    joint.control.k_p = 0.4, joint.control.k_v = 0.02, joint.control.period = 1e-3;
    joint.control.velocity_estimate.form = EstimateForm::backward_difference;
    joint.sensor.position_noise = 1e-4;  // small against what is lost, in the command, too
    joint.load.constant = 5;             // 0.1 N·m at the motor's shaft, which the loop holds by 0.25 rad
    const GapLeft left = left_of(joint, Simulator::mjcf);
    REQUIRE(left.signals.size() == 2);
    CHECK(left.signals[0].text == Approx(0.1).epsilon(0.03));
    CHECK(left.signals[1].text == Approx(0.25).epsilon(0.03));
    CHECK(left.joint < 2);
}

TEST_CASE("export: a joint without a record simulation and a record without a reference are refused")
{
    const Joint joint = damped();
    Record r = record_of(joint);
    CHECK_THROWS_AS(
        gap_left(starting_joint(Model::lever, "coulomb-viscous", Motion::revolute), Simulator::mjcf, {}, {r}, in_order),
        std::invalid_argument);
    r.reference_position.clear();
    CHECK_THROWS_WITH(gap_left(joint, Simulator::mjcf, {}, {r}, in_order), Catch::Contains("reference_position"));
}

TEST_CASE("export: every effect is held by each simulator wholly, partly or not at all")
{
    using Says = EffectTarget::Says;
    const auto says = [](const char* effect, Simulator to) {
        return targets_of(*gap::effect_named(effect))[static_cast<std::size_t>(to)].says;
    };
    for (const auto& effect : gap::effects()) {
        const auto targets = targets_of(effect);
        for (const auto& target : targets) CHECK((target.says == Says::all) == target.lost.empty());
    }
    // by hand, from the formats' own documentation
    for (const char* effect : {"coulomb-level", "viscous", "inertia", "gravity"}) {
        INFO(effect);
        for (const auto to : {Simulator::mjcf, Simulator::urdf, Simulator::sdf}) CHECK(says(effect, to) == Says::all);
        CHECK(says(effect, Simulator::ros2_control) == Says::nothing);
    }
    for (const char* effect : {"gain-k_p", "gain-k_v"}) {
        INFO(effect);
        CHECK(says(effect, Simulator::urdf) == Says::nothing);
        for (const auto to : {Simulator::mjcf, Simulator::sdf, Simulator::isaaclab, Simulator::ros2_control})
            CHECK(says(effect, to) == Says::all);
    }
    CHECK(says("backlash", Simulator::mjcf) == Says::part);  // a tendon's damping acts within its dead band, too
    CHECK(says("compliance", Simulator::mjcf) == Says::all);
    for (const auto to : {Simulator::isaaclab, Simulator::ros2_control}) CHECK(says("backlash", to) == Says::nothing);
    for (const auto to : {Simulator::urdf, Simulator::sdf})
        CHECK(says("backlash", to) == Says::part);  // without spring
    for (const auto to : {Simulator::urdf, Simulator::sdf, Simulator::isaaclab, Simulator::ros2_control})
        CHECK(says("compliance", to) == Says::nothing);
    CHECK(says("stribeck", Simulator::mjcf) == Says::nothing);
    CHECK(says("stribeck", Simulator::isaaclab) == Says::part);  // its friction at rest, not the speed
    CHECK(says("delay", Simulator::isaaclab) == Says::part);     // of the target, not of the feedback
    for (const auto to : {Simulator::mjcf, Simulator::urdf, Simulator::sdf, Simulator::ros2_control})
        CHECK(says("delay", to) == Says::nothing);
    CHECK(says("gain-k_i", Simulator::mjcf) == Says::nothing);
    CHECK(says("gain-k_i", Simulator::ros2_control) == Says::all);
    for (const char* effect :
         {"constant-load", "cogging", "asymmetric-friction", "presliding", "actuator-lag", "velocity-filter",
          "quantisation", "sensor-offset", "periodic-disturbance", "load-dependent-friction", "friction-drift"})
        for (const auto& simulator : simulators) {
            INFO(effect << " " << simulator.name);
            CHECK(says(effect, simulator.value) == Says::nothing);
        }
}

TEST_CASE("export: a simulator holds nothing of an effect where no element follows its size")
{
    ExportOptions options;
    options.timestep = 1e-3;  // MJCF states one, which follows what the joint needs
    for (const auto& effect : gap::effects()) {
        const auto targets = targets_of(effect);
        const EffectEdit edit = usual_edit(effect);
        for (const auto& simulator : simulators) {
            INFO(effect.name << " in " << simulator.name);
            const auto elements = [&](const Joint& joint) {
                return without_comments(simulator_text(export_joint(joint, simulator.value, options), "elbow"));
            };
            const bool follows = elements(edit.edited) != elements(edit.larger);
            CHECK(follows == (targets[static_cast<std::size_t>(simulator.value)].says != EffectTarget::Says::nothing));
        }
    }
}

TEST_CASE("export: a motor that two hinges keep apart from the link is not joined to it")
{
    Joint joint = starting_joint(Model::two_mass, "coulomb-viscous", Motion::revolute);
    const auto joined = [&](Simulator to) {
        const auto lost = export_joint(joint, to).not_expressible;
        return std::ranges::any_of(lost, [](const NotExpressible& n) { return n.key == "joint.motor_inertia"; });
    };
    for (const auto to : {Simulator::urdf, Simulator::sdf}) CHECK(joined(to));
    joint.mechanism.transmission.backlash = 0.01;
    for (const auto to : {Simulator::urdf, Simulator::sdf}) CHECK_FALSE(joined(to));
}

TEST_CASE("export: Isaac Lab's targets arrive late by the dead time")
{
    Joint joint = damped();
    const Record record = record_of(joint);
    const auto run_of = [&](const Joint& of) {
        ExportOptions options;
        options.timestep = 1e-3;
        return run_in_simulator(export_joint(of, Simulator::isaaclab, options), record, 1).position;
    };
    const auto prompt = run_of(joint);
    joint.control.delay = 0.1;
    const auto late = run_of(joint);
    // from where the loop has forgotten its start: its slow time constant is k_v/k_p = 0.06 s
    for (std::size_t k = 1200; k < late.size(); k += 500) CHECK(late[k] == Approx(prompt[k - 100]).margin(1e-9));
}
