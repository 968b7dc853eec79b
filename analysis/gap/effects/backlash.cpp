#include "analysis/gap/effects/catalogue.h"

namespace stickslip::gap
{

Effect backlash()
{
    Effect e;
    e.name = "backlash";
    e.stage = "mechanism";
    e.form = "play between motor and link";
    e.source = "Nordin and Gutman 2002";
    e.signature = "flat gap and impact at reversal";
    e.confusable = {"presliding", "compliance"};
    {
        EffectForm f;
        f.name = "motor-friction";
        f.parameters = {
            {"width", Quantity::position, Scale::position, true, 1e-05, 0.5, 0.01, "total play"},
            {"motor_share", Quantity::number, Scale::one, true, 0.02, 0.98, 0.5,
             "share of the inertia on the motor side"},
            {"stiffness", Quantity::stiffness, Scale::stiffness, true, 0.3, 1000000.0, 100, "transmission stiffness"},
        };
        f.apply = [](Joint& j, const double* p) {
            divide_mass(j, p[1], p[2], 0.1, false);
            j.mechanism.transmission.backlash = p[0];
        };
        f.seeds = {{0.002, 0.3, 3000}, {0.002, 0.6, 3000}, {0.01, 0.3, 3000},
                   {0.01, 0.6, 3000},  {0.04, 0.3, 3000},  {0.04, 0.6, 3000}};
        f.applies = is_single_mass;
        f.rough = true;
        e.forms.push_back(f);
    }
    {
        EffectForm f;
        f.name = "link-friction";
        f.parameters = {
            {"width", Quantity::position, Scale::position, true, 1e-05, 0.5, 0.01, "total play"},
            {"motor_share", Quantity::number, Scale::one, true, 0.02, 0.98, 0.5,
             "share of the inertia on the motor side"},
            {"stiffness", Quantity::stiffness, Scale::stiffness, true, 0.3, 1000000.0, 100, "transmission stiffness"},
        };
        f.apply = [](Joint& j, const double* p) {
            divide_mass(j, p[1], p[2], 0.1, true);
            j.mechanism.transmission.backlash = p[0];
        };
        f.seeds = {{0.002, 0.3, 3000}, {0.01, 0.3, 3000}, {0.04, 0.3, 3000}};
        f.applies = is_single_mass;
        f.rough = true;
        e.forms.push_back(f);
    }
    {
        EffectForm f;
        f.name = "two-mass";
        f.parameters = {
            {"width", Quantity::position, Scale::position, true, 1e-05, 0.5, 0.01, "total play"},
        };
        f.apply = [](Joint& j, const double* p) { j.mechanism.transmission.backlash = p[0]; };
        f.seeds = {{0.0005}, {0.002}, {0.005}, {0.015}, {0.04}, {0.1}};
        f.applies = is_two_mass;
        f.rough = true;
        e.forms.push_back(f);
    }
    return e;
}

}  // namespace stickslip::gap
