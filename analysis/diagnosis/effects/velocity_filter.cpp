#include "analysis/diagnosis/effects/catalogue.h"

namespace stickslip::gap {

Effect velocity_filter()
{
    Effect e;
    e.name = "velocity-filter";
    e.stage = Stage::controller;
    e.in_command = true;
    e.form = "first-order filter on the k_v path";
    e.source = "Franklin, Powell and Workman 1998";
    e.confusable = {"delay"};
    {
        EffectForm f;
        f.parameters = {
            {"tau", Quantity::time, Scale::tick, true, 0.05, 200, 3, "true time constant of the velocity filter"},
        };
        f.apply = [](Joint& j, const double* p) { j.control.velocity_estimate.tau = p[0]; };
        f.seeds = {{1}, {10}};
        f.applies = [](const Joint& j) { return j.control.k_v != 0; };
        e.forms.push_back(f);
    }
    return e;
}

}  // namespace stickslip::gap
