#include "analysis/diagnosis/effects/catalogue.h"

namespace stickslip::gap {

Effect saturation()
{
    Effect e;
    e.name = "saturation";
    e.stage = Stage::actuator;
    e.form = "clip(u)";
    e.source = "Hippe 2006";
    e.confusable = {"supply-sag"};
    {
        EffectForm f;
        f.parameters = {
            {"limit", Quantity::effort, Scale::peak_effort, true, 0.02, 2, 0.7,
             "true limit of the effort that arrives"},
        };
        f.apply = [](Joint& j, const double* p) { j.actuator.limit = p[0]; };
        f.seeds = {{0.97}, {0.9}, {0.8}, {0.7}, {0.6}, {0.5}, {0.4}, {0.3}, {0.2}};
        f.rough = true;
        e.forms.push_back(f);
    }
    return e;
}

}  // namespace stickslip::gap
