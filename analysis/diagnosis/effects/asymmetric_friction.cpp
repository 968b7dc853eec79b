#include "analysis/diagnosis/effects/catalogue.h"

namespace stickslip::gap {
namespace {

/// Half of the change in the mean, half of it in the difference, which has the sign of the direction.
void change_one_direction(Friction& friction, double signed_half, const double* p)
{
    shift_coulomb(friction, 0.5 * p[0]);
    shift_viscous(friction, 0.5 * p[1]);
    friction.asymmetry.coulomb += signed_half * p[0];
    friction.asymmetry.viscous += signed_half * p[1];
}

}  // namespace

Effect asymmetric_friction()
{
    Effect e;
    e.name = "asymmetric-friction";
    e.stage = "friction";
    e.form = "F_c and F_v differ by direction";
    e.source = "Janot, Gautier and Brunot 2019";
    e.signature = "friction differs between the directions";
    e.confusable = {"constant-load", "viscous"};
    {
        EffectForm f;
        f.name = "about-the-mean";
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
        e.forms.push_back(f);
    }
    {
        // the other direction is as documented: the mean changes, too
        EffectForm f;
        f.name = "positive-direction";
        f.parameters = {
            {"coulomb_change", Quantity::effort, Scale::friction_effort, false, -3, 3, 0.2,
             "change of the Coulomb level in this direction"},
            {"viscous_change", Quantity::damping, Scale::friction_damping, false, -3, 3, 0.2,
             "change of the viscous slope in this direction"},
        };
        f.apply = [](Joint& j, const double* p) { change_one_direction(main_friction(j), 0.5, p); };
        f.seeds = {{0, 0}};
        e.forms.push_back(f);
        f.name = "negative-direction";
        f.apply = [](Joint& j, const double* p) { change_one_direction(main_friction(j), -0.5, p); };
        e.forms.push_back(f);
    }
    return e;
}

}  // namespace stickslip::gap
