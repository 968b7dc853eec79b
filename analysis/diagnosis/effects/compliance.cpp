#include "analysis/diagnosis/effects/catalogue.h"

#include <cmath>

namespace stickslip::gap {
namespace {

/// The cubic part is as large as the linear one where that gives this effort.
void harden(Transmission& spring, double effort)
{
    spring.cubic_stiffness = std::pow(spring.stiffness, 3) / (effort * effort);
}

/// Of a joint documented as one mass.
void add_divided_mass(Effect& e)
{
    EffectForm f;
    f.name = "divided-mass";
    f.divides = true;
    f.parameters = {
        {"motor_share", Quantity::number, Scale::one, false, 0.02, 0.98, 0.5, "share of the inertia on the motor side"},
        {"stiffness", Quantity::stiffness, Scale::stiffness, true, 0.3, 1e6, 100, "transmission stiffness"},
        {"link_friction", Quantity::number, Scale::one, false, 0, 1, 0.3, "share of the friction on the link side"},
        {"damping_ratio", Quantity::number, Scale::one, true, 1e-3, 2, 0.05, "damping ratio of the divided mass"},
    };
    f.parameters[1].size = true;
    f.apply = [](Joint& j, const double* p) { divide_mass(j, p[0], p[1], p[3], p[2]); };
    for (double stiffness : {4.0, 10.0, 30.0, 100.0, 300.0, 1000.0, 5000.0})
        for (double motor : {0.3, 0.65})
            for (double link_friction : {0.05, 0.8}) f.seeds.push_back({motor, stiffness, link_friction, 0.05});
    // so stiff a spring that nothing moves misses by less than a soft one that rings at another frequency
    f.apart = 1;
    f.applies = is_single_mass;
    e.forms.push_back(f);
    // strain wave gears harden; a linear spring has then no stiffness that fits small and large deflections
    EffectForm hardening = f;
    hardening.name = "divided-mass-hardening";
    hardening.parameters.push_back({"hardening_effort", Quantity::effort, Scale::effort, true, 0.02, 100, 1,
                                    "effort of the linear part at which the cubic part is as large"});
    hardening.apply = [](Joint& j, const double* p) {
        divide_mass(j, p[0], p[1], p[3], p[2]);
        harden(j.mechanism.transmission, p[4]);
    };
    hardening.seeds.clear();
    for (double stiffness : {4.0, 20.0, 100.0, 1000.0})
        for (double motor : {0.3, 0.65})
            for (double link_friction : {0.05, 0.8})
                for (double effort : {0.1, 0.4, 1.5})
                    hardening.seeds.push_back({motor, stiffness, link_friction, 0.05, effort});
    e.forms.push_back(hardening);
    // a peak comes from a seal or a gear, which may be all on the motor's side
    f.name = "divided-mass-peak-on-motor";
    f.apply = [](Joint& j, const double* p) {
        const double peak = stribeck_peak(j.friction);
        divide_mass(j, p[0], p[1], p[3], p[2]);
        set_stribeck_peak(j.frictions.motor, peak);
        set_stribeck_peak(j.frictions.link, 0);
    };
    f.applies = [](const Joint& j) { return is_single_mass(j) && stribeck_peak(j.friction) != 0; };
    e.forms.push_back(f);
    // the encoder of a joint documented as one mass may sit behind the spring
    f.name = "divided-mass-encoder-on-link";
    f.encoder_on_link = true;
    f.apply = [](Joint& j, const double* p) {
        divide_mass(j, p[0], p[1], p[3], p[2]);
        j.control.feedback = Feedback::link;
    };
    f.applies = is_single_mass;
    e.forms.push_back(f);
}

/// Of a joint whose spring is documented.
void add_two_mass(Effect& e)
{
    EffectForm f;
    f.name = "two-mass";
    f.parameters = {
        factor_on_number(0.01, 100, 0.5, "true stiffness per nominal", "stiffness_factor"),
        factor_on_number(0.01, 100, 1, "true damping per nominal", "damping_factor"),
    };
    f.parameters[0].size = true;
    f.apply = [](Joint& j, const double* p) {
        j.mechanism.transmission.stiffness *= p[0];
        j.mechanism.transmission.damping *= p[1];
    };
    f.seeds = {{0.7, 1}, {1.4, 1}, {0.3, 1}};
    f.applies = is_two_mass;
    e.forms.push_back(f);
    f.name = "two-mass-hardening";
    f.parameters.push_back({"hardening_effort", Quantity::effort, Scale::load_effort, true, 0.02, 100, 1,
                            "effort of the linear part at which the cubic part is as large"});
    f.apply = [](Joint& j, const double* p) {
        j.mechanism.transmission.stiffness *= p[0];
        j.mechanism.transmission.damping *= p[1];
        harden(j.mechanism.transmission, p[2]);
    };
    f.seeds = {{0.7, 1, 1}, {1, 1, 1}, {0.3, 1, 0.3}};
    e.forms.push_back(f);
}

}  // namespace

Effect compliance()
{
    Effect e;
    e.name = "compliance";
    e.stage = Stage::mechanism;
    e.of_transmission = true;
    e.form = "two inertias, stiffness, damping";
    e.source = "Spong 1987";
    e.confusable = {"delay", "presliding", "backlash"};
    add_divided_mass(e);
    add_two_mass(e);
    return e;
}

}  // namespace stickslip::gap
