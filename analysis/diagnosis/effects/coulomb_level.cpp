#include "analysis/diagnosis/effects/catalogue.h"

namespace stickslip::gap {

Effect coulomb_level()
{
    Effect e;
    e.name = "coulomb-level";
    e.stage = Stage::friction;
    e.form = "F_c sgn v";
    e.source = "Coulomb 1785";
    e.confusable = {"constant-load", "asymmetric-friction", "load-dependent-friction"};
    {
        EffectForm f;
        f.parameters = {
            {"change", Quantity::effort, Scale::friction_effort, false, -2, 2, 0.2, "change of the Coulomb level"},
        };
        f.parameters[0].vanishes = true;
        f.apply = [](Joint& j, const double* p) { shift_coulomb(main_friction(j), p[0]); };
        f.seeds = {{0.1}, {-0.1}};
        e.forms.push_back(f);
        f.name = "link";
        f.own_number = true;
        f.parameters[0].scale = Scale::load_effort;
        f.parameters[0].help = "change of the Coulomb level on the link";
        f.apply = [](Joint& j, const double* p) { shift_coulomb(j.frictions.link, p[0]); };
        f.applies = main_friction_on_motor;
        e.forms.push_back(f);
        f.name = "motor";
        f.parameters[0].scale = Scale::effort;
        f.parameters[0].help = "change of the Coulomb level on the motor";
        f.apply = [](Joint& j, const double* p) { shift_coulomb(j.frictions.motor, p[0]); };
        f.applies = main_friction_on_link;
        e.forms.push_back(f);
    }
    return e;
}

}  // namespace stickslip::gap
