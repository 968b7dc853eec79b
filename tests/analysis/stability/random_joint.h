// Random joints of every law, model and control, each from its number alone, and what contradicts itself in the linear
// answers about one of them.
#pragma once
#include "analysis/joint/parameters.h"
#include "analysis/loop/loop_use.h"
#include "analysis/stability/characteristic.h"
#include "analysis/stability/joint_spectrum.h"
#include "analysis/stability/linear_joint.h"
#include "analysis/stability/verdict.h"
#include "analysis/stability/winding.h"
#include "tests/analysis/joint/sample_joints.h"

#include <cmath>
#include <cstdint>
#include <random>
#include <string>

namespace stickslip::samples {

/// A loop that is sampled or late, filters or lags, in any combination.
inline void make_real(Joint& joint, std::mt19937_64& random)
{
    auto& control = joint.control;
    if (random() % 2) {
        control.period = 1e-3;
        control.velocity_estimate.form = EstimateForm::backward_difference;
    }
    if (random() % 2) control.delay = 2e-3;
    if (random() % 2) control.velocity_estimate.tau = 1e-3;
    if (random() % 2) joint.actuator.lag = 1e-3;
    if (random() % 2) joint.sensor.position_scale = 1.01;
}

/// A friction law of the samples, every number of it drawn anew within a decade to either side.
inline Joint random_joint(std::uint64_t number)
{
    std::mt19937_64 random(0x5eed0000 + number);
    const auto all = laws();
    const auto law = [&] { return all[random() % all.size()].law; };
    constexpr Model models[] = {Model::single_mass, Model::two_mass, Model::three_mass, Model::lever};
    const Model model = models[random() % 4];
    Joint joint = model == Model::single_mass ? single_mass(1) : model == Model::two_mass ? two_mass() : three_mass();
    joint.mechanism.model = model;
    if (model == Model::lever) joint.mechanism.lever_arm = 0.3;
    joint.friction.law = law();
    joint.frictions.motor.law = law();
    joint.frictions.transmission.law = law();
    joint.frictions.link.law = law();
    auto& control = joint.control;
    control.kind = random() % 2 ? ControlKind::position : ControlKind::force;
    control.feedback = random() % 2 ? Feedback::motor : Feedback::link;
    control.k_v = random() % 2 ? 0 : 100;
    control.contact_stiffness = random() % 3 ? 0 : 1e3;
    if (control.kind == ControlKind::force && random() % 2) {
        control.force_rate = 20;
        control.V0 = not_set;
    }
    const bool real = random() % 4 == 0;
    if (real) make_real(joint, random);
    std::uniform_real_distribution<double> decades(-1, 1);
    for (const Parameter& leaf : parameters(joint)) {
        if (!std::isfinite(*leaf.value) || *leaf.value == 0) continue;
        const double before = *leaf.value;
        *leaf.value *= std::pow(10, decades(random));
        if (!check(joint).empty()) *leaf.value = before;  // as a static friction below the kinetic
    }
    if (!real) joint.actuator = {}, joint.sensor = {};
    // a joint slides backward by the sign of what it is told to do
    if (random() % 4 == 0) (is_set(control.force_rate) ? control.force_rate : control.V0) *= -1;
    return joint;
}

/// |F(s)| per the product of the sizes of its rows, or the step of Newton's method per |s| where that is less: next to
/// a pole of G the rounding of s alone is worth more than any residual. 0 on a pole: the decay of a state that the
/// motion does not notice is an eigenvalue, and no root of F.
inline double residual(const LinearJoint& j, std::complex<double> s)
{
    for (int i = 0; i < j.bodies; ++i)
        for (int k = 0; k < j.friction[i].states; ++k)
            if (std::abs(s - j.friction[i].lambda[k]) < 1e-9 * std::abs(s)) return 0;
    // a determinant is at most the product of the lengths of its rows
    std::array<Complex, max_bodies> resistance, scale;
    double terms = 1;
    for (int i = 0; i < j.bodies; ++i) {
        const Complex G = transfer(j.friction[i], s);
        resistance[i] = j.friction[i].f_v - G, scale[i] = 1;
        double row = std::abs(j.inertia[i] * s * s) + std::abs(s) * (std::abs(j.friction[i].f_v) + std::abs(G)) +
                     std::abs(j.actuated[i]) * (std::abs(j.k_p) + std::abs(j.k_v * s));
        for (int k = 0; k < j.bodies; ++k) row += std::abs(j.stiffness_at(i, k)) + std::abs(j.damping_at(i, k) * s);
        terms *= row;
    }
    const auto F = closed_loop(j, s);
    return std::min(std::abs(F.value) / terms, std::abs(F.value / F.slope) / std::abs(s));
}

/// What contradicts itself, in words; empty where all agree. `counted`: also by the argument principle.
inline std::string contradiction(const Joint& joint)
{
    const auto verdict = linear_verdict(joint);
    const auto& memory = verdict.state_variable;
    if (verdict.steady.reason != Reason::none)
        return std::isnan(growth_rate(joint)) || verdict.steady.reason == Reason::not_finite ? ""
                                                                                             : "growth without verdict";
    const auto linear = linear_joint(joint, verdict.steady.slides_at);
    const double abscissa = memory.spectral_abscissa;
    if (memory.stable != (abscissa < 0) || memory.neutral != (abscissa == 0)) return "verdict and abscissa";
    const double growth = growth_rate(joint);
    if (std::abs(growth - abscissa) > 1e-7 * std::abs(abscissa) + 1e-12) return "growth rate and abscissa";
    if (memory.eigenvalues.empty()) return "no eigenvalues";
    const auto first = memory.eigenvalues.front();
    double size = 0;  // of the fastest: a slow root has the rounding of its size
    for (const auto& s : memory.eigenvalues) size = std::max(size, std::abs(s));
    if (std::abs(first.real() - abscissa) > 1e-7 * std::abs(first) + 1e-14 * size)
        return "abscissa and list of eigenvalues";
    // the characteristic function below is that of the ideal loop: real loops have monodromy_test and real_loop_test
    const bool ideal = loop_kind(joint) == LoopKind::ideal;
    for (const auto& s : memory.eigenvalues)
        if (ideal && std::abs(s) > 0 && !(residual(linear, s) < 1e-8)) return "an eigenvalue is no root";
    const auto beyond = roots_right_of(linear, abscissa + 1e-6 * std::abs(first));
    if (ideal && beyond && *beyond != 0) return "a root right of the abscissa";
    const double k_p = joint.control.k_p;
    bool within = false;
    for (const auto& i : memory.stable_intervals) within = within || (k_p > i.low && k_p < i.high);
    if (!memory.neutral && k_p < memory.searched_to && within != memory.stable) return "verdict and stable gains";
    const auto point = linear_point(joint);
    if ((point.state_variable_stable == 1) != memory.stable) return "verdict and row of a sweep";
    if (std::isnan(point.k_cr) != std::isnan(memory.k_cr)) return "critical gain and row of a sweep";
    // a sample of other gains, the whole joint turned to each
    Joint turned = joint;
    for (const double factor : {0.03, 0.4, 2.5, 40.0}) {
        turned.control.k_p = factor * k_p;
        if (turned.control.k_p < memory.searched_from || turned.control.k_p > memory.searched_to) continue;
        const double there = growth_rate(turned);
        if (!std::isfinite(there) || there == 0) continue;
        bool stable = false, at_an_end = false;
        for (const auto& i : memory.stable_intervals) {
            stable = stable || (turned.control.k_p > i.low && turned.control.k_p < i.high);
            for (const double end : {i.low, i.high})
                at_an_end = at_an_end || std::abs(turned.control.k_p - end) < 1e-6 * end;
        }
        if (!at_an_end && stable != (there < 0)) return "another gain and stable gains";
    }
    return "";
}

}  // namespace stickslip::samples
