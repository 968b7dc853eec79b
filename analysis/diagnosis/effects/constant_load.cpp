#include "analysis/diagnosis/effects/catalogue.h"

namespace stickslip::gap {

Effect constant_load()
{
    Effect e;
    e.name = "constant-load";
    e.stage = Stage::mechanism;
    e.form = "offset";
    e.source = "d'Alembert 1743";
    e.confusable = {"asymmetric-friction", "gravity"};
    {
        EffectForm f;
        f.parameters = {
            {"force", Quantity::effort, Scale::load_effort, false, -3, 3, 0.2, "additional constant load"},
        };
        f.apply = [](Joint& j, const double* p) { j.load.constant += p[0]; };
        f.seeds = {{0}};
        e.forms.push_back(f);
    }
    return e;
}

}  // namespace stickslip::gap
