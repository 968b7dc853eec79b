#include "analysis/diagnosis/effects/catalogue.h"

namespace stickslip::gap {

Effect friction_drift()
{
    Effect e;
    e.name = "friction-drift";
    e.stage = Stage::friction;
    e.form = "Coulomb level warms up with time";
    e.source = "Armstrong-Helouvry 1991";
    e.confusable = {"coulomb-level"};
    {
        EffectForm f;
        f.name = "from-document";
        f.parameters = {
            {"change", Quantity::effort, Scale::friction_effort, false, -3, 3, 0.2,
             "final change of the Coulomb level"},
            {"time_constant", Quantity::time, Scale::duration, true, 0.02, 10, 0.5, "time constant"},
        };
        f.apply = [](Joint& j, const double* p) { main_friction(j).drift = {p[0], p[1]}; };
        f.seeds = {{0.05, 0.3}, {-0.05, 0.3}};
        e.forms.push_back(f);
    }
    {
        // a joint that was described warm and is started cold
        EffectForm f;
        f.name = "to-document";
        f.parameters = {
            {"excess", Quantity::effort, Scale::friction_effort, false, -3, 3, 0.2,
             "Coulomb level at the start beyond the documented one, which it comes to"},
            {"time_constant", Quantity::time, Scale::duration, true, 0.02, 10, 0.5, "time constant"},
        };
        f.apply = [](Joint& j, const double* p) {
            shift_coulomb(main_friction(j), p[0]);
            main_friction(j).drift = {-p[0], p[1]};
        };
        f.seeds = {{0.05, 0.3}, {-0.05, 0.3}};
        e.forms.push_back(f);
    }
    return e;
}

}  // namespace stickslip::gap
