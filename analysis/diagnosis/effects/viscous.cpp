#include "analysis/diagnosis/effects/catalogue.h"

namespace stickslip::gap {

Effect viscous()
{
    Effect e;
    e.name = "viscous";
    e.stage = "friction";
    e.form = "F_v v";
    e.source = "Reynolds 1886";
    e.signature = "linear in velocity";
    e.confusable = {"actuator-lag", "effort-gain"};
    {
        EffectForm f;
        f.parameters = {
            {"change", Quantity::damping, Scale::friction_damping, false, -5, 5, 0.2, "change of the viscous slope"},
        };
        f.parameters[0].vanishes = true;
        f.apply = [](Joint& j, const double* p) { shift_viscous(main_friction(j), p[0]); };
        f.seeds = {{0.1}, {-0.1}};
        e.forms.push_back(f);
    }
    return e;
}

}  // namespace stickslip::gap
