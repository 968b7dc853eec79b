#include "analysis/diagnosis/effects/catalogue.h"

namespace stickslip::gap {

Effect inertia()
{
    Effect e;
    e.name = "inertia";
    e.stage = Stage::mechanism;
    e.form = "dJ a";
    e.source = "Newton 1687";
    e.confusable = {"effort-gain", "sensor-offset"};
    {
        EffectForm f;
        f.parameters = {
            factor_on_number(0.1, 10, 0.3, "true inertia per nominal inertia"),
        };
        f.apply = [](Joint& j, const double* p) { j.mechanism.inertia *= p[0]; };
        f.seeds = {{1.05}, {0.95}};
        f.applies = is_single_mass;
        e.forms.push_back(f);
    }
    {
        EffectForm f;
        f.name = "link";
        f.own_number = true;
        f.parameters = {
            factor_on_number(0.1, 10, 0.3, "true link inertia per nominal"),
        };
        f.apply = [](Joint& j, const double* p) { j.mechanism.link_inertia *= p[0]; };
        f.seeds = {{1.05}, {0.95}};
        f.applies = is_two_mass;
        e.forms.push_back(f);
    }
    {
        EffectForm f;
        f.name = "motor";
        f.own_number = true;
        f.parameters = {
            factor_on_number(0.1, 10, 0.3, "true motor inertia per nominal"),
        };
        f.apply = [](Joint& j, const double* p) { j.mechanism.motor_inertia *= p[0]; };
        f.seeds = {{1.05}, {0.95}};
        f.applies = is_two_mass;
        e.forms.push_back(f);
    }
    return e;
}

}  // namespace stickslip::gap
