#include "analysis/diagnosis/effects/catalogue.h"
#include "analysis/joint/gains.h"

namespace stickslip::gap {

Effect gain_k_v()
{
    Effect e;
    e.name = "gain-k_v";
    e.stage = Stage::controller;
    e.in_command = true;
    e.form = "(1 + epsilon) k_v, in a cascade K_v";
    e.source = "Franklin, Powell and Workman 1998";
    e.confusable = {"viscous"};
    {
        EffectForm f;
        f.parameters = {
            factor_on_number(0.1, 10, 0.2, "true gain per nominal"),
        };
        f.apply = [](Joint& j, const double* p) { stated_velocity_gain(j.control) *= p[0]; };
        f.seeds = {{1.03}, {0.97}};
        f.applies = [](const Joint& j) { return gains_of(j.control).k_v != 0; };
        e.forms.push_back(f);
    }
    return e;
}

}  // namespace stickslip::gap
