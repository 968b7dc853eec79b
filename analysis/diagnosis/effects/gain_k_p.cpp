#include "analysis/diagnosis/effects/catalogue.h"
#include "analysis/joint/gains.h"

namespace stickslip::gap {

Effect gain_k_p()
{
    Effect e;
    e.name = "gain-k_p";
    e.stage = Stage::controller;
    e.in_command = true;
    e.form = "(1 + epsilon) k_p, in a cascade K_pos";
    e.source = "Franklin, Powell and Workman 1998";
    e.confusable = {"effort-gain"};
    {
        EffectForm f;
        f.parameters = {
            factor_on_number(0.1, 10, 0.2, "true gain per nominal"),
        };
        f.apply = [](Joint& j, const double* p) { stated_position_gain(j.control) *= p[0]; };
        f.seeds = {{1.03}, {0.97}};
        e.forms.push_back(f);
    }
    return e;
}

}  // namespace stickslip::gap
