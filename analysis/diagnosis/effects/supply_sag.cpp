#include "analysis/diagnosis/effects/catalogue.h"

namespace stickslip::gap {

Effect supply_sag()
{
    Effect e;
    e.name = "supply-sag";
    e.stage = Stage::actuator;
    e.form = "V_0 - R_b i";
    e.source = "Hughes and Drury 2013";
    e.confusable = {"saturation", "effort-gain"};
    {
        EffectForm f;
        f.name = "motor";
        f.parameters = {
            {"resistance", Quantity::resistance, Scale::one, true, 0.001, 50, 0.3, "source resistance of the supply"},
        };
        f.apply = [](Joint& j, const double* p) { j.actuator.supply_resistance += p[0]; };
        f.seeds = {{0.05}, {0.5}};
        f.applies = [](const Joint& j) { return j.actuator.kind == ActuatorKind::dc_motor; };
        e.forms.push_back(f);
    }
    {
        EffectForm f;
        f.name = "effort";
        f.parameters = {
            {"sag_effort", Quantity::effort, Scale::effort, true, 1.5, 3000, 30,
             "effort whose current would pull the supply down to nothing"},
        };
        f.apply = [](Joint& j, const double* p) { j.actuator.sag_effort = p[0]; };
        f.seeds = {{40}, {8}};
        f.applies = [](const Joint& j) { return j.actuator.kind == ActuatorKind::effort; };
        e.forms.push_back(f);
    }
    return e;
}

}  // namespace stickslip::gap
