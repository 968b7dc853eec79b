#include "analysis/gap/effects/catalogue.h"

namespace stickslip::gap
{

Effect saturation()
{
    Effect e;
    e.name = "saturation";
    e.stage = "actuator";
    e.form = "clip(u)";
    e.source = "Hippe 2006";
    e.signature = "only at the limit";
    e.confusable = {"supply-sag"};
    {
        EffectForm f;
        f.parameters = {
            {"limit", Quantity::effort, Scale::effort, true, 0.05, 10, 2, "true limit of the effort"},
        };
        f.apply = [](Joint& j, const double* p) { j.actuator.limit = p[0]; };
        f.seeds = {{4}, {3}, {2.5}, {2}, {1.5}, {1.1}, {0.8}};
        f.rough = true;
        e.forms.push_back(f);
    }
    return e;
}

}  // namespace stickslip::gap
