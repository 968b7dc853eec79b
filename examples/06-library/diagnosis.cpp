// A record of a joint that carries an undocumented load, and what the diagnosis makes of it.
#include <stickslip/diagnosis.h>
#include <stickslip/loop_record.h>

#include <cmath>
#include <cstdio>

#include "threads.h"

int main()
{
    stickslip::CoulombViscous friction;
    friction.coulomb = 0.3;   // N·m
    friction.viscous = 0.05;  // N·m·s/rad

    stickslip::Joint joint;
    joint.mechanism.motion = stickslip::Motion::revolute;
    joint.mechanism.inertia = 0.05;  // kg·m²
    joint.friction.law = friction;
    joint.control.k_p = 20;       // N·m/rad
    joint.control.k_v = 0.5;      // N·m·s/rad
    joint.control.period = 1e-3;  // s
    joint.control.velocity_estimate.form = stickslip::EstimateForm::backward_difference;
    joint.sensor.position_noise = 1e-6;  // rad

    stickslip::ReferenceMotion reference;
    for (int i = 0; i < 3000; ++i) {
        const double t = 1e-3 * i;
        reference.time.push_back(t);
        reference.position.push_back(t < 2 ? 0.5 * (1 - std::cos(2 * M_PI * t)) : 0);
    }
    auto real = joint;
    real.load.constant = 0.2;  // N·m
    const auto seen = stickslip::record_along(real, reference, 1);

    stickslip::Record record;
    record.name = "one";
    record.time = seen.time;
    record.reference_position = seen.reference_position;
    record.reference_velocity = seen.reference_velocity;
    record.position = seen.position;
    record.effort_command = seen.effort_command;

    const auto found = stickslip::gap::diagnose(joint, {record}, side_by_side).diagnosis;
    std::printf("%s\n", name_of(found.verdict).c_str());
    for (const auto& cause : found.effects) {
        std::printf("%-20s %.3f", cause.names[0].c_str(), cause.probability);
        for (const auto& p : cause.parameters) std::printf("  %s = %.4g %s", p.name.c_str(), p.value, p.unit.c_str());
        std::printf("\n");
    }
}
