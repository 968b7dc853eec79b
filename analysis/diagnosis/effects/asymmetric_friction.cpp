#include "analysis/diagnosis/effects/catalogue.h"

namespace stickslip::gap {

Effect asymmetric_friction()
{
    Effect e;
    e.name = "asymmetric-friction";
    e.stage = Stage::friction;
    e.form = "F_c and F_v differ by direction";
    e.source = "Janot, Gautier and Brunot 2019";
    e.confusable = {"constant-load", "viscous"};
    {
        EffectForm f;
        f.parameters = {
            {"coulomb", Quantity::effort, Scale::friction_effort, false, -2, 2, 0.1,
             "half the Coulomb difference between + and -"},
            {"viscous", Quantity::damping, Scale::friction_damping, false, -3, 3, 0.1,
             "half the viscous difference between + and -"},
        };
        f.apply = [](Joint& j, const double* p) {
            main_friction(j).asymmetry.coulomb += p[0];
            main_friction(j).asymmetry.viscous += p[1];
        };
        f.seeds = {{0, 0}};
        f.same_motion = {"constant-load"};
        e.forms.push_back(f);
    }
    return e;
}

}  // namespace stickslip::gap
